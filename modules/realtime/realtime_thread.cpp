// SPDX-License-Identifier: GPL-3.0-or-later
#include "realtime/realtime_thread.h"

#include "core/fp_environment.h"

#include <cerrno>
#include <cstring>
#include <pthread.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>

namespace chiron::realtime {

namespace {

[[gnu::noinline]] void touchStack() noexcept {
    constexpr std::size_t kPage_bytes = 4096;
    volatile unsigned char room[kTouchedStack_bytes];
    for (std::size_t i = 0; i < sizeof room; i += kPage_bytes)
        room[i] = 0;
}

void askForPriority(int priority, RealtimeStatus& status) {
    sched_param parameter{};
    parameter.sched_priority = priority;
    const int error = pthread_setschedparam(pthread_self(), SCHED_FIFO, &parameter);
    status.priorityGranted = error == 0;
    status.priorityDetail = error == 0 ? "SCHED_FIFO priority " + std::to_string(priority)
                                       : std::string("no real-time priority: ") + std::strerror(error) +
                                             " (an rtprio limit of at least " + std::to_string(priority) +
                                             " for this user would permit it)";
}

void lockMemory(RealtimeStatus& status) {
    rlimit limit{};
    const bool unlimited = getrlimit(RLIMIT_MEMLOCK, &limit) == 0 && limit.rlim_cur == RLIM_INFINITY;
    if (!unlimited) {
        status.memoryDetail = "memory not locked: the memlock limit is " + std::to_string(limit.rlim_cur) +
                              " bytes, unlimited would permit it";
        return;
    }
    // ONFAULT locks only pages that were touched, so that memory that was merely reserved does not fill the
    // machine.
    status.memoryLocked = mlockall(MCL_CURRENT | MCL_FUTURE | MCL_ONFAULT) == 0;
    status.memoryDetail =
        status.memoryLocked ? "memory locked" : std::string("memory not locked: ") + std::strerror(errno);
}

} // namespace

RealtimeStatus setUpRealtimeThread(int priority) {
    RealtimeStatus status;
    core::setModelFloatingPointEnvironment();
    touchStack();
    // In ns; the default slack of 50 µs is half of the time that we spin.
    prctl(PR_SET_TIMERSLACK, 1UL, 0UL, 0UL, 0UL);
    askForPriority(priority, status);
    lockMemory(status);
    return status;
}

} // namespace chiron::realtime
