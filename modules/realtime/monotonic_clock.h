// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace chiron::realtime {

/// The machine's CLOCK_MONOTONIC, as PeriodicRunner uses it.
class MonotonicClock {
public:
    std::int64_t now_ns() const noexcept;
    /// Sleeps (clock_nanosleep, absolute) to 100 µs before the deadline, then spins: the kernel's wake-up is late by
    /// tens of microseconds, the spin is not. Returns at once if the deadline has passed.
    void waitUntil(std::int64_t deadline_ns) const noexcept;

    static constexpr std::int64_t kSpin_ns = 100'000; ///< speed.md: sleep, then spin the last 100 µs
};

} // namespace chiron::realtime
