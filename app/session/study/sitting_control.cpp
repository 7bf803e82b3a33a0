// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/study/sitting_control.h"

namespace chiron::session {

using core::CommandKind;

void SittingControl::begin() noexcept {
    m_told = m_tellRearm = m_sawLatched = false;
    m_tellStop = m_stopped;
}

void SittingControl::stopForce() noexcept {
    m_stopped = m_tellStop = m_pause = true;
    m_tellRearm = false;
}

void SittingControl::rearm() noexcept {
    if (!m_stopped)
        return;
    m_tellRearm = true; // even if the stop was not sent yet: the loop receives both, in this order
    m_stopped = m_pause = false;
}

void SittingControl::letGo() noexcept {
    m_pause = m_hold = false;
}

void SittingControl::tell(LiveTraining& training) noexcept {
    if (m_tellStop && training.post(CommandKind::stopForce))
        m_tellStop = false;
    if (!m_tellStop && m_tellRearm && training.post(CommandKind::rearm))
        m_tellRearm = false;
    if (m_told != held() && training.post(held() ? CommandKind::pause : CommandKind::resume))
        m_told = held();
}

void SittingControl::look(const haptics::DisplayState& state) noexcept {
    const bool latched = state.force == core::ForceState::stopped || state.force == core::ForceState::fault;
    if (latched && !m_sawLatched && !m_stopped)
        // Only once per latch: this state may not include later requests yet.
        m_stopped = m_pause = true;
    m_sawLatched = latched;
}

} // namespace chiron::session
