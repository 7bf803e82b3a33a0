// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/display_state.h"
#include "session/live_training.h"

#include <cstdint>

namespace chiron::desktop {

/// Sends the requests from the buttons and keys of the training screen to a session as commands, and
/// remembers what was requested, because the newest state may not show it yet. Stopping force also stops the
/// trial's clock, because nobody can work without force.
/// Thread: GUI; the session outlives it.
class SessionControl {
public:
    explicit SessionControl(session::LiveTraining& training) : m_training(training) {}

    void begin() { post(core::CommandKind::start); } ///< starts the first trial
    void stopForce();
    void pause();
    void resume(); ///< does nothing while stopped; that requires rearm()
    void pauseOrResume() { m_paused ? resume() : pause(); }
    void rearm(); ///< after a stop or a fault: re-arms force explicitly and continues the trial
    /// Delays the next trial while the result of the last one is shown. This is not the person's own pause:
    /// paused() does not report it, and their own pause outlasts it.
    void keepNext(bool kept);
    void resumeHere() { post(core::CommandKind::confirmHold); }
    void mark() { post(core::CommandKind::mark); }
    void report(std::uint16_t word) { m_training.post(core::CommandKind::report, word); }
    void end() { post(core::CommandKind::end); }

    bool paused() const noexcept { return m_paused; }
    bool stopped() const noexcept { return m_stopped; }
    bool held() const noexcept { return m_paused || m_stopped; }
    /// Detects what the supervisor did by itself, such as a stop by the device's own stop button.
    void look(const haptics::DisplayState& state) noexcept;

private:
    void post(core::CommandKind kind) { m_training.post(kind); }

    session::LiveTraining& m_training;
    bool m_paused = false;
    bool m_kept = false; ///< the next trial is delayed
    bool m_stopped = false;
    bool m_sawLatched = false; ///< the newest state showed a stop or a fault
};

} // namespace chiron::desktop
