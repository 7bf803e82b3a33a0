// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/exercises/palpation/scene/finding_flag.h"
#include "desktop/scene3d/plugin/painted_face.h"
#include "desktop/scene3d/plugin/qt3d_parts.h"
#include "desktop/scene3d/plugin/shared_light.h"
#include "desktop/scene3d/scene_state.h"
#include "simulation/palpation/tissue_surface.h"

#include <Qt3DRender/QLayer>
#include <array>

namespace chiron::scene3d {

/// Pins with numbered flags at the reported positions, each with the circle within which a lump counts as
/// found by it. Three draw calls per pin.
class FindingPins final : public Qt3DCore::QEntity {
public:
    /// `elevation_rad`: the camera's angle above the plane; the flags face the camera. `reach_m`: the radius
    /// of the circles. `surface` must outlive this object.
    FindingPins(SharedLight& light, double elevation_rad, const simulation::TissueSurface& surface,
                double reach_m, Qt3DCore::QNode* parent);

    void change(const SceneSetup& setup);
    void show(const SceneState& state);
    void putOver(Qt3DRender::QLayer* layer); ///< flags and circles: visible through the hand

private:
    struct Pin {
        Qt3DCore::QEntity* root = nullptr;
        Qt3DCore::QTransform* at = nullptr;
        Part* flag = nullptr;
        Part* reach = nullptr;
        PaintedFace* face = nullptr;
        FindingFlag shown;
        bool painted = false;
    };

    const simulation::TissueSurface& m_surface;
    SceneSetup m_setup;
    Qt3DRender::QParameter* m_stickTint;
    std::array<Pin, simulation::kMaxFindings> m_pins;
};

} // namespace chiron::scene3d
