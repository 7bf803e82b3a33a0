// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/random.h"
#include "modules/exercises/sphere_apex/simulation/sphere_apex_plan.h"
#include "session/study/live_sitting.h"

#include <vector>

namespace chiron::tests {

/// Where the spheres of a sitting's session lie: `before` trials of the run were stored when it began.
inline std::vector<simulation::SphereApexTrial> apexPlaces(const session::LiveSitting& live,
                                                           std::uint64_t runSeed, std::size_t before) {
    const std::uint64_t seed = core::Random::mix(runSeed, "sitting " + std::to_string(before)) >> 1;
    return simulation::planSphereApexTrials(live.level().parameters.as<simulation::SphereApexParameters>(),
                                            seed);
}

/// Moves a pointer's tool to a place of W.
inline void moveTo(session::LiveSitting& live, const core::Vec3& p_W) {
    const auto& at = live.training().display().latest().tool[0].p_WT_m;
    live.training().pointer()->move(p_W.x() - at[0], p_W.y() - at[1], p_W.z() - at[2]);
}

inline core::Vec3 toolOf(session::LiveSitting& live) {
    const auto& at = live.training().display().latest().tool[0].p_WT_m;
    return {at[0], at[1], at[2]};
}

} // namespace chiron::tests
