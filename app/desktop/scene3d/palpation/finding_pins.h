// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/scene3d/palpation/finding_flag.h"
#include "desktop/scene3d/plugin/painted_face.h"
#include "desktop/scene3d/plugin/qt3d_parts.h"
#include "desktop/scene3d/plugin/shared_light.h"
#include "desktop/scene3d/scene_state.h"

#include <Qt3DRender/QLayer>
#include <array>

namespace chiron::scene3d {

/// Pins with numbered flags that stand where something was reported. Two draw calls each.
class FindingPins final : public Qt3DCore::QEntity {
public:
    /// `elevation_rad`: of the camera over the plane; the flags face it.
    FindingPins(SharedLight& light, double elevation_rad, Qt3DCore::QNode* parent);

    void change(const SceneSetup& setup);
    void show(const SceneState& state);
    void putTranslucent(Qt3DRender::QLayer* layer);

private:
    struct Pin {
        Qt3DCore::QEntity* root = nullptr;
        Qt3DCore::QTransform* at = nullptr;
        Part* flag = nullptr;
        PaintedFace* face = nullptr;
        FindingFlag shown;
        bool painted = false;
    };

    SceneSetup m_setup;
    Qt3DRender::QParameter* m_stickTint;
    std::array<Pin, core::kMaxFindings> m_pins;
};

} // namespace chiron::scene3d
