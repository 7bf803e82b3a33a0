// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/training/session_control.h"

namespace chiron::desktop {

using core::CommandKind;

void SessionControl::stopForce() {
    post(CommandKind::stopForce);
    m_stopped = true;
    pause();
}

void SessionControl::pause() {
    if (m_paused)
        return;
    post(CommandKind::pause);
    m_paused = true;
}

void SessionControl::resume() {
    if (!m_paused || m_stopped)
        return;
    if (!m_kept)
        post(CommandKind::resume);
    m_paused = false;
}

void SessionControl::keepNext(bool kept) {
    if (kept == m_kept)
        return;
    m_kept = kept;
    if (!m_paused)
        post(kept ? CommandKind::pause : CommandKind::resume);
}

void SessionControl::rearm() {
    post(CommandKind::rearm);
    if (!m_stopped)
        return;
    m_stopped = false;
    resume();
}

void SessionControl::look(const haptics::DisplayState& state) noexcept {
    const bool latched = state.force == core::ForceState::stopped || state.force == core::ForceState::fault;
    if (!latched || m_stopped || m_sawLatched) {
        m_sawLatched = latched;
        return;
    }
    m_sawLatched = true; // once per latch, because this state may not show later requests yet
    m_stopped = true;
    pause();
}

} // namespace chiron::desktop
