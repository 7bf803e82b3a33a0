// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/object_handling/session/planned_handling.h"

#include "modules/exercises/object_handling/simulation/object_handling_plan.h"

#include <utility>

namespace chiron::session {

std::vector<scoring::HandlingTruth> plannedHandling(const simulation::ObjectHandlingParameters& level,
                                                    std::uint64_t seed) {
    std::vector<scoring::HandlingTruth> truths;
    for (const simulation::ObjectHandlingTrial& planned : simulation::planObjectHandlingTrials(level, seed)) {
        scoring::HandlingTruth truth;
        truth.targetX_m = planned.target_m.x();
        truth.targetY_m = planned.target_m.y();
        truth.targetRadius_m = level.targetRadius_m;
        truth.squeezeLimit_N = level.squeezeLimit_N;
        truth.task = static_cast<int>(level.task);
        truth.objects = planned.objects;
        truth.heaviest = planned.heaviest;
        truth.masses_kg.assign(planned.mass_kg.begin(), planned.mass_kg.begin() + planned.objects);
        truths.push_back(std::move(truth));
    }
    return truths;
}

} // namespace chiron::session
