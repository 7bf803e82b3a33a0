// SPDX-License-Identifier: GPL-3.0-or-later
// Set-up of the scene. It may allocate, so it is kept apart from the code of the tick.
#include "core/units.h"
#include "simulation/comparison/comparison_scene.h"

#include <algorithm>
#include <cmath>

namespace chiron::simulation {

namespace {

std::uint64_t ticks(double seconds) {
    return seconds > 0.0
               ? static_cast<std::uint64_t>(std::max(1LL, std::llround(seconds / core::kTickSeconds)))
               : 0;
}

} // namespace

ComparisonScene::ComparisonScene(const ComparisonParameters& parameters, std::uint64_t seed)
    : m_parameters(parameters), m_seed(seed), m_exploreTicks(ticks(parameters.exploreLimit_s)),
      m_answerTicks(ticks(parameters.answerLimit_s)),
      m_betweenTicks(std::max<std::uint64_t>(1, ticks(parameters.betweenTrials_s))),
      m_showsObjects(std::find(parameters.cues.begin(), parameters.cues.end(), "object") !=
                     parameters.cues.end()) {
    m_parameters.places = std::clamp(parameters.places, 1, ComparisonParameters::kMaxPlaces);
}

ComparisonScene::~ComparisonScene() = default;

} // namespace chiron::simulation
