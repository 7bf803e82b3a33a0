// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "database/database.h"
#include "database/drainable.h"
#include "recording/crash_ring.h"
#include "recording/frame_drain.h"
#include "recording/recorder.h"
#include "session/session_setup.h"
#include "session/tool_positions.h"

#include <filesystem>
#include <memory>

namespace chiron::session {

/// The result of a recording.
struct RecordingReport {
    std::uint64_t frames = 0;  ///< frames stored
    std::uint64_t dropped = 0; ///< frames lost because the ring was full; if not 0, the session is incomplete
    std::uint64_t bytes = 0;   ///< payload bytes stored
};

/// The recording of a running session: ring, recorder and sink, which the writer thread drains every 20 ms.
/// The session's thread creates and destroys it; the haptic thread pushes into sink().
class LiveRecording final : public database::IDrainable {
public:
    /// Reserves the ring and opens the sink for the running session.
    /// Errors: storage, with nothing left behind.
    static core::Result<std::unique_ptr<LiveRecording>>
    start(database::Database& database, const database::Actor& actor, database::SessionId session,
          const SessionSetup& setup, const std::filesystem::path& ringFolder, bool realtime);
    LiveRecording(const LiveRecording&) = delete;
    LiveRecording& operator=(const LiveRecording&) = delete;
    ~LiveRecording() override; ///< stops draining; the ring file stays for recovery unless finish() succeeded

    core::IFrameSink& sink() noexcept { return *m_ring; }
    core::Result<void> drain() override; ///< writer thread
    /// Call it after the last push: stores everything and removes the ring.
    /// Errors: those of the sink; the ring file then stays.
    core::Result<RecordingReport> finish();

private:
    LiveRecording(database::Database& database, std::unique_ptr<ToolPositions> positions)
        : m_database(database), m_positions(std::move(positions)) {}
    void stopDraining();

    database::Database& m_database;
    std::unique_ptr<ToolPositions> m_positions;
    std::unique_ptr<recording::CrashRing> m_ring;
    std::unique_ptr<recording::TrialSink> m_sink;
    std::unique_ptr<recording::Recorder> m_recorder;
    std::unique_ptr<recording::FrameDrain> m_drain;
    core::Result<void> m_drainOutcome;
    bool m_draining = false;
    bool m_realtime = true; ///< if true, the clock also closes chunks; faster than real time, only full ones
                            ///< are closed, so that the result is reproducible
    bool m_finishing = false; ///< the next drain stores everything; set while the writer is not draining
};

/// The database's UUID in the form in which the header of a ring stores it.
/// Errors: badInput.
core::Result<recording::DatabaseId> ringIdOf(const database::Database& database);

} // namespace chiron::session
