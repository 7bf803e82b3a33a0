// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace chiron::support {

/// In a sanitizer's build the same instructions cost ten times as much, and it looks for faults of memory,
/// not of judgement: what is repeated for statistics alone runs once there, and its verdict is left to the
/// other builds.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr bool kSanitized = true;
#else
inline constexpr bool kSanitized = false;
#endif

/// `wanted` repetitions, or the `least` that run everything.
constexpr int repeated(int wanted, int least = 1) {
    return kSanitized ? least : wanted;
}

} // namespace chiron::support

/// After a single repetition: nothing can be said.
#define CHIRON_SKIP_STATISTICS()                                                                             \
    do {                                                                                                     \
        if (chiron::support::kSanitized)                                                                     \
            QSKIP("ran once under a sanitizer; its statistics are judged in the other builds");              \
    } while (false)
