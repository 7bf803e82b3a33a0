// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdio>
#include <cstdlib>
#include <ctime>

namespace chiron::desktop {

/// If the environment variable CHIRON_START_TRACE is set, prints one line to standard error: "chiron-start
/// <what> <monotonic ns> <processor time of the process, ns>". Otherwise it costs nothing.
/// Thread: any.
inline void traceStart(const char* what) {
    static const bool wanted = std::getenv("CHIRON_START_TRACE") != nullptr;
    if (!wanted)
        return;
    const auto read = [](clockid_t clock) {
        timespec time{};
        clock_gettime(clock, &time);
        return static_cast<long long>(time.tv_sec) * 1'000'000'000LL + time.tv_nsec;
    };
    std::fprintf(stderr, "chiron-start %s %lld %lld\n", what, read(CLOCK_MONOTONIC),
                 read(CLOCK_PROCESS_CPUTIME_ID));
}

} // namespace chiron::desktop
