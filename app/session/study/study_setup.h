// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/exercise.h"
#include "core/result.h"
#include "modules/exercises/comparison/operators/participant_mind.h"
#include "psychophysics/study/study_design.h"
#include "session/station.h"
#include "modules/exercises/comparison/simulation/comparison_parameters.h"

#include <cstdint>
#include <string>

namespace chiron::session {

/// The level that a condition's sessions are recorded under. `control`: a deliberate fault (psychophysics.md §6). `sealedCode`: what the
/// condition is called in the session's title and in its level's id; empty: by its own id. Failure: badInput.
core::Result<catalogue::ExerciseLevel> studyLevel(const psychophysics::StudyDesign& design, const psychophysics::Condition& condition,
                                                  simulation::ComparisonControl control = simulation::ComparisonControl::none,
                                                  const std::string& sealedCode = {});

/// The condition with this id; null where there is none.
const psychophysics::Condition* conditionOf(const psychophysics::StudyDesign& design, const std::string& id);

/// P2's simulated gimbal with a simulated participant's hand on it.
struct ParticipantStation {
    Station station;
    operators::IParticipantMind* mind = nullptr; ///< of the station's device
};
core::Result<ParticipantStation> participantStation(const catalogue::ExerciseLevel& level, std::uint64_t seed);

} // namespace chiron::session
