// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>

namespace chiron::realtime {

/// What the system granted to the calling thread, and why not, in words for a log or the station check.
struct RealtimeStatus {
    bool priorityGranted = false; ///< SCHED_FIFO
    std::string priorityDetail;   ///< "SCHED_FIFO priority 80", or the reason and what would help
    bool memoryLocked = false;    ///< mlockall: no page fault in the tick
    std::string memoryDetail;
};

inline constexpr int kHapticPriority = 80; ///< above ordinary real-time work, below the kernel's migration threads (99)
inline constexpr std::size_t kTouchedStack_bytes = 256 * 1024; ///< assumption: a tick needs a small part of this

/// Makes the calling thread fit for the tick: model floating-point environment, touched stack, finest timer slack,
/// SCHED_FIFO and locked memory where permitted. Never fails: without permission the thread runs as an ordinary one and
/// the status says why. Memory is locked only where the limit is unlimited: a finite
/// limit would make later allocations of the whole program fail. Blocks; not in the tick.
RealtimeStatus setUpRealtimeThread(int priority = kHapticPriority);

} // namespace chiron::realtime
