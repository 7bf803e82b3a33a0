// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/command.h"
#include "core/result.h"
#include "database/database.h"
#include "session/live_link.h"
#include "session/training_run.h"

#include <atomic>
#include <functional>
#include <memory>
#include <thread>
#include <vector>

namespace chiron::session {

/// One session in real time for a window: runTraining() on a thread of its own, and what the GUI thread needs of it
/// without ever waiting for the loop or making it wait. The session's heartbeat is watched: a window that does not call
/// beat() for 250 ms, from the first tick on, loses force until it does. The first trial waits for the `start` command, so
/// that a window may come up first. It ends with the last trial, with the `end` command or with requestStop().
///
/// Use: start() -> beat() each frame, display()/samples() at will, post(start) when the screen is there -> finished().
/// Threads: everything here on the GUI thread; `onFinished` is called on the session's thread and posts to the GUI's.
/// Destroying it ends a running session as *stopped* and waits until it is stored.
class LiveTraining {
public:
    /// Begins at once; `request.realtime`, `live` and `cancel` are set here. `onFinished` may be empty. The database outlives
    /// it. Failure: wrongUse (no device, or a database opened read-only). What goes wrong later is in result().
    static core::Result<std::unique_ptr<LiveTraining>> start(database::Database& database, const database::Actor& actor,
                                                             TrainingRequest request,
                                                             std::function<void()> onFinished = {});
    LiveTraining(const LiveTraining&) = delete;
    LiveTraining& operator=(const LiveTraining&) = delete;
    ~LiveTraining();

    /// Hands a command to the loop; false when 64 are already waiting.
    bool post(core::CommandKind kind, std::uint16_t argument = 0) noexcept { return m_link.inputs().post({kind, argument}); }
    void beat() noexcept; ///< the window is alive
    /// Asks for the end; the session becomes *stopped*. Returns at once.
    void requestStop() noexcept { m_cancel.store(true, std::memory_order_relaxed); }

    realtime::LatestValue<haptics::DisplayState>& display() noexcept { return m_link.display(); }
    realtime::LatestValue<haptics::LoopStatistics>& statistics() noexcept { return m_link.statistics(); }
    /// Every tick since the last look; drain it each frame. A full ring drops and counts; the recording is untouched.
    realtime::SpscRing<LiveSample, LiveLink::kSamples>& samples() noexcept { return m_link.samples(); }
    std::uint64_t droppedSamples() const noexcept { return m_link.droppedSamples(); }

    database::SessionId sessionId() const noexcept { return m_link.session(); } ///< 0 until it is listed
    bool finished() const noexcept { return m_finished.load(std::memory_order_acquire); }
    const core::Result<TrainingResult>& result() const noexcept { return m_result; } ///< once finished()

    const Station& station() const noexcept { return m_request.station; }
    /// Where a mouse and a keyboard go that move points or graspers, one a tool; empty where the station has none. Valid as long as this.
    std::vector<devices::PointerMailbox*> pointers() const { return m_request.station.pointers(); }
    /// The same where the station has just one tool; null elsewhere.
    devices::PointerMailbox* pointer() const {
        const std::vector<devices::PointerMailbox*> all = pointers();
        return all.size() == 1 ? all.front() : nullptr;
    }
    devices::EndoscopeMailbox* endoscope() const noexcept { return m_request.station.endoscope(); } ///< the same for an endoscope
    bool felt() const noexcept { return m_felt; } ///< whether any device of the station renders force

private:
    LiveTraining(database::Database& database, const database::Actor& actor, TrainingRequest request,
                 std::function<void()> onFinished);
    void run();

    database::Database& m_database;
    database::Actor m_actor;
    TrainingRequest m_request;
    std::function<void()> m_onFinished;
    bool m_felt = false;
    LiveLink m_link;
    std::atomic<bool> m_cancel{false};
    std::atomic<bool> m_finished{false};
    core::Result<TrainingResult> m_result;
    std::thread m_thread; ///< last: it uses all of the above
};

} // namespace chiron::session
