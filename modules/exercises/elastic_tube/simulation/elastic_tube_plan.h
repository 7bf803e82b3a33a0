// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"
#include "modules/exercises/elastic_tube/simulation/elastic_tube_parameters.h"
#include "modules/exercises/elastic_tube/simulation/tube_chain.h"

#include <cstdint>
#include <vector>

namespace chiron::simulation {

/// What changes from trial to trial.
struct ElasticTubeTrial {
    core::Vec2 base_m = core::Vec2::Zero(); ///< x, y in W of the fixed end, or of the middle of where the tube lies
    double stiffness_N_per_m = 100.0;
    double target_N = 1.0; ///< 0 where the task has no target tension
};

/// Plans every trial of a session from its seed, before the first tick: base uniform in its disc, stiffness and target tension
/// uniform in their ranges, each from its own random stream ("elastic_tube.base", ...), so that levels which differ in one of
/// them share the others under one seed. Pure; allocates.
std::vector<ElasticTubeTrial> planElasticTubeTrials(const ElasticTubeParameters& parameters, std::uint64_t seed);

/// The law of one planned trial's tube. Pure.
TubeLaw elasticTubeLaw(const ElasticTubeParameters& parameters, const ElasticTubeTrial& trial) noexcept;
/// Its tube, untouched. Pure.
TubeShape elasticTubeShape(const ElasticTubeParameters& parameters, const ElasticTubeTrial& trial) noexcept;
/// The fold over it, untouched: a strip that lies over the tube's middle and is drawn back by its free edge (node 1). Pure.
TubeShape tissueFoldShape(const ElasticTubeParameters& parameters, const ElasticTubeTrial& trial) noexcept;

} // namespace chiron::simulation
