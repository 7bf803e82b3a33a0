// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace chiron::realtime {

/// The machine's CLOCK_MONOTONIC, for PeriodicRunner.
class MonotonicClock {
public:
    std::int64_t now_ns() const noexcept;
    /// Sleeps (clock_nanosleep, absolute) until 100 µs before the deadline and spins from there: the kernel
    /// wakes a thread tens of microseconds late, a spinning one is on time. Returns at once if the deadline
    /// has passed.
    void waitUntil(std::int64_t deadline_ns) const noexcept;

    static constexpr std::int64_t kSpin_ns = 100'000; ///< speed.md: sleep, then spin the last 100 µs
};

} // namespace chiron::realtime
