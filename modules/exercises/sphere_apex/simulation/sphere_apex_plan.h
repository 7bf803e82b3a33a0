// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"
#include "modules/exercises/sphere_apex/simulation/hemisphere_contact.h"
#include "modules/exercises/sphere_apex/simulation/sphere_apex_parameters.h"

#include <cstdint>
#include <vector>

namespace chiron::simulation {

/// The values that change from trial to trial: the truth that scoring needs and that nobody may see before
/// the debrief.
struct SphereApexTrial {
    core::Vec2 centre_m = core::Vec2::Zero(); ///< of the ball, x and y in W: the apex
    double stiffness_N_per_m = 500.0;
    double friction = 0.0;
    core::Vec2 phase_rad = core::Vec2::Zero();      ///< of the stiffness field g
    core::Vec2 dimpleCentre_m = core::Vec2::Zero(); ///< x and y in W
    /// Rotation of the meshed dome about the vertical, so that its bumps lie elsewhere in each trial.
    double turn_rad = 0.0;
    std::uint64_t roughnessSeed = 1; ///< of the meshed dome
};

/// Plans every trial of a session from its seed, before the first tick. Centres are uniform over the disc of
/// radius min(centreDiscRadius, workspaceRadius − radius) around the workspace centre (W's origin), so that
/// the whole sphere lies inside the workspace. Each quantity has its own random stream ("sphere_apex.centre",
/// ...), so a level that does not vary friction has the same centres as one that does. Pure; allocates.
/// Source: models.md §2.3.
std::vector<SphereApexTrial> planSphereApexTrials(const SphereApexParameters& parameters, std::uint64_t seed);

/// The contact of one planned trial. Pure.
HemisphereContact::Parameters sphereApexContact(const SphereApexParameters& parameters,
                                                const SphereApexTrial& trial) noexcept;

} // namespace chiron::simulation
