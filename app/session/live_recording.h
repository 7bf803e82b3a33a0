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

/// What became of a recording.
struct RecordingReport {
    std::uint64_t frames = 0;  ///< stored
    std::uint64_t dropped = 0; ///< lost to a full ring; not 0: the session is incomplete
    std::uint64_t bytes = 0;   ///< payload bytes stored
};

/// A session's recording while it runs: ring, recorder and sink, drained by the writer thread every 20 ms. Made and
/// destroyed by the session's thread; the haptic thread pushes into sink().
class LiveRecording final : public database::IDrainable {
public:
    /// Reserves the ring and opens the sink for the running session. Failure: storage, with nothing left behind.
    static core::Result<std::unique_ptr<LiveRecording>> start(database::Database& database,
                                                              const database::Actor& actor,
                                                              database::SessionId session, const SessionSetup& setup,
                                                              const std::filesystem::path& ringFolder,
                                                              bool realtime);
    LiveRecording(const LiveRecording&) = delete;
    LiveRecording& operator=(const LiveRecording&) = delete;
    ~LiveRecording() override; ///< stops draining; the ring file stays for recovery unless finish() succeeded

    core::IFrameSink& sink() noexcept { return *m_ring; }
    core::Result<void> drain() override; ///< writer thread
    /// After the last push: stores everything and removes the ring. Failure: the sink's; the ring file stays.
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
    bool m_realtime = true; ///< chunks close by the clock too; as-fast ones when they are full: the same every time
    bool m_finishing = false; ///< the next drain stores everything; set while the writer does not drain
};

/// The database's UUID as a ring's header carries it. Failure: badInput.
core::Result<recording::DatabaseId> ringIdOf(const database::Database& database);

} // namespace chiron::session
