// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace chiron::realtime {

/// A clock that moves only on request, so that PeriodicRunner needs no real time and is repeatable.
/// waitUntil() jumps to the deadline plus the delay set with delayNextWake(); a task that "takes" time calls
/// advance(). Single thread.
class VirtualClock {
public:
    explicit VirtualClock(std::int64_t start_ns = 0) noexcept : m_now_ns(start_ns) {}

    std::int64_t now_ns() const noexcept { return m_now_ns; }
    void waitUntil(std::int64_t deadline_ns) noexcept {
        if (m_now_ns < deadline_ns)
            m_now_ns = deadline_ns + m_wakeDelay_ns;
        m_wakeDelay_ns = 0;
    }
    void advance(std::int64_t duration_ns) noexcept { m_now_ns += duration_ns; }
    /// Makes the next wake-up from sleep late by this much, as on a busy machine.
    void delayNextWake(std::int64_t delay_ns) noexcept { m_wakeDelay_ns = delay_ns; }

private:
    std::int64_t m_now_ns;
    std::int64_t m_wakeDelay_ns = 0;
};

} // namespace chiron::realtime
