// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/command.h"
#include "core/device_sample.h"
#include "devices/api/device.h"
#include "realtime/haptic_tick.h"
#include "simulation/slow_model.h"

#include <array>
#include <cstdint>
#include <span>

namespace chiron::haptics {

/// One tool's packet as the loop receives it.
struct ToolInput {
    core::DeviceSample sample;
    /// now - arrival in whole microseconds, saturated. It is recorded, and the watchdog uses it.
    std::uint32_t age_us = 0;
};

/// All inputs from outside that can change the result of a tick. They are recorded, so nothing else can
/// influence a replay.
struct TickInputs {
    std::array<core::Command, core::kMaxCommandsPerTick> commands{}; ///< unused ones are CommandKind::none
    std::uint16_t heartbeatAge_ms = 0; ///< saturated; 0 if no heartbeat is watched
    std::array<ToolInput, core::kMaxTools> tools{};
    /// When a slow model's answer takes effect; recorded as event_bits::kSlowApplied of the tick in which it
    /// did.
    simulation::SlowUpdate slow = simulation::SlowUpdate::asDue;
};

/// Source of a loop's inputs: devices, people and clocks (LiveInputs), or a recording (RecordedInputs).
/// Because of this interface a replay runs the same code as the session did.
class ITickInputs {
public:
    virtual ~ITickInputs() = default;
    /// Fills the inputs of this tick, one tool per device (at most kMaxTools).
    /// Thread: haptic; never blocks, allocates or throws.
    virtual void gather(const realtime::HapticTick& now, std::span<devices::IDevice* const> devices,
                        TickInputs& inputs) noexcept = 0;
};

} // namespace chiron::haptics
