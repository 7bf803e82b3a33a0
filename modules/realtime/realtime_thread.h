// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>

namespace chiron::realtime {

/// The rights that the system granted to the calling thread, and the reasons for those it refused, as texts
/// for a log or the station check.
struct RealtimeStatus {
    bool priorityGranted = false; ///< SCHED_FIFO
    std::string priorityDetail;   ///< "SCHED_FIFO priority 80", or the reason and a remedy
    bool memoryLocked = false;    ///< mlockall: the tick has no page faults
    std::string memoryDetail;
};

/// Above ordinary real-time work, below the kernel's migration threads (99).
inline constexpr int kHapticPriority = 80;
inline constexpr std::size_t kTouchedStack_bytes = 256 * 1024; ///< assumption: a tick needs a small part of
                                                               ///< this

/// Prepares the calling thread for the tick: model floating-point environment, touched stack, smallest timer
/// slack, and SCHED_FIFO and locked memory where permitted. It never fails: without permission the thread
/// runs as an ordinary one, and the status gives the reason. Memory is locked only if the limit is unlimited;
/// with a finite limit, later allocations of the whole program would fail. Blocks; not for the tick.
RealtimeStatus setUpRealtimeThread(int priority = kHapticPriority);

} // namespace chiron::realtime
