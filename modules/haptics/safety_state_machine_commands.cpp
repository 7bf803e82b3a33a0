// SPDX-License-Identifier: GPL-3.0-or-later
// Commands of people to the state machine: pause, resume, confirm, stop, re-arm.
#include "haptics/safety_state_machine.h"

namespace chiron::haptics {

using core::CommandKind;
using core::ForceState;
namespace guard_bits = core::guard_bits;

void SafetyStateMachine::applyCommands(const SafetyConditions& in) noexcept {
    bool stopAsked = false;
    for (const core::Command& command : in.commands) {
        switch (command.kind) {
        case CommandKind::pause:
            pause();
            break;
        case CommandKind::resume:
            resume();
            break;
        case CommandKind::rearm:
            rearm(in);
            break;
        case CommandKind::confirmHold:
            m_confirmed = m_confirmed || m_state == ForceState::arming;
            break;
        case CommandKind::stopForce:
            stopAsked = true;
            break;
        default:
            break;
        }
    }
    // Stop overrides every other command of the same tick, in either order.
    if (stopAsked && m_mask.has(GuardMask::kStop)) {
        stop();
    }
}

void SafetyStateMachine::pause() noexcept {
    m_paused = true;
    if (!m_mask.has(GuardMask::kPause)) {
        return;
    }
    if (forceMayFlow()) {
        m_state = m_gain > 0 ? ForceState::pausing : ForceState::paused;
    }
}

void SafetyStateMachine::resume() noexcept {
    if (!m_paused) {
        return;
    }
    m_paused = false;
    m_dampingGain = 0;
    if (m_state == ForceState::pausing || m_state == ForceState::paused) {
        startArming();
    }
}

void SafetyStateMachine::rearm(const SafetyConditions& in) noexcept {
    if (m_state != ForceState::stopped && m_state != ForceState::fault) {
        return;
    }
    // A cause that still holds keeps the latch. Bad packets alone do not, because their reference is taken
    // anew.
    if (in.stopButton || (in.faults & ~guard_bits::kSampleFault) != 0) {
        return;
    }
    m_latched = 0;
    m_rearmed = true;
    startArming();
    if (m_paused) {
        m_state = ForceState::paused;
    }
}

void SafetyStateMachine::stop() noexcept {
    m_gain = 0;
    m_dampingGain = 0;
    m_latched |= guard_bits::kStop;
    if (m_state != ForceState::fault) {
        m_state = ForceState::stopped;
    }
}

} // namespace chiron::haptics
