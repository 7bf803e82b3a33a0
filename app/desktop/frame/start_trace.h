// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdio>
#include <cstdlib>
#include <ctime>

namespace chiron::desktop {

/// Where the environment's CHIRON_START_TRACE is set: one line on the standard error, "chiron-start <what> <monotonic ns>".
/// Costs nothing else. Any thread.
inline void traceStart(const char* what) {
    static const bool wanted = std::getenv("CHIRON_START_TRACE") != nullptr;
    if (!wanted)
        return;
    timespec now{};
    clock_gettime(CLOCK_MONOTONIC, &now);
    std::fprintf(stderr, "chiron-start %s %lld\n", what, static_cast<long long>(now.tv_sec) * 1'000'000'000LL + now.tv_nsec);
}

} // namespace chiron::desktop
