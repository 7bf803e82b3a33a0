// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/exercise.h"
#include "core/result.h"
#include "operators/comparison/participant_mind.h"
#include "psychophysics/study/study_design.h"
#include "session/station.h"
#include "simulation/comparison/comparison_parameters.h"

#include <cstdint>
#include <string>

namespace chiron::session {

/// The level under which a condition's sessions are recorded. `control`: a deliberate fault
/// (psychophysics.md §6). `sealedCode`: the name of the condition in the session's title and in the level's
/// id; empty: its own id. `freeFirst`: the session begins with a free minute, to which no limit applies.
/// Errors: badInput.
core::Result<catalogue::ExerciseLevel>
studyLevel(const psychophysics::StudyDesign& design, const psychophysics::Condition& condition,
           simulation::ComparisonControl control = simulation::ComparisonControl::none,
           const std::string& sealedCode = {}, bool freeFirst = false);

/// The condition with this id; null if there is none.
const psychophysics::Condition* conditionOf(const psychophysics::StudyDesign& design, const std::string& id);

/// P2's simulated gimbal held by a simulated participant.
struct ParticipantStation {
    Station station;
    operators::IParticipantMind* mind = nullptr; ///< decision model of the participant on the station's
                                                 ///< device
};
core::Result<ParticipantStation> participantStation(const catalogue::ExerciseLevel& level,
                                                    std::uint64_t seed);

} // namespace chiron::session
