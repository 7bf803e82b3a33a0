// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <ctime>
#include <vector>

namespace chiron::bench {

/// CPU time of this thread (what a computation costs, whoever else runs), or monotonic time, in seconds.
inline double seconds(clockid_t clock) {
    timespec t{};
    clock_gettime(clock, &t);
    return static_cast<double>(t.tv_sec) + static_cast<double>(t.tv_nsec) * 1e-9;
}

template <class Work> double cpuSeconds(Work&& work) {
    const double start = seconds(CLOCK_THREAD_CPUTIME_ID);
    work();
    return seconds(CLOCK_THREAD_CPUTIME_ID) - start;
}

inline double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return values.empty() ? 0.0 : values[values.size() / 2];
}

} // namespace chiron::bench
