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

/// One session to be run. The station is used up.
struct TrainingRequest {
    catalogue::ExerciseLevel level;
    std::uint64_t seed = 1;
    Station station;
    bool realtime = false; ///< false: as fast as the machine can, with the same result
    bool familiarisation = false;
    std::int64_t studyRun = 0;                ///< run of a study that it is recorded for; 0: none
    std::filesystem::path ringFolder;         ///< of the crash ring; recording::defaultRingFolder()
    core::IFrameSink* witness = nullptr;      ///< also gets every frame, on the haptic thread
    const std::atomic<bool>* cancel = nullptr; ///< set from outside: the session ends as *stopped*
    /// Gives the commands of an as-fast run and ends it (no tick limit then). Outlives the run.
    ITickDirector* director = nullptr;
    std::function<void(database::SessionId)> onSession; ///< told once the session is listed, before its first tick; may be empty
    /// A window: its heartbeat is watched, its `start` command begins the first trial, and nothing but the exercise, `end`
    /// and `cancel` end the session. Outlives the run.
    LiveLink* live = nullptr;
};

struct TrainingResult {
    database::SessionId session = 0;
    LoopReport loop;
    RecordingReport recording;
    scoring::ScoreCard scores;
};

/// Runs one session from first tick to stored score: composes scene, devices, supervisor, loop, ring and drain, owns
/// their threads and their stop order (zero force, haptic thread, devices, drain, end of session, scores). Blocking; call it on a
/// worker. Failure before the first tick leaves no session; after it, what was recorded stays for recovery.
core::Result<TrainingResult> runTraining(database::Database& database, const database::Actor& actor,
                                         TrainingRequest request);
/// The same with a request that the caller keeps, station and all, while it runs and after it.
core::Result<TrainingResult> runTrainingOn(database::Database& database, const database::Actor& actor,
                                           TrainingRequest& request);

/// The supervisor's settings for a level without a window: site and exercise caps, no heartbeat.
haptics::SafetySettings headlessSafety(const catalogue::ExerciseLevel& level);

} // namespace chiron::session
