// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/exercises/sphere_apex/simulation/sphere_apex_plan.h"

#include "core/random.h"
#include "core/units.h"

#include <algorithm>
#include <cmath>

namespace chiron::simulation {

namespace {

/// Draws a point uniformly from a disc: the radius from the square root of a uniform number (equal areas),
/// the angle uniformly.
core::Vec2 uniformInDisc(core::Random& random, double radius_m) {
    const double r = radius_m * std::sqrt(random.uniform());
    const double angle = 2.0 * core::kPi * random.uniform();
    return {r * std::cos(angle), r * std::sin(angle)};
}

} // namespace

std::vector<SphereApexTrial> planSphereApexTrials(const SphereApexParameters& parameters,
                                                  std::uint64_t seed) {
    core::Random centres = core::Random::stream(seed, "sphere_apex.centre");
    core::Random stiffnesses = core::Random::stream(seed, "sphere_apex.stiffness");
    core::Random frictions = core::Random::stream(seed, "sphere_apex.friction");
    core::Random phases = core::Random::stream(seed, "sphere_apex.phase");
    core::Random dimples = core::Random::stream(seed, "sphere_apex.dimple");
    core::Random turns = core::Random::stream(seed, "sphere_apex.turn");
    core::Random grains = core::Random::stream(seed, "sphere_apex.roughness");
    const double discRadius = std::max(
        0.0, std::min(parameters.centreDiscRadius_m, parameters.workspaceRadius_m - parameters.radius_m));

    std::vector<SphereApexTrial> trials(static_cast<std::size_t>(std::max(1, parameters.trials)));
    for (SphereApexTrial& trial : trials) {
        trial.centre_m = uniformInDisc(centres, discRadius);
        trial.stiffness_N_per_m =
            stiffnesses.uniform(parameters.stiffnessLow_N_per_m, parameters.stiffnessHigh_N_per_m);
        trial.friction = frictions.uniform(parameters.frictionLow, parameters.frictionHigh);
        trial.phase_rad.x() = phases.uniform(0.0, 2.0 * core::kPi);
        trial.phase_rad.y() = phases.uniform(0.0, 2.0 * core::kPi);
        const double direction = dimples.uniform(0.0, 2.0 * core::kPi);
        trial.dimpleCentre_m =
            trial.centre_m + parameters.dimpleOffset_m * core::Vec2(std::cos(direction), std::sin(direction));
        trial.turn_rad = turns.uniform(0.0, 2.0 * core::kPi);
        trial.roughnessSeed = grains.next();
    }
    return trials;
}

} // namespace chiron::simulation
