// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/report_word.h"
#include "haptics/display_state.h"
#include "session/live_training.h"

namespace chiron::desktop {

/// What the buttons and keys of the training screen ask of a session, as commands; and what was asked, which the newest
/// state may not show yet. Stopping force also stands the trial's clock still: nobody can work without it. GUI thread; the
/// session outlives it.
class SessionControl {
public:
    explicit SessionControl(session::LiveTraining& training) : m_training(training) {}

    void begin() { post(core::CommandKind::start); } ///< the first trial
    void stopForce();
    void pause();
    void resume(); ///< nothing while stopped: that takes rearm()
    void pauseOrResume() { m_paused ? resume() : pause(); }
    void rearm(); ///< after a stop or a fault: explicit, and the trial goes on
    /// Between two trials: what came of the last one is looked at, and the next does not begin yet. No pause of the person's: paused() says
    /// nothing of it, and their own pause outlasts it.
    void keepNext(bool kept);
    void resumeHere() { post(core::CommandKind::confirmHold); }
    void mark() { post(core::CommandKind::mark); }
    void report(core::ReportField field, unsigned value) { m_training.post(core::CommandKind::report, core::reportWord(field, value)); }
    void end() { post(core::CommandKind::end); }

    bool paused() const noexcept { return m_paused; }
    bool stopped() const noexcept { return m_stopped; }
    bool held() const noexcept { return m_paused || m_stopped; }
    /// Takes in what the supervisor did by itself: a device's own stop button.
    void look(const haptics::DisplayState& state) noexcept;

private:
    void post(core::CommandKind kind) { m_training.post(kind); }

    session::LiveTraining& m_training;
    bool m_paused = false;
    bool m_kept = false; ///< the next trial
    bool m_stopped = false;
    bool m_sawLatched = false; ///< the newest state showed a stop or a fault
};

} // namespace chiron::desktop
