// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/accounts/throttle.h"

#include <algorithm>

namespace chiron::database {
namespace {
constexpr std::int64_t kSecond_ns = 1'000'000'000;
constexpr std::int64_t kFreeAttempts = 3;
constexpr std::int64_t kLongest_ns = 300 * kSecond_ns;
constexpr std::int64_t kMaximumCount = 1'000'000'000; // limit of the column's CHECK
} // namespace

std::int64_t throttleWait_ns(std::int64_t failures) noexcept {
    if (failures < kFreeAttempts) {
        return 0;
    }
    const std::int64_t doublings = std::min<std::int64_t>(failures - kFreeAttempts + 1, 20);
    return std::min(kLongest_ns, kSecond_ns << doublings);
}

std::int64_t throttleRemaining_ns(ThrottleState& state, const BootTime& now) noexcept {
    const std::int64_t whole = throttleWait_ns(state.failures);
    if (whole == 0) {
        return 0;
    }
    if (state.boot != now.bootId) {
        state.boot = now.bootId;
        state.waitUntil_ns = now.now_ns + whole;
    }
    return std::clamp<std::int64_t>(state.waitUntil_ns - now.now_ns, 0, whole);
}

void throttleCount(ThrottleState& state, const BootTime& now) noexcept {
    state.failures = std::min(state.failures + 1, kMaximumCount);
    state.boot = now.bootId;
    state.waitUntil_ns = now.now_ns + throttleWait_ns(state.failures);
}

} // namespace chiron::database
