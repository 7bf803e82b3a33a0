// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "session/live_training.h"

namespace chiron::session {

/// What a sitting's window asks of the loop about pause and force. Wishes, not events: who asks twice, or for the opposite before the loop
/// has heard, gets what was asked for last; what found no room in the loop's ring is told again. GUI thread.
class SittingControl {
public:
    void begin() noexcept; ///< of a new session: it is told what holds already

    void wantPause(bool wanted) noexcept { m_pause = wanted || m_stopped; } ///< going on while force is stopped takes rearm()
    void hold(bool held) noexcept { m_hold = held; } ///< a pause of the sitting's own: a break, the experimenter is asked
    void stopForce() noexcept;
    void rearm() noexcept;
    void letGo() noexcept; ///< what ends, ends: no pause keeps it

    void tell(LiveTraining& training) noexcept;               ///< each frame
    void look(const haptics::DisplayState& state) noexcept;   ///< takes in what the supervisor did by itself

    bool paused() const noexcept { return m_pause; }
    bool stopped() const noexcept { return m_stopped; }
    bool held() const noexcept { return m_pause || m_hold; }

private:
    bool m_pause = false, m_hold = false;
    bool m_told = false;    ///< a pause, to the loop
    bool m_stopped = false;
    bool m_tellStop = false, m_tellRearm = false;
    bool m_sawLatched = false; ///< the newest state showed a stop or a fault
};

} // namespace chiron::session
