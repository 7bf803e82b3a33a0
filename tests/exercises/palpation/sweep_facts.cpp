// SPDX-License-Identifier: GPL-3.0-or-later
#include "sweep/sweep_facts.h"

#include "modules/exercises/palpation/simulation/palpation_parameters.h"

namespace chiron::tests {

namespace {

/// Damping differs by direction, and fades in over a depth of its own.
void complete(const catalogue::ExerciseLevel& level, LevelNumbers& numbers) {
    const auto& tissue = level.parameters.as<simulation::PalpationParameters>().tissue;
    numbers.damping_Ns_per_m = tissue.damping_Ns_per_m.maxCoeff();
    numbers.fade_m = tissue.dampingDepth_m / kSteepest; // a smoothstep
}

const SweepFacts kFacts("palpation", complete);

} // namespace

} // namespace chiron::tests
