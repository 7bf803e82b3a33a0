// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "database/boot_clock.h"

#include <cstdint>
#include <string>

namespace chiron::database {

/// The stored state, per account, of the delay that slows down guessing.
struct ThrottleState {
    std::int64_t failures = 0; ///< attempts since the last correct password
    std::string boot;          ///< boot to which waitUntil_ns refers
    std::int64_t waitUntil_ns = 0;
};

/// Returns the wait after this many failures: none for the first two, 2 s after the third, doubling up to 5
/// minutes.
std::int64_t throttleWait_ns(std::int64_t failures) noexcept;

/// Returns how long the account still has to wait; 0: it may try. After a restart of the machine the whole
/// wait starts again from now (the state is changed accordingly), so that setting a clock or restarting never
/// shortens it.
std::int64_t throttleRemaining_ns(ThrottleState& state, const BootTime& now) noexcept;

/// Counts one attempt as failed, before it is checked.
void throttleCount(ThrottleState& state, const BootTime& now) noexcept;

} // namespace chiron::database
