// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/exercises/palpation/scene/finger_mesh.h"
#include "app/exercises/palpation/scene/finger_pose.h"
#include "desktop/scene3d/plugin/qt3d_parts.h"
#include "desktop/scene3d/plugin/shared_light.h"

#include <Qt3DRender/QLayer>

namespace chiron::scene3d {

/// A gloved finger, and with a hand's first one the hand behind it, with the ring of its platform, which leans; a cone on the ring says where to and how much. Right and left
/// gloves differ in colour and come from their own side; several fingers wear bands. In the air finger and hand are nearly glass. Where the level has a pinch,
/// a hand's first finger has the two blades of a grasper, drawn while they are open. Draw calls: 2, of a hand's first finger 3, with lean 2 more, bands 1, collar 1, blades 2.
class Finger final : public Qt3DCore::QEntity {
public:
    /// `fingers`: of each hand.
    Finger(SharedLight& light, Qt3DRender::QParameter* skin, int index, int fingers, Qt3DCore::QNode* parent);

    void change(const SceneSetup& setup);
    /// How it is marked and drawn.
    struct Look {
        int bands = 0;        ///< of several fingers
        bool collar = false;  ///< of several fingers
        double opacity = 1.0; ///< of glove and hand
    };
    void show(const ToolView& tool, const FingerLean& lean, const Look& look);
    /// The glove in the air.
    void putTranslucent(Qt3DRender::QLayer* layer);
    void hide() { setEnabled(false); }
    /// The cone, the stop's ring and the blades: never hidden by the finger.
    void putOver(Qt3DRender::QLayer* layer) {
        m_cone->addComponent(layer);
        m_stop->addComponent(layer);
        for (Part* blade : m_blade)
            blade->addComponent(layer);
    }

private:
    /// Finger, right hand and left hand, all of one material.
    struct Glove {
        Part* finger = nullptr;
        Part* hand[2] = {nullptr, nullptr}; ///< right, left: of a hand's first finger
    };
    Glove makeGlove(Qt3DRender::QMaterial* material, int fingers);
    void showGlove(const Glove& glove, bool shown);
    void showPlatform(const ToolView& tool, const FingerLean& lean);
    void showBlades(const ToolView& tool);

    SceneSetup m_setup;
    int m_index;
    Qt3DCore::QTransform* m_pose;
    Qt3DCore::QEntity* m_body;
    Qt3DRender::QParameter* m_pale;
    Qt3DRender::QParameter* m_deep;
    Qt3DRender::QParameter* m_leanTint;
    Qt3DRender::QParameter* m_opacity;
    Glove m_solid;
    Glove m_glass;
    Part* m_bands[core::kMaxTools];
    Part* m_collar;
    Part* m_ring;
    Part* m_stop;
    Part* m_cone;
    Part* m_blade[2];
};

/// The second session's finger: one translucent colour.
class GhostFinger final : public Qt3DCore::QEntity {
public:
    GhostFinger(SharedLight& light, Qt3DCore::QNode* parent);
    void change(const SceneSetup& setup);
    void show(const ToolView& tool);
    void putTranslucent(Qt3DRender::QLayer* layer) { addComponent(layer); }

private:
    SceneSetup m_setup;
    Qt3DCore::QTransform* m_pose;
    Qt3DRender::QParameter* m_tint;
};

} // namespace chiron::scene3d
