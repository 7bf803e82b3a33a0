// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/units.h"
#include "desktop/scene3d/scene_setup.h"
#include "desktop/scene3d/scene_state.h"
#include "modules/exercises/palpation/cues/palpation_cues.h"
#include "modules/exercises/palpation/simulation/palpation_parameters.h"
#include "simulation/palpation/tissue_surface.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace chiron::scene3d {

/// The inclination of the platform under a finger, as it is drawn.
/// Frame: W.
struct FingerLean {
    /// Unit, in the contact plane, along the lateral tissue force; zero: upright.
    core::Vec3 toward = core::Vec3::Zero();
    double angle_rad = 0.0; ///< of α, limited to the platform's range (30° in all, 20° across
                            ///< the finger)
    bool saturated = false; ///< the force leans farther than the platform can
};

inline constexpr double kMostLean_rad = 30.0 * core::kPi / 180.0; ///< P3
inline constexpr double kMostRoll_rad = 20.0 * core::kPi / 180.0; ///< across the finger (P3)

/// Computes the lean from the cues (the amount, if the level shows it) and the tissue force (the direction).
/// `normal`: of the surface.
inline FingerLean fingerLean(const SceneState& state, std::size_t tool, const core::Vec3& normal) {
    const auto& cues = state.exercise.of<simulation::PalpationCues>();
    FingerLean lean;
    const core::Vec3& force_N = state.tool[tool].force_N;
    const core::Vec3 lateral = force_N - force_N.dot(normal) * normal;
    const double alpha_rad = cues.lean_rad[tool];
    if (!cues.present || !(alpha_rad > 1e-3) || !(lateral.norm() > 1e-6))
        return lean;
    lean.toward = lateral.normalized();
    lean.angle_rad = std::min(alpha_rad, kMostLean_rad);
    const core::Vec3 x_T = state.tool[tool].q_WT * core::Vec3::UnitX();
    // The finger's x axis in the contact plane; the roll is the component of l along it.
    const core::Vec3 across = x_T - x_T.dot(normal) * normal;
    if (across.norm() > 1e-6) {
        const double roll_rad = lean.angle_rad * std::abs(lean.toward.dot(across.normalized()));
        lean.angle_rad *= std::min(1.0, kMostRoll_rad / std::max(roll_rad, 1e-9));
    }
    lean.saturated = (cues.leanSaturated >> tool & 1) != 0;
    return lean;
}

/// True if the finger belongs to a left hand: the second of two hands, or the only hand of a left-handed
/// person.
inline bool isLeftHand(const SceneSetup& setup, std::size_t tool) {
    const auto* palpation = setup.parameters.find<simulation::PalpationParameters>();
    if (!palpation || palpation->hands < 2)
        return setup.leftHanded;
    return static_cast<int>(tool) / std::max(1, palpation->fingers) % 2 == 1;
}

inline constexpr double kDrawnJaw_rad = 0.02; ///< a jaw that is closed further than this is not drawn

/// True if the finger is the first one of a hand that can pinch.
inline bool hasJaw(const SceneSetup& setup, std::size_t tool) {
    const auto* palpation = setup.parameters.find<simulation::PalpationParameters>();
    return palpation && palpation->pinch && static_cast<int>(tool) % std::max(1, palpation->fingers) == 0;
}

inline constexpr double kHoverOpacity = 0.22; ///< opacity of a hand in the air
inline constexpr double kFadesOver_m = 0.003; ///< height above the surface over which the opacity falls to
                                              ///< kHoverOpacity

/// The opacity of the hand of this finger, 0..1. A hand that touches is opaque like a real gloved hand. A
/// hand whose fingers are all in the air is almost transparent, so that the tissue under and beyond it stays
/// visible and the person can see where to go.
inline double gloveOpacity(const SceneSetup& setup, const SceneState& state,
                           const simulation::TissueSurface& surface, std::size_t tool) {
    const auto* palpation = setup.parameters.find<simulation::PalpationParameters>();
    const std::size_t perHand = static_cast<std::size_t>(std::max(1, palpation ? palpation->fingers : 1));
    const std::size_t first = tool / perHand * perHand;
    double height_m = std::numeric_limits<double>::infinity();
    for (std::size_t i = first; i < std::min(first + perHand, state.tool.size()); ++i)
        if (const ToolView& finger = state.tool[i]; finger.present && finger.p_WT.allFinite())
            height_m = std::min(height_m, -surface.nearest(finger.p_WT, finger.p_WT.head<2>()).depth_m);
    return 1.0 - (1.0 - kHoverOpacity) * std::clamp(height_m / kFadesOver_m, 0.0, 1.0);
}

/// Fingers point in from their hand's side: the drawn finger is turned about T's z axis by this angle. The
/// platform is not turned.
inline double fingerYaw_rad(const SceneSetup& setup, std::size_t tool) {
    return (isLeftHand(setup, tool) ? -1.0 : 1.0) * 36.0 * core::kPi / 180.0;
}

} // namespace chiron::scene3d
