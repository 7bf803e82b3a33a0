// SPDX-License-Identifier: GPL-3.0-or-later
// Set-up of the scene. It may allocate, so it is kept apart from the code of the tick.
#include "core/units.h"
#include "modules/exercises/palpation/simulation/palpation_scene.h"

#include <algorithm>
#include <cmath>

namespace chiron::simulation {

namespace {

std::uint64_t ticks(double seconds) {
    return static_cast<std::uint64_t>(std::max(1LL, std::llround(seconds / core::kTickSeconds)));
}

bool has(const std::vector<std::string>& cues, const char* cue) {
    return std::find(cues.begin(), cues.end(), cue) != cues.end();
}

} // namespace

PalpationScene::PalpationScene(const PalpationParameters& parameters, std::uint64_t seed)
    : m_parameters(parameters), m_trials(planPalpationTrials(parameters, seed)), m_tissue(parameters.tissue),
      m_map(parameters.areaHalf_m, parameters.tissue.contactRadius_m, parameters.coverForce_N),
      m_limitTicks(ticks(parameters.trialLimit_s)), m_betweenTicks(ticks(parameters.betweenTrials_s)),
      m_moveTicks(parameters.control.moveAfter_s > 0.0 ? ticks(parameters.control.moveAfter_s) : 0),
      m_showsLumps(has(parameters.cues, "object")), m_showsCoverage(has(parameters.cues, "coverage")),
      m_showsBars(has(parameters.cues, "bars")) {
    for (Finger& finger : m_fingers)
        finger.yield = finger.pinchYield = TissueYield(parameters.yield);
}

PalpationScene::~PalpationScene() = default;

} // namespace chiron::simulation
