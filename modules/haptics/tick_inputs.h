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

/// One tool's packet as the loop takes it in.
struct ToolInput {
    core::DeviceSample sample;
    std::uint32_t age_us = 0; ///< now - arrival in whole microseconds, saturated: recorded, and what the watchdog uses
};

/// Everything from outside that can change what a tick does. What is here is recorded; what is not here cannot matter.
struct TickInputs {
    std::array<core::Command, core::kMaxCommandsPerTick> commands{}; ///< unused ones are CommandKind::none
    std::uint16_t heartbeatAge_ms = 0; ///< saturated; 0 where no heartbeat is wanted
    std::array<ToolInput, core::kMaxTools> tools{};
    /// When a slow model's answer takes effect; recorded as event_bits::kSlowApplied of the tick in which it did.
    simulation::SlowUpdate slow = simulation::SlowUpdate::asDue;
};

/// Where a loop's inputs come from: devices, people and clocks (LiveInputs), or a recording (RecordedInputs). The seam
/// that makes a replay run the same code as the session did.
class ITickInputs {
public:
    virtual ~ITickInputs() = default;
    /// Fills the inputs of this tick, one tool a device (at most kMaxTools). Thread: haptic; never blocks, allocates or
    /// throws.
    virtual void gather(const realtime::HapticTick& now, std::span<devices::IDevice* const> devices,
                        TickInputs& inputs) noexcept = 0;
};

} // namespace chiron::haptics
