// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "database/actor.h"
#include "haptics/display_state.h"
#include "haptics/live_inputs.h"
#include "haptics/loop_statistics.h"
#include "realtime/latest_value.h"
#include "realtime/spsc_ring.h"
#include "session/live_sample.h"

#include <atomic>
#include <cstdint>

namespace chiron::session {

/// The data that a window and a running session share without a lock on either side: commands and heartbeats
/// to the session, the newest state and every tick's sample to the window. It outlives the run. publish()
/// never waits, allocates or throws.
/// Thread: publish() haptic; all reading functions on one other thread (the GUI's).
class LiveLink {
public:
    static constexpr std::size_t kSamples = 8192; ///< 8 s: longer than any stall that should leave the plots
                                                  ///< without gaps

    LiveLink() = default;
    LiveLink(const LiveLink&) = delete;
    LiveLink& operator=(const LiveLink&) = delete;

    haptics::LiveInputs& inputs() noexcept { return m_inputs; }
    realtime::LatestValue<haptics::DisplayState>& display() noexcept { return m_display; }
    realtime::LatestValue<haptics::LoopStatistics>& statistics() noexcept { return m_statistics; }
    realtime::SpscRing<LiveSample, kSamples>& samples() noexcept { return m_samples; }
    /// Number of samples that found the ring full because the window did not drain it. The recording contains
    /// all of them.
    std::uint64_t droppedSamples() const noexcept { return m_dropped.load(std::memory_order_relaxed); }

    void publish(const haptics::DisplayState& shown) noexcept; ///< after each tick
    /// After each tick; passed on four times per second.
    void publish(const haptics::LoopStatistics& statistics) noexcept;

    /// Call it on the session's thread once the session is stored; session() is 0 until then.
    void setSession(database::SessionId session) noexcept {
        m_session.store(session, std::memory_order_release);
    }
    database::SessionId session() const noexcept { return m_session.load(std::memory_order_acquire); }

private:
    haptics::LiveInputs m_inputs;
    realtime::LatestValue<haptics::DisplayState> m_display;
    realtime::LatestValue<haptics::LoopStatistics> m_statistics;
    realtime::SpscRing<LiveSample, kSamples> m_samples;
    std::atomic<std::uint64_t> m_dropped{0};
    std::atomic<database::SessionId> m_session{0};
    std::int64_t m_start_ns = 0; ///< belongs to the haptic thread
    bool m_started = false;
};

} // namespace chiron::session
