// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"
#include "modules/exercises/elastic_tube/simulation/elastic_tube_parameters.h"
#include "modules/exercises/elastic_tube/simulation/tube_chain.h"

#include <cstdint>
#include <vector>

namespace chiron::simulation {

/// The values that change from trial to trial.
struct ElasticTubeTrial {
    /// x, y in W of the fixed end, or of the middle of the tube as it lies.
    core::Vec2 base_m = core::Vec2::Zero();
    double stiffness_N_per_m = 100.0;
    double target_N = 1.0; ///< 0 where the task has no target tension
};

/// Plans every trial of a session from its seed, before the first tick. The base is uniform in its disc,
/// stiffness and target tension are uniform in their ranges. Each comes from its own random stream
/// ("elastic_tube.base", ...), so that levels that differ in one of them share the others under the same
/// seed. Pure; allocates.
std::vector<ElasticTubeTrial> planElasticTubeTrials(const ElasticTubeParameters& parameters,
                                                    std::uint64_t seed);

/// The law of one planned trial's tube. Pure.
TubeLaw elasticTubeLaw(const ElasticTubeParameters& parameters, const ElasticTubeTrial& trial) noexcept;
/// The tube of one planned trial, untouched. Pure.
TubeShape elasticTubeShape(const ElasticTubeParameters& parameters, const ElasticTubeTrial& trial) noexcept;
/// The fold over that tube, untouched: a strip that lies over the tube's middle and is drawn back by its free
/// edge (node 1). Pure.
TubeShape tissueFoldShape(const ElasticTubeParameters& parameters, const ElasticTubeTrial& trial) noexcept;

} // namespace chiron::simulation
