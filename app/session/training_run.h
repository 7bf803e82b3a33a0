// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "database/database.h"
#include "haptics/loop_statistics.h"
#include "realtime/realtime_thread.h"
#include "scoring/score_card.h"
#include "session/live_link.h"
#include "session/live_recording.h"
#include "session/loop_report.h"
#include "session/station.h"
#include "session/tick_director.h"

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>

namespace chiron::session {

/// A session to be run. Running it consumes the station.
struct TrainingRequest {
    catalogue::ExerciseLevel level;
    std::uint64_t seed = 1;
    Station station;
    bool realtime = false; ///< false: faster than real time, with the same result
    bool familiarisation = false;
    std::int64_t studyRun = 0;                 ///< run of a study for which it is recorded; 0: none
    std::filesystem::path ringFolder;          ///< folder of the crash ring; recording::defaultRingFolder()
    core::IFrameSink* witness = nullptr;       ///< also gets every frame, on the haptic thread
    const std::atomic<bool>* cancel = nullptr; ///< set from outside: the session then ends as *stopped*
    /// Gives the commands of a run faster than real time and ends it (there is then no tick limit). Must
    /// outlive the run.
    ITickDirector* director = nullptr;
    /// Called once the session is stored, before its first tick; may be empty.
    std::function<void(database::SessionId)> onSession;
    /// The link to a window: its heartbeat is monitored, its `start` command begins the first trial, and only
    /// the exercise, `end` and `cancel` end the session. Must outlive the run.
    LiveLink* live = nullptr;
};

struct TrainingResult {
    database::SessionId session = 0;
    LoopReport loop;
    RecordingReport recording;
    scoring::ScoreCard scores;
};

/// Runs one session from the first tick to the stored score: composes scene, devices, supervisor, loop, ring
/// and drain, and owns their threads and the order in which they stop (zero force, haptic thread, devices,
/// drain, end of session, scores). A failure before the first tick leaves no session; after a later one, the
/// recorded data stay for recovery. Blocks; call it on a worker.
core::Result<TrainingResult> runTraining(database::Database& database, const database::Actor& actor,
                                         TrainingRequest request);
/// The same with a request that the caller keeps, including the station, during the run and after it.
core::Result<TrainingResult> runTrainingOn(database::Database& database, const database::Actor& actor,
                                           TrainingRequest& request);

/// The supervisor's settings for a level without a window: site and exercise caps, no heartbeat.
haptics::SafetySettings headlessSafety(const catalogue::ExerciseLevel& level);

} // namespace chiron::session
