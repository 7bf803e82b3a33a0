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

/// One session in real time for a window: runs runTraining() on a separate thread and gives the GUI thread
/// access to it. Neither thread ever waits for the other. The session monitors a heartbeat: if the window
/// does not call beat() for 250 ms, from the first tick on, force is off until it does. The first trial waits
/// for the `start` command, so that the window can open first. The session ends with the last trial, with the
/// `end` command or with requestStop().
///
/// Use: start() -> beat() each frame, display()/samples() at will, post(start) when the screen is ready ->
/// finished(). Destroying the object ends a running session as *stopped* and waits until it is stored.
/// Thread: GUI; `onFinished` is called on the session's thread and must post to the GUI thread.
class LiveTraining {
public:
    /// Begins at once; sets `request.realtime`, `live` and `cancel`. `onFinished` may be empty. The database
    /// must outlive this object. Later failures are in result().
    /// Errors: wrongUse (no device, or a database opened read-only).
    static core::Result<std::unique_ptr<LiveTraining>> start(database::Database& database,
                                                             const database::Actor& actor,
                                                             TrainingRequest request,
                                                             std::function<void()> onFinished = {});
    LiveTraining(const LiveTraining&) = delete;
    LiveTraining& operator=(const LiveTraining&) = delete;
    ~LiveTraining();

    /// Hands a command to the loop; returns false if 64 commands are already waiting.
    bool post(core::CommandKind kind, std::uint16_t argument = 0) noexcept {
        return m_link.inputs().post({kind, argument});
    }
    void beat() noexcept; ///< heartbeat of the window
    /// Requests the end; the session becomes *stopped*. Returns at once.
    void requestStop() noexcept { m_cancel.store(true, std::memory_order_relaxed); }

    realtime::LatestValue<haptics::DisplayState>& display() noexcept { return m_link.display(); }
    realtime::LatestValue<haptics::LoopStatistics>& statistics() noexcept { return m_link.statistics(); }
    /// All ticks since the last call; drain it each frame. A full ring drops and counts samples; the
    /// recording is not affected.
    realtime::SpscRing<LiveSample, LiveLink::kSamples>& samples() noexcept { return m_link.samples(); }
    std::uint64_t droppedSamples() const noexcept { return m_link.droppedSamples(); }

    /// 0 until the session is stored
    database::SessionId sessionId() const noexcept { return m_link.session(); }
    bool finished() const noexcept { return m_finished.load(std::memory_order_acquire); }
    /// Valid once finished().
    const core::Result<TrainingResult>& result() const noexcept { return m_result; }

    const Station& station() const noexcept { return m_request.station; }
    /// The mailboxes for a mouse and a keyboard that move points or graspers, one per tool; empty if the
    /// station has none. Valid as long as this object.
    std::vector<devices::PointerMailbox*> pointers() const { return m_request.station.pointers(); }
    /// The same if the station has exactly one tool; otherwise null.
    devices::PointerMailbox* pointer() const {
        const std::vector<devices::PointerMailbox*> all = pointers();
        return all.size() == 1 ? all.front() : nullptr;
    }
    /// The same for an endoscope.
    devices::EndoscopeMailbox* endoscope() const noexcept { return m_request.station.endoscope(); }
    bool felt() const noexcept { return m_felt; } ///< true if any device of the station renders force

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
    std::thread m_thread; ///< declared last, because it uses all of the above
};

} // namespace chiron::session
