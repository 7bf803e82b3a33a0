// SPDX-License-Identifier: GPL-3.0-or-later
// Set-up of the scene. It may allocate, so it is kept apart from the code of the tick.
#include "core/units.h"
#include "modules/exercises/object_handling/simulation/object_handling_scene.h"

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

/// Content was checked by making its organ (object_handling_checks.cpp). For unchecked parameters that make
/// no organ there is no bed at all: hasBed() returns false, nothing is rendered and the trials run out. A
/// plane instead would be another exercise.
std::unique_ptr<SoftBed> softBed(const ObjectHandlingParameters& parameters) {
    if (!parameters.organBed)
        return nullptr;
    auto bed = SoftBed::make(parameters);
    return bed ? std::move(*bed) : nullptr;
}

} // namespace

ObjectHandlingScene::ObjectHandlingScene(const ObjectHandlingParameters& parameters, std::uint64_t seed)
    : m_parameters(parameters), m_trials(planObjectHandlingTrials(parameters, seed)),
      m_limitTicks(ticks(parameters.trialLimit_s)), m_betweenTicks(ticks(parameters.betweenTrials_s)),
      m_showsObjects(has(parameters.cues, "object")), m_showsBars(has(parameters.cues, "bars")),
      m_softBed(softBed(parameters)), m_world(parameters, m_softBed.get()), m_task(parameters) {}

ObjectHandlingScene::~ObjectHandlingScene() = default;

} // namespace chiron::simulation
