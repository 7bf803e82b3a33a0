// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/sound/sound_loader.h"
#include "haptics/display_state.h"

namespace chiron::desktop {

/// Plays what a level lets be heard of a session, if the station can. GUI thread.
class SoundCuePlayer {
public:
    explicit SoundCuePlayer(double limit_N) { m_cues.limit_N = limit_N; }

    /// Opens the output (some 0.1 s the first time); empty, or why it stays silent.
    QString open();
    void setMuted(bool muted) { m_muted = muted; }
    bool muted() const noexcept { return m_muted; }
    /// Each frame. `held`: paused or stopped.
    void play(const haptics::DisplayState& state, std::uint32_t contacts, bool held);
    void silence(); ///< the session is over

private:
    SoundCues m_cues;
    bool m_muted = false;
    LoadedSound m_sound;
};

} // namespace chiron::desktop
