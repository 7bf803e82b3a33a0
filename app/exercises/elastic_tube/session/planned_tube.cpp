// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/elastic_tube/session/planned_tube.h"

#include "modules/exercises/elastic_tube/simulation/elastic_tube_plan.h"

namespace chiron::session {

std::vector<scoring::TubeTruth> plannedTubes(const simulation::ElasticTubeParameters& level,
                                             std::uint64_t seed) {
    std::vector<scoring::TubeTruth> truths;
    for (const simulation::ElasticTubeTrial& planned : simulation::planElasticTubeTrials(level, seed)) {
        scoring::TubeTruth truth;
        if (planned.target_N > 0.0) {
            truth.target_N = planned.target_N;
            truth.band_N = level.band_N;
        }
        if (level.task == simulation::TubeTask::stretch) {
            truth.mark_m = (level.markRatio - 1.0) * level.restLength_m;
            truth.markTolerance_m = level.markTolerance * level.restLength_m;
        }
        if (level.hasFold()) {
            truth.retractionLow_N = level.retractionLow_N;
            truth.retractionHigh_N = level.retractionHigh_N;
        }
        truth.overStretch_m = (level.overStretchRatio - 1.0) * level.restLength_m;
        truth.tear_m = (level.tearRatio - 1.0) * level.restLength_m;
        truth.hold_s = level.hold_s;
        truth.task = static_cast<int>(level.task);
        truths.push_back(truth);
    }
    return truths;
}

} // namespace chiron::session
