// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/exercises/palpation/scene/finger_mesh.h"
#include "app/exercises/palpation/scene/finger_pose.h"
#include "desktop/scene3d/plugin/qt3d_parts.h"
#include "desktop/scene3d/plugin/shared_light.h"

#include <Qt3DRender/QLayer>

namespace chiron::scene3d {

/// A gloved finger with the ring of its platform, which leans; a cone on the ring shows direction and amount
/// of the lean. The first finger of a hand also carries the hand. Right and left gloves differ in colour and
/// come from their own side; if there are several fingers, they wear bands. In the air, finger and hand are
/// almost transparent. If the level has a pinch, the first finger of a hand has the two blades of a grasper,
/// drawn while they are open. Draw calls: 2, or 3 for the first finger of a hand, plus 2 with lean, 1 with
/// bands, 1 with the collar, 2 with blades.
class Finger final : public Qt3DCore::QEntity {
public:
    /// `fingers`: number of fingers per hand.
    Finger(SharedLight& light, Qt3DRender::QParameter* skin, int index, int fingers, Qt3DCore::QNode* parent);

    void change(const SceneSetup& setup);
    /// The marking and opacity of a finger.
    struct Look {
        int bands = 0;        ///< number of bands, if there are several fingers
        bool collar = false;  ///< the finger that mouse and keyboard move, if there are several
        double opacity = 1.0; ///< of glove and hand
    };
    void show(const ToolView& tool, const FingerLean& lean, const Look& look);
    /// Puts the glove in the air on a translucent layer.
    void putTranslucent(Qt3DRender::QLayer* layer);
    void hide() { setEnabled(false); }
    /// Draws the cone, the ring of the stop and the blades over the finger, so that it never hides them.
    void putOver(Qt3DRender::QLayer* layer) {
        m_cone->addComponent(layer);
        m_stop->addComponent(layer);
        for (Part* blade : m_blade)
            blade->addComponent(layer);
    }

private:
    /// Finger, right hand and left hand, all with the same material.
    struct Glove {
        Part* finger = nullptr;
        Part* hand[2] = {nullptr, nullptr}; ///< right, left: only for the first finger of a hand
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

/// The finger of the second session, in one translucent colour.
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
