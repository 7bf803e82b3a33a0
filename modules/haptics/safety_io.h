// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/command.h"
#include "core/geometry.h"
#include "core/session_state.h"
#include "core/tool_state.h"
#include "simulation/scene.h"

#include <array>
#include <cstdint>

namespace chiron::haptics {

/// What became of a sample at the sanity stage.
enum class Admission : std::uint8_t {
    fresh,    ///< a new good packet: use it
    repeated, ///< the newest packet read again: nothing new; go on with the last good state
    dropped,  ///< refused: go on with the last good state
};

/// What the person has to do, or to wait for, before force comes. Shown on the screen.
enum class ArmingWait : std::uint8_t {
    nothing,      ///< force is on, or the device renders none
    firstPacket,  ///< a device has not sent a good packet yet, or its packets are late
    smallRequest, ///< move out of contact, or confirm ("Resume here", dead-man) holding the tool still
    holdStill,    ///< confirmed: hold the tool still
    ramp,         ///< the gain is rising
    window,       ///< the window does not answer
    resume,       ///< paused
    stopReleased, ///< the device's stop button is still pressed
    rearm,        ///< stopped or faulted: re-arm explicitly
};

/// What the supervisor needs at a tick beside the samples that went through admit(). References are read
/// during the call only.
struct SafetyInput {
    const core::ToolStates& states;       ///< of the last good samples, with velocities, in W
    const simulation::SceneOutput& scene; ///< of this tick: wrenches, energy, events
    std::array<core::Command, core::kMaxCommandsPerTick> commands{};
    std::uint16_t heartbeatAge_ms = 0; ///< age of the newest GUI heartbeat, saturated
    std::array<core::Wrench, core::kMaxTools> compensation_W{}; ///< feed-forward of the mechanism's own friction (friction_compensation.h)
};

/// What one tool may do.
struct SafeTool {
    core::Wrench wrench_W;   ///< "commanded": on the tool, in W, about the tip. Record this one
    core::Wrench wrench_D;   ///< the same in D (Hᵀ; unscaled), with compensation_D. Hand this one to the device
    core::Wrench compensation_D; ///< what is let through of the friction's compensation: not felt as tissue, so it is not "commanded"
    core::DisplayPose display; ///< of a fingertip platform, scaled with what was let through of the wrench; level where none was. For
                               ///< the tool in W: show this one
    core::DisplayPose display_D; ///< the same for the tool in D, mirrored where the workspace is. Hand this one to the device
    bool enabled = false;    ///< motors on; false: the wrench is zero
    bool noMovement = false; ///< input-only device silent for 2 s
};

struct SafetyOutput {
    int count = 0;
    std::array<SafeTool, core::kMaxTools> tools{};
    core::ForceState force = core::ForceState::off; ///< `off` for good where no tool renders force
    std::uint32_t guards = 0;                       ///< core::guard_bits that act in this tick
    ArmingWait waitsFor = ArmingWait::firstPacket;
    bool forceReady = false; ///< full gain; always true where no tool renders force
    bool paused = false;     ///< from the pause command's tick up to the tick before the resume command's
    double gain = 0.0;       ///< 0..1, for the screen
    double energySupplied_J = 0.0; ///< see core::TickHeader
    double energyStored_J = 0.0;
    double energyKept_J = 0.0; ///< PassivityController::kept_J()
    double energyBook_J = 0.0; ///< the passivity stage's own: supplied, with what was credited, forgiven and cut (passivity_controller.h)
};

} // namespace chiron::haptics
