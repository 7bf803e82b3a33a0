// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "database/boot_clock.h"

#include <cstdint>
#include <string>

namespace chiron::database {

/// What slows down guessing, per account, as stored.
struct ThrottleState {
    std::int64_t failures = 0; ///< attempts since the last right password
    std::string boot;          ///< in which boot waitUntil_ns counts
    std::int64_t waitUntil_ns = 0;
};

/// Wait after so many failures: none for the first two, 2 s after the third, doubling up to 5 minutes.
std::int64_t throttleWait_ns(std::int64_t failures) noexcept;

/// How long to wait still; 0: try. After a restart of the machine the whole wait counts again, from now (the
/// state is changed accordingly): setting a clock or restarting never shortens it.
std::int64_t throttleRemaining_ns(ThrottleState& state, const BootTime& now) noexcept;

/// Counts one attempt as failed, before it is checked.
void throttleCount(ThrottleState& state, const BootTime& now) noexcept;

} // namespace chiron::database
