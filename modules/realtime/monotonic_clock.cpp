// SPDX-License-Identifier: GPL-3.0-or-later
#include "realtime/monotonic_clock.h"

#include "core/clock.h"

#include <cerrno>
#include <ctime>
#include <immintrin.h>

namespace chiron::realtime {

std::int64_t MonotonicClock::now_ns() const noexcept {
    return core::monotonicNow_ns();
}

void MonotonicClock::waitUntil(std::int64_t deadline_ns) const noexcept {
    const std::int64_t wake_ns = deadline_ns - kSpin_ns;
    if (now_ns() < wake_ns) {
        const timespec wake{static_cast<std::time_t>(wake_ns / 1'000'000'000), wake_ns % 1'000'000'000};
        while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &wake, nullptr) == EINTR) {
            // A signal ended the sleep early. The deadline is absolute, so sleeping again costs nothing.
        }
    }
    while (now_ns() < deadline_ns)
        _mm_pause();
}

} // namespace chiron::realtime
