// SPDX-License-Identifier: GPL-3.0-or-later
// Set-up of the scene. It may allocate, so it is kept apart from the code of the tick.
#include "modules/exercises/elastic_tube/simulation/elastic_tube_scene.h"
#include "simulation/scene_parameters.h"

namespace chiron::simulation {

ElasticTubeScene::ElasticTubeScene(const ElasticTubeParameters& parameters, std::uint64_t seed)
    : m_parameters(parameters), m_trials(planElasticTubeTrials(parameters, seed)),
      m_course(m_trials.size(), ticksOf(parameters.trialLimit_s), ticksOf(parameters.betweenTrials_s)),
      m_holdTicks(ticksOf(parameters.hold_s)), m_showsObject(hasCue(parameters.cues, "object")),
      m_showsBars(hasCue(parameters.cues, "bars")) {}

ElasticTubeScene::~ElasticTubeScene() = default;

} // namespace chiron::simulation
