// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/exercises/elastic_tube/simulation/elastic_tube_plan.h"

#include "core/random.h"
#include "core/units.h"

#include <algorithm>
#include <cmath>

namespace chiron::simulation {

std::vector<ElasticTubeTrial> planElasticTubeTrials(const ElasticTubeParameters& parameters,
                                                    std::uint64_t seed) {
    core::Random bases = core::Random::stream(seed, "elastic_tube.base");
    core::Random stiffnesses = core::Random::stream(seed, "elastic_tube.stiffness");
    core::Random targets = core::Random::stream(seed, "elastic_tube.target");
    const bool draws = parameters.stiffnessHigh_N_per_m > 0.0;
    const bool tension = parameters.task == TubeTask::hold || parameters.task == TubeTask::twoHanded;
    std::vector<ElasticTubeTrial> trials(static_cast<std::size_t>(std::max(1, parameters.trials)));
    for (ElasticTubeTrial& trial : trials) {
        const double r = parameters.baseSpread_m * std::sqrt(bases.uniform()); // equal areas
        const double angle = 2.0 * core::kPi * bases.uniform();
        trial.base_m = {parameters.baseX_m + r * std::cos(angle), parameters.baseY_m + r * std::sin(angle)};
        const double drawn =
            stiffnesses.uniform(parameters.stiffnessLow_N_per_m, parameters.stiffnessHigh_N_per_m);
        trial.stiffness_N_per_m = draws ? drawn : parameters.tube.stiffness_N_per_m;
        const double target = targets.uniform(parameters.targetLow_N, parameters.targetHigh_N);
        trial.target_N = tension ? target : 0.0;
    }
    return trials;
}

} // namespace chiron::simulation
