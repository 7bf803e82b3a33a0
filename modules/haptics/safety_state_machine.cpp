// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/safety_state_machine.h"

#include <algorithm>

namespace chiron::haptics {

using core::ForceState;
namespace guard_bits = core::guard_bits;

namespace {

/// The gain is counted in billionths, so that a ramp of n ticks ends after exactly n ticks.
constexpr std::uint32_t kFullGain = 1'000'000'000;

/// A falling ramp is never slower than requested ...
constexpr std::uint32_t fallOf(std::uint32_t ramp_ms) noexcept {
    return ramp_ms == 0 ? kFullGain : (kFullGain + ramp_ms - 1) / ramp_ms;
}

/// ... and a rising one never faster: the division's remainder is made up in the last tick.
constexpr std::uint32_t raised(std::uint32_t gain, std::uint32_t ramp_ms) noexcept {
    const std::uint32_t next = gain + kFullGain / std::max(ramp_ms, 1u);
    return next + ramp_ms >= kFullGain ? kFullGain : next;
}

std::uint32_t gainOf(double scale) noexcept {
    return static_cast<std::uint32_t>(std::clamp(scale, 0.0, 1.0) * kFullGain);
}

} // namespace

void SafetyStateMachine::reset(const SafetySettings& settings, GuardMask mask) noexcept {
    *this = SafetyStateMachine();
    m_settings = settings;
    m_mask = mask;
}

double SafetyStateMachine::gain() const noexcept {
    return static_cast<double>(m_gain) / kFullGain;
}

double SafetyStateMachine::dampingGain() const noexcept {
    return static_cast<double>(m_dampingGain) / kFullGain;
}

void SafetyStateMachine::step(const SafetyConditions& in) noexcept {
    m_guards = in.watchdogScale < 1.0 ? guard_bits::kWatchdog : 0;
    m_rearmed = false;
    applyCommands(in);
    latchFaults(in);
    if (in.stopButton && m_mask.has(GuardMask::kStop)) {
        stop();
    }
    if (in.sceneChanged && m_mask.has(GuardMask::kArming)) {
        leaveOldScene();
    }
    stepState(in);
    latchOverVelocity(in);
    m_rearmed = m_rearmed && m_state != ForceState::stopped && m_state != ForceState::fault;
    noteGuards();
    m_waitsFor = wait(in);
}

void SafetyStateMachine::latchFaults(const SafetyConditions& in) noexcept {
    const std::uint32_t faults = m_rearmed ? in.faults & ~guard_bits::kSampleFault : in.faults;
    if (faults == 0) {
        return;
    }
    m_latched |= faults;
    m_state = ForceState::fault;
    m_gain = 0;
    m_dampingGain = 0;
}

void SafetyStateMachine::latchOverVelocity(const SafetyConditions& in) noexcept {
    if (!in.tooFast || m_gain == 0 || !m_mask.has(GuardMask::kOverVelocity)) {
        return;
    }
    // The damping has at most the gain that force had, and none if force was already ramping down: such a
    // ramp ends at zero.
    const bool leaving = m_state == ForceState::pausing || m_state == ForceState::heldByHeartbeat;
    m_dampingGain = leaving ? 0 : m_gain;
    m_latched |= guard_bits::kOverVelocity;
    m_state = ForceState::fault;
    m_gain = 0;
}

void SafetyStateMachine::leaveOldScene() noexcept {
    m_dampingGain = 0;
    if (m_state == ForceState::pausing) {
        m_gain = 0;
        m_state = ForceState::paused;
    } else if (forceMayFlow()) {
        startArming();
    }
}

void SafetyStateMachine::startArming() noexcept {
    m_state = ForceState::arming;
    m_gain = 0;
    m_dampingGain = 0;
    m_quietTicks = 0;
    m_stillTicks = 0;
    m_confirmed = false;
}

void SafetyStateMachine::stepState(const SafetyConditions& in) noexcept {
    switch (m_state) {
    case ForceState::off:
        if (in.allGood) {
            startArming();
            m_state = m_paused ? ForceState::paused : ForceState::arming;
        }
        break;
    case ForceState::arming:
        stepArming(in);
        break;
    case ForceState::ramping:
    case ForceState::on:
    case ForceState::heldByWatchdog:
    case ForceState::heldByHeartbeat:
        stepForce(in);
        break;
    case ForceState::pausing:
        stepPausing(in);
        break;
    case ForceState::fault:
        stepDamping(in);
        break;
    case ForceState::paused:
    case ForceState::stopped:
        break;
    }
}

void SafetyStateMachine::stepArming(const SafetyConditions& in) noexcept {
    if (windowFrozen(in)) {
        m_state = ForceState::heldByHeartbeat;
        return;
    }
    if (!in.allGood || in.watchdogScale < 1.0) {
        m_quietTicks = 0;
        m_stillTicks = 0;
        return;
    }
    if (!m_mask.has(GuardMask::kArming)) {
        m_state = ForceState::on;
        m_gain = kFullGain;
        return;
    }
    m_quietTicks = in.requestSmall ? m_quietTicks + 1 : 0;
    m_stillTicks = in.still && (in.deadMan || m_confirmed) ? m_stillTicks + 1 : 0;
    if (m_quietTicks >= m_settings.armingQuiet_ticks || m_stillTicks >= m_settings.stillTime_ms) {
        m_state = ForceState::ramping;
    }
}

void SafetyStateMachine::stepForce(const SafetyConditions& in) noexcept {
    if (windowFrozen(in)) {
        m_state = ForceState::heldByHeartbeat;
    }
    if (m_state == ForceState::heldByHeartbeat) {
        // A ramp that has begun ends at zero; a window that responds again resumes through arming.
        if (m_gain == 0 && !windowFrozen(in)) {
            startArming();
            return;
        }
        lowerGain(m_settings.heartbeatRamp_ms);
        followWatchdog(in);
        return;
    }
    if (in.watchdogScale < 1.0) {
        m_state = ForceState::heldByWatchdog;
        followWatchdog(in);
        return;
    }
    if (m_state == ForceState::on) {
        return;
    }
    // After late samples the gain rises from its present value at the rate of the arming ramp, so that there
    // is no kick.
    m_state = ForceState::ramping;
    m_gain = raised(m_gain, m_settings.armingRamp_ms);
    if (m_gain == kFullGain) {
        m_state = ForceState::on;
    }
}

void SafetyStateMachine::stepPausing(const SafetyConditions& in) noexcept {
    lowerGain(m_settings.pauseRamp_ms);
    followWatchdog(in);
    if (m_gain == 0) {
        m_state = ForceState::paused;
    }
}

void SafetyStateMachine::stepDamping(const SafetyConditions& in) noexcept {
    // Damping needs a current velocity and a person who is present: a frozen window or a pause ends it at
    // once.
    const bool mayDamp = !windowFrozen(in) && !(m_paused && m_mask.has(GuardMask::kPause));
    m_dampingGain = mayDamp ? std::min(m_dampingGain, gainOf(in.watchdogScale)) : 0;
}

void SafetyStateMachine::lowerGain(std::uint32_t ramp_ms) noexcept {
    m_gain -= std::min(m_gain, fallOf(ramp_ms));
}

void SafetyStateMachine::followWatchdog(const SafetyConditions& in) noexcept {
    m_gain = std::min(m_gain, gainOf(in.watchdogScale));
}

bool SafetyStateMachine::forceMayFlow() const noexcept {
    return m_state == ForceState::arming || m_state == ForceState::ramping || m_state == ForceState::on ||
           m_state == ForceState::heldByWatchdog || m_state == ForceState::heldByHeartbeat;
}

bool SafetyStateMachine::windowFrozen(const SafetyConditions& in) const noexcept {
    return m_settings.heartbeatWatched && m_mask.has(GuardMask::kHeartbeat) &&
           in.heartbeatAge_ms >= m_settings.heartbeatLimit_ms;
}

void SafetyStateMachine::noteGuards() noexcept {
    m_guards |= m_latched;
    switch (m_state) {
    case ForceState::arming:
    case ForceState::ramping:
        m_guards |= guard_bits::kArming;
        break;
    case ForceState::pausing:
    case ForceState::paused:
        m_guards |= guard_bits::kPause;
        break;
    case ForceState::heldByHeartbeat:
        m_guards |= guard_bits::kHeartbeat;
        break;
    default:
        break;
    }
}

ArmingWait SafetyStateMachine::wait(const SafetyConditions& in) const noexcept {
    switch (m_state) {
    case ForceState::off:
    case ForceState::heldByWatchdog:
        return ArmingWait::firstPacket;
    case ForceState::arming:
        if (!in.allGood || in.watchdogScale < 1.0) {
            return ArmingWait::firstPacket;
        }
        return m_confirmed || in.deadMan ? ArmingWait::holdStill : ArmingWait::smallRequest;
    case ForceState::ramping:
        return ArmingWait::ramp;
    case ForceState::on:
        return ArmingWait::nothing;
    case ForceState::heldByHeartbeat:
        return ArmingWait::window;
    case ForceState::pausing:
    case ForceState::paused:
        return ArmingWait::resume;
    case ForceState::stopped:
    case ForceState::fault:
        break;
    }
    return in.stopButton ? ArmingWait::stopReleased : ArmingWait::rearm;
}

} // namespace chiron::haptics
