// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/exercises/urethra_insertion/scene/endoscope_graph.h"
#include "app/exercises/urethra_insertion/scene/urethra_model.h"
#include "desktop/scene3d/plugin/force_arrow.h"
#include "desktop/scene3d/plugin/shared_light.h"
#include "desktop/scene3d/plugin/yield_marks.h"

namespace chiron::scene3d {

/// The second picture, from outside: the canal and the bladder cut open (the near half is translucent), shaft
/// and tip, the other session's shaft, the force on the tip as an arrow, and in playback the places where the
/// wall gave way.
class Overview {
public:
    Overview(const UrethraModel& model, SharedLight& light, EndoscopeGraph& graph, Qt3DCore::QEntity* root);

    void change(const SceneSetup& setup);
    void show(const SceneState& state);
    void place(const QRect& overview);

private:
    Qt3DRender::QMaterial* shell(const char* look, const char* vertexShader, const QVector4D& tint,
                                 float rule, Blend blend);
    Qt3DCore::QTransform* addScope(bool ghost, Qt3DCore::QEntity* parent);
    void followShaft(const ToolView& tool);
    void showScope(Qt3DCore::QEntity* scope, Qt3DCore::QTransform* pose, const ToolView& tool);

    const UrethraModel& m_model;
    SharedLight& m_light;
    EndoscopeGraph& m_graph;
    Qt3DCore::QEntity* m_root;
    Qt3DCore::QEntity* m_scope;
    Qt3DCore::QEntity* m_ghost;
    Qt3DCore::QTransform* m_pose;
    Qt3DCore::QTransform* m_ghostPose;
    Qt3DRender::QParameter* m_ground;
    Qt3DRender::QParameter* m_tip;
    Qt3DRender::QParameter* m_ahead;
    Qt3DRender::QParameter* m_anchored;
    Qt3DCore::QTransform* m_glans[2];
    Qt3DRender::QParameter* m_ghostTint;
    ForceArrow* m_arrow;
    YieldMarks m_yields;
    bool m_toolShown = true;
};

} // namespace chiron::scene3d
