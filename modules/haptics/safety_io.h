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

/// Verdict of the sanity stage on a sample.
enum class Admission : std::uint8_t {
    fresh,    ///< a new good packet: use it
    repeated, ///< the newest packet read again: nothing new; keep the last good state
    dropped,  ///< refused: keep the last good state
};

/// The action of the person, or the event, that has to come before force does. Shown on the screen.
enum class ArmingWait : std::uint8_t {
    nothing,      ///< force is on, or the device renders none
    firstPacket,  ///< a device has not sent a good packet yet, or its packets are late
    smallRequest, ///< move out of contact, or confirm ("Resume here", dead-man) holding the tool still
    holdStill,    ///< confirmed: hold the tool still
    ramp,         ///< the gain is rising
    window,       ///< the window does not respond
    resume,       ///< paused
    stopReleased, ///< the device's stop button is still pressed
    rearm,        ///< stopped or faulted: an explicit re-arm is needed
};

/// Inputs of the supervisor at one tick, in addition to the samples that went through admit(). References are
/// read during the call only.
struct SafetyInput {
    const core::ToolStates& states;       ///< of the last good samples, with velocities, in W
    const simulation::SceneOutput& scene; ///< of this tick: wrenches, energy, events
    std::array<core::Command, core::kMaxCommandsPerTick> commands{};
    std::uint16_t heartbeatAge_ms = 0; ///< age of the newest GUI heartbeat, saturated
    /// Feed-forward that compensates the mechanism's own friction (friction_compensation.h).
    std::array<core::Wrench, core::kMaxTools> compensation_W{};
};

/// Output of the supervisor for one tool.
struct SafeTool {
    core::Wrench wrench_W; ///< the "commanded" wrench on the tool, in W, about the tip; for the record
    core::Wrench wrench_D; ///< the same in D (Hᵀ; unscaled), with compensation_D; for the device
    /// Friction compensation that was let through. It is not felt as tissue, so it is not part of
    /// "commanded".
    core::Wrench compensation_D;
    /// Display of a fingertip platform, scaled with the share of the wrench that was let through; level if
    /// there was none. For the tool in W; for the screen.
    core::DisplayPose display;
    /// The same for the tool in D, mirrored if the workspace is. For the device.
    core::DisplayPose display_D;
    bool enabled = false;    ///< motors on; false: the wrench is zero
    bool noMovement = false; ///< input-only device silent for 2 s
};

struct SafetyOutput {
    int count = 0;
    std::array<SafeTool, core::kMaxTools> tools{};
    core::ForceState force = core::ForceState::off; ///< remains `off` if no tool renders force
    std::uint32_t guards = 0;                       ///< core::guard_bits that act in this tick
    ArmingWait waitsFor = ArmingWait::firstPacket;
    bool forceReady = false; ///< full gain; always true if no tool renders force
    bool paused = false;     ///< from the tick of the pause command up to the one before the resume command
    double gain = 0.0;       ///< 0..1, for the screen
    double energySupplied_J = 0.0; ///< see core::TickHeader
    double energyStored_J = 0.0;
    double energyKept_J = 0.0;     ///< PassivityController::kept_J()
    double energyWithheld_J = 0.0; ///< PassivityController::withheld_J()
    /// Balance of the passivity stage itself: supplied energy, including what was credited, forgiven and cut
    /// (passivity_controller.h).
    double energyBook_J = 0.0;
};

} // namespace chiron::haptics
