// SPDX-License-Identifier: GPL-3.0-or-later
// Set-up of the scene. It may allocate, so it is kept apart from the code of the tick.
#include "modules/exercises/object_handling/simulation/object_handling_scene.h"
#include "simulation/scene_parameters.h"

#include <utility>

namespace chiron::simulation {

namespace {

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
      m_course(m_trials.size(), ticksOf(parameters.trialLimit_s), ticksOf(parameters.betweenTrials_s)),
      m_showsObjects(hasCue(parameters.cues, "object")), m_showsBars(hasCue(parameters.cues, "bars")),
      m_softBed(softBed(parameters)), m_world(parameters, m_softBed.get()), m_task(parameters) {}

ObjectHandlingScene::~ObjectHandlingScene() = default;

} // namespace chiron::simulation
