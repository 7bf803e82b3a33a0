// SPDX-License-Identifier: GPL-3.0-or-later
// Set-up of the scene. It may allocate, so it is kept apart from the code of the tick.
#include "core/units.h"
#include "modules/exercises/elastic_tube/simulation/elastic_tube_scene.h"

#include <algorithm>
#include <cmath>

namespace chiron::simulation {

namespace {

std::uint64_t ticks(double seconds) {
    return std::max<std::uint64_t>(
        1, static_cast<std::uint64_t>(std::llround(std::max(0.0, seconds) / core::kTickSeconds)));
}

bool has(const std::vector<std::string>& cues, const char* cue) {
    return std::find(cues.begin(), cues.end(), cue) != cues.end();
}

} // namespace

ElasticTubeScene::ElasticTubeScene(const ElasticTubeParameters& parameters, std::uint64_t seed)
    : m_parameters(parameters), m_trials(planElasticTubeTrials(parameters, seed)),
      m_limitTicks(ticks(parameters.trialLimit_s)), m_betweenTicks(ticks(parameters.betweenTrials_s)),
      m_holdTicks(ticks(parameters.hold_s)), m_showsObject(has(parameters.cues, "object")),
      m_showsBars(has(parameters.cues, "bars")) {}

ElasticTubeScene::~ElasticTubeScene() = default;

} // namespace chiron::simulation
