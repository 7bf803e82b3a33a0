// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/loop_self_test.h"

#include "realtime/monotonic_clock.h"

#include <thread>

namespace chiron::session {

SelfTestResult selfTestOnOwnThread(SelfTestTask& task, const std::atomic<bool>& cancel) {
    SelfTestResult result;
    std::thread haptic([&] {
        result.granted = realtime::setUpRealtimeThread();
        realtime::MonotonicClock clock;
        result.loop = runSelfTest(clock, task, cancel);
    });
    haptic.join();
    result.loop.priorityGranted = result.granted.priorityGranted;
    result.loop.priorityDetail = result.granted.priorityDetail;
    result.cancelled = cancel.load(std::memory_order_relaxed);
    return result;
}

} // namespace chiron::session
