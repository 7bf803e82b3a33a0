// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session_state.h"
#include "haptics/safety_guard_mask.h"
#include "haptics/safety_io.h"
#include "haptics/safety_settings.h"

#include <array>
#include <cstdint>

namespace chiron::haptics {

/// Inputs of the state machine in one tick, over all tools that render force (stopButton: over all tools).
struct SafetyConditions {
    std::array<core::Command, core::kMaxCommandsPerTick> commands{};
    std::uint32_t faults = 0;   ///< guard_bits whose causes hold now; any of them latches a fault
    double watchdogScale = 1.0; ///< 1 fresh .. 0 late
    std::uint16_t heartbeatAge_ms = 0;
    bool stopButton = false;
    bool deadMan = false;
    bool allGood = false; ///< every tool has sent a good packet
    bool sceneChanged = false;
    bool requestSmall = false; ///< below the arming thresholds
    bool still = false;        ///< slower than the still speed
    bool tooFast = false;      ///< faster than the over-velocity limit
};

/// Decides the one gain (0..1) that multiplies every requested force (models.md §5: arming, pause, stop,
/// frozen window, watchdog's ramp, faults). One step per tick; ramps are counted in executed ticks.
class SafetyStateMachine {
public:
    void reset(const SafetySettings& settings, GuardMask mask) noexcept;
    void step(const SafetyConditions& in) noexcept;

    core::ForceState state() const noexcept { return m_state; }
    double gain() const noexcept; ///< 0..1
    /// Gain of the damping that alone may be shown while over-velocity is latched; 0 otherwise.
    double dampingGain() const noexcept;
    std::uint32_t guards() const noexcept { return m_guards; } ///< of the last step
    ArmingWait waitsFor() const noexcept { return m_waitsFor; }
    bool paused() const noexcept { return m_paused; }
    bool rearmedThisStep() const noexcept { return m_rearmed; }

private:
    void applyCommands(const SafetyConditions& in) noexcept;
    void pause() noexcept;
    void resume() noexcept;
    void rearm(const SafetyConditions& in) noexcept;
    void stop() noexcept;
    void latchFaults(const SafetyConditions& in) noexcept;
    void latchOverVelocity(const SafetyConditions& in) noexcept;
    void leaveOldScene() noexcept;
    void startArming() noexcept;
    void stepState(const SafetyConditions& in) noexcept;
    void stepArming(const SafetyConditions& in) noexcept;
    void stepForce(const SafetyConditions& in) noexcept;
    void stepPausing(const SafetyConditions& in) noexcept;
    void stepDamping(const SafetyConditions& in) noexcept;
    void lowerGain(std::uint32_t ramp_ms) noexcept;
    void followWatchdog(const SafetyConditions& in) noexcept;
    bool forceMayFlow() const noexcept;
    bool windowFrozen(const SafetyConditions& in) const noexcept;
    void noteGuards() noexcept;
    ArmingWait wait(const SafetyConditions& in) const noexcept;

    SafetySettings m_settings;
    GuardMask m_mask;
    core::ForceState m_state = core::ForceState::off;
    ArmingWait m_waitsFor = ArmingWait::firstPacket;
    std::uint32_t m_latched = 0;
    std::uint32_t m_guards = 0;
    std::uint32_t m_quietTicks = 0;
    std::uint32_t m_stillTicks = 0;
    std::uint32_t m_gain = 0; ///< in billionths
    std::uint32_t m_dampingGain = 0;
    bool m_confirmed = false;
    bool m_paused = false;
    bool m_rearmed = false;
};

} // namespace chiron::haptics
