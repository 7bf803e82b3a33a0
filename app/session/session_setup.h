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

/// The trials that a session's scores include. It is stored with the session, so that a change of the rule
/// does not affect stored sessions.
enum class ScoringRule {
    begunTrials = 1,    ///< a trial that was cut off counts with its existing samples (sessions that store no
                        ///< rule)
    finishedTrials = 2, ///< a trial without an end is not part of any score
};

/// Everything that determines the behaviour of a session's scene, supervisor and kinematics. It is stored
/// with the session and restored from there, never from the current files: editing a level later changes no
/// old score and no old replay.
struct SessionSetup {
    catalogue::ExerciseLevel level;
    std::uint64_t seed = 0;
    std::vector<devices::DeviceDescriptor> devices;  ///< one per tool
    std::vector<devices::WorkspaceMapping> mappings; ///< one per tool
    haptics::SafetySettings safety;
    ScoringRule scoring = ScoringRule::finishedTrials;

    bool felt() const; ///< true if any tool renders force: the class by which scores are grouped
};

/// The columns of a new session that the setup determines; the caller adds person, operator, ring and
/// recording.
database::NewSession toNewSession(const SessionSetup& setup);
/// Restores the setup from the stored columns.
/// Errors: badInput naming column and key.
core::Result<SessionSetup> setupFromStored(const database::NewSession& stored);

} // namespace chiron::session
