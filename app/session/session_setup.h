// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/exercise.h"
#include "core/result.h"
#include "database/repositories/session_types.h"
#include "devices/api/device_descriptor.h"
#include "haptics/safety_settings.h"

#include <cstdint>
#include <vector>

namespace chiron::session {

/// What a session's scores are made of; stored with it, so that a change leaves stored sessions as they were.
enum class ScoringRule {
    begunTrials = 1,    ///< one that was cut off counts with what there is of it (sessions without a word of it)
    finishedTrials = 2, ///< a trial without an end is in no score
};

/// Everything that decides what a session's scene, supervisor and kinematics do. Stored with the session and made again
/// from what is stored, never from today's files: editing a level later changes no old score and no old replay.
struct SessionSetup {
    catalogue::ExerciseLevel level;
    std::uint64_t seed = 0;
    std::vector<devices::DeviceDescriptor> devices;  ///< one a tool
    std::vector<devices::WorkspaceMapping> mappings; ///< one a tool
    haptics::SafetySettings safety;
    ScoringRule scoring = ScoringRule::finishedTrials;

    bool felt() const; ///< whether any tool renders force: the class that scores are grouped by
};

/// The columns of a new session that the setup decides; the caller adds who, operator, ring and recording.
database::NewSession toNewSession(const SessionSetup& setup);
/// Failure: badInput naming column and key.
core::Result<SessionSetup> setupFromStored(const database::NewSession& stored);

} // namespace chiron::session
