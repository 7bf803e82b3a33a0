// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "realtime/haptic_tick.h"

#include <atomic>
#include <cstdint>
#include <type_traits>
#include <utility>

namespace chiron::realtime {

/// Timing of one executed tick, as its runner measured it.
struct TickTiming {
    std::int64_t lateness_ns = 0; ///< start - deadline, ≥ 0
    std::int64_t duration_ns = 0; ///< of task.tick()
    std::uint32_t skipped = 0;    ///< deadlines skipped before this tick
};

/// A task that a runner drives: `tick(const HapticTick&) noexcept`, which returns nothing, or a bool where
/// false means stop after this tick. Optional: `timing(const TickTiming&) noexcept`, called after each tick
/// (statistics of the loop).
template <class T>
concept TickTask = requires(T& task, const HapticTick& now) {
    { task.tick(now) } noexcept;
    requires std::is_same_v<decltype(task.tick(now)), void> || std::is_same_v<decltype(task.tick(now)), bool>;
};

template <class T>
concept ObservesTiming = requires(T& task, const TickTiming& timing) {
    { task.timing(timing) } noexcept;
};

/// Runs one tick; returns true if the run goes on.
template <TickTask Task> bool runTick(Task& task, const HapticTick& now) noexcept {
    if constexpr (std::is_same_v<decltype(task.tick(now)), bool>) {
        return task.tick(now);
    } else {
        task.tick(now);
        return true;
    }
}

} // namespace chiron::realtime
