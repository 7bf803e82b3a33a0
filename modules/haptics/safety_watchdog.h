// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/safety_settings.h"
#include "haptics/safety_tool.h"

#include <algorithm>
#include <cstdint>

namespace chiron::haptics {

/// Sets the watchdog's thresholds for a device of period P (models.md §5): the ramp starts at max(5 ms, 3P),
/// force is zero 10 ms later, and a fault is latched at max(30 ms, 10P), but never before the ramp has ended.
inline void setWatchdog(const SafetySettings& settings, SafetyToolLimits& limits) noexcept {
    const auto atLeast = [&limits](std::uint32_t least_us, std::uint32_t periods) {
        const std::uint64_t age_us =
            std::max<std::uint64_t>(least_us, static_cast<std::uint64_t>(periods) * limits.period_us);
        return static_cast<std::uint32_t>(std::min<std::uint64_t>(age_us, 2'000'000'000));
    };
    limits.watchdogStart_us = atLeast(settings.watchdogStart_us, settings.watchdogStartPeriods);
    limits.watchdogZero_us = limits.watchdogStart_us + settings.watchdogRamp_us;
    limits.watchdogFault_us =
        std::max(atLeast(settings.watchdogFault_us, settings.watchdogFaultPeriods), limits.watchdogZero_us);
}

/// Returns 1 while the newest good packet is young enough, then a value that falls linearly to 0.
/// Thread: haptic.
inline double watchdogScale(const SafetyToolLimits& limits, std::uint32_t age_us) noexcept {
    if (age_us <= limits.watchdogStart_us) {
        return 1.0;
    }
    if (age_us >= limits.watchdogZero_us) {
        return 0.0;
    }
    return static_cast<double>(limits.watchdogZero_us - age_us) /
           static_cast<double>(limits.watchdogZero_us - limits.watchdogStart_us);
}

} // namespace chiron::haptics
