// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

namespace chiron::core {

/// Returns CLOCK_MONOTONIC in nanoseconds; lock-free (vDSO).
std::int64_t monotonicNow_ns() noexcept;

/// Returns the wall-clock time as ISO 8601 in UTC with milliseconds, e.g. 2026-11-20T11:23:45.678Z. It is a
/// label and never used for ordering.
std::string utcNowIso8601();

} // namespace chiron::core
