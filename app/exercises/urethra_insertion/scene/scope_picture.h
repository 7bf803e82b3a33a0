// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/exercises/urethra_insertion/scene/endoscope_graph.h"
#include "app/exercises/urethra_insertion/scene/thin_lens.h"
#include "app/exercises/urethra_insertion/scene/urethra_model.h"
#include "desktop/scene3d/plugin/qt3d_parts.h"
#include "desktop/scene3d/scene_setup.h"

namespace chiron::scene3d {

/// The view of the camera at the tip of tool 0: the walls in its own light, the black round the picture, and
/// the passes for the depth of field.
class ScopePicture {
public:
    ScopePicture(const UrethraModel& model, EffectShelf& effects, EndoscopeGraph& graph,
                 Qt3DCore::QEntity* root);

    void change(const SceneSetup& setup);
    /// `shown` false: a black picture.
    void show(const ToolView& tool, bool shown);
    /// Side of the square that the picture fills, device pixels.
    void place(int side_px);
    /// The entity at the origin of A that is drawn while the bladder is visible; marks on the bladder's wall
    /// are its children.
    Qt3DCore::QEntity* bladder() const { return m_bladder; }

private:
    Qt3DRender::QMaterial* lining(const char* vertexShader, Qt3DRender::QAbstractTexture* picture,
                                  const QVector3D& pale, const QVector3D& red, float rough, float wet,
                                  const core::Vec3& axis_A);
    void makePasses();
    void aimLens();

    const UrethraModel& m_model;
    EffectShelf& m_effects;
    EndoscopeGraph& m_graph;
    Qt3DCore::QEntity* m_root;
    Qt3DCore::QEntity* m_anatomy;
    Qt3DCore::QEntity* m_bladder; ///< includes the neck; drawn when it can be visible, like the glans
    Qt3DCore::QEntity* m_glans;
    Qt3DRender::QParameter* m_lamp;
    Qt3DRender::QParameter* m_sharpness;
    Qt3DRender::QParameter* m_reach;
    Qt3DRender::QParameter* m_blurred;
    ThinLens m_lens;
    double m_metered_mm = UrethraDrawing::kNear_m * 1e3;
    bool m_depthOfField = false;
    int m_side_px = 2;
};

} // namespace chiron::scene3d
