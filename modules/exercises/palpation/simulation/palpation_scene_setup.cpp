// SPDX-License-Identifier: GPL-3.0-or-later
// Set-up of the scene. It may allocate, so it is kept apart from the code of the tick.
#include "modules/exercises/palpation/simulation/palpation_scene.h"
#include "simulation/scene_parameters.h"

namespace chiron::simulation {

PalpationScene::PalpationScene(const PalpationParameters& parameters, std::uint64_t seed)
    : m_parameters(parameters), m_trials(planPalpationTrials(parameters, seed)), m_tissue(parameters.tissue),
      m_map(parameters.areaHalf_m, parameters.tissue.contactRadius_m, parameters.coverForce_N),
      m_course(m_trials.size(), ticksOf(parameters.trialLimit_s), ticksOf(parameters.betweenTrials_s)),
      m_moveTicks(parameters.control.moveAfter_s > 0.0 ? ticksOf(parameters.control.moveAfter_s) : 0),
      m_showsLumps(hasCue(parameters.cues, "object")), m_showsCoverage(hasCue(parameters.cues, "coverage")),
      m_showsBars(hasCue(parameters.cues, "bars")) {
    for (Finger& finger : m_fingers)
        finger.yield = finger.pinchYield = TissueYield(parameters.yield);
}

PalpationScene::~PalpationScene() = default;

} // namespace chiron::simulation
