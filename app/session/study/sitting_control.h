// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "session/live_training.h"

namespace chiron::session {

/// The pause and force state that the window of a run requests from the loop. Requests are states, not
/// events: if the window repeats a request, or makes the opposite one before the loop has received the first,
/// the last request wins; a command that found the loop's ring full is sent again.
/// Thread: GUI.
class SittingControl {
public:
    void begin() noexcept; ///< call it for a new session, which must receive the current state

    /// Going on while force is stopped needs rearm().
    void wantPause(bool wanted) noexcept { m_pause = wanted || m_stopped; }
    /// A pause by the run itself: for a break, or while the experimenter is asked.
    void hold(bool held) noexcept { m_hold = held; }
    void stopForce() noexcept;
    void rearm() noexcept;
    void letGo() noexcept; ///< no pause may delay the end of a session

    void tell(LiveTraining& training) noexcept;             ///< sends pending commands; call it each frame
    void look(const haptics::DisplayState& state) noexcept; ///< takes over stops by the supervisor

    bool paused() const noexcept { return m_pause; }
    bool stopped() const noexcept { return m_stopped; }
    bool held() const noexcept { return m_pause || m_hold; }

private:
    bool m_pause = false, m_hold = false;
    bool m_told = false; ///< the loop has been told to pause
    bool m_stopped = false;
    bool m_tellStop = false, m_tellRearm = false;
    bool m_sawLatched = false; ///< the newest state showed a stop or a fault
};

} // namespace chiron::session
