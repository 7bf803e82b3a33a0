// SPDX-License-Identifier: GPL-3.0-or-later
// Set-up of the scene. It may allocate, so it is kept apart from the code of the tick.
#include "simulation/comparison/comparison_scene.h"
#include "simulation/scene_parameters.h"

#include <algorithm>

namespace chiron::simulation {

namespace {

/// Returns 0 for no limit.
std::uint64_t limitOf(double seconds) noexcept {
    return seconds > 0.0 ? ticksOf(seconds) : 0;
}

/// Both parts of a trial have to be limited, or else a trial waits for its answer.
std::uint64_t limitOfTrial(const ComparisonParameters& parameters) noexcept {
    const std::uint64_t explore = limitOf(parameters.exploreLimit_s);
    const std::uint64_t answer = limitOf(parameters.answerLimit_s);
    return explore > 0 && answer > 0 ? explore + answer : TrialCourse::kNoLimit;
}

} // namespace

ComparisonScene::ComparisonScene(const ComparisonParameters& parameters, std::uint64_t seed)
    : m_parameters(parameters), m_seed(seed), m_exploreTicks(limitOf(parameters.exploreLimit_s)),
      m_course(TrialCourse::kUnplanned, limitOfTrial(parameters), ticksOf(parameters.betweenTrials_s)),
      m_showsObjects(hasCue(parameters.cues, "object")) {
    m_parameters.places = std::clamp(parameters.places, 1, ComparisonParameters::kMaxPlaces);
}

ComparisonScene::~ComparisonScene() = default;

} // namespace chiron::simulation
