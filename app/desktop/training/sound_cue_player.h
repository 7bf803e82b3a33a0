// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/sound/sound_loader.h"
#include "haptics/display_state.h"

#include <cstddef>
#include <functional>

namespace chiron::desktop {

/// How far the force on a tool leans, rad, as its exercise shows it.
using LeanOfTool = std::function<double(const haptics::DisplayState&, std::size_t tool)>;

/// Force and lean of the tool that is pressed hardest: of several hands the one that matters most. Lean is heard where the level
/// shows it; without `lean`, of none. Pure.
void takeStrongest(const haptics::DisplayState& state, const LeanOfTool& lean, SoundCues& cues);

/// Plays what a level lets be heard of a session, if the station can; says what it is either way. GUI thread.
class SoundCuePlayer {
public:
    explicit SoundCuePlayer(double limit_N) { m_cues.limit_N = limit_N; }

    /// Opens the output (some 0.1 s the first time); empty, or why it stays silent.
    QString open();
    bool works() const noexcept { return m_sound.output && m_sound.output->works(); } ///< an output may turn out to be missing, or go, later
    void setSwitches(const SoundSwitches& on) { m_cues.on = on; }
    void setMuted(bool muted) { m_muted = muted; }
    bool muted() const noexcept { return m_muted; }
    /// Each frame. `held`: paused or stopped.
    void play(const haptics::DisplayState& state, std::uint32_t contacts, bool held, const LeanOfTool& lean = {});
    void silence(); ///< the session is over
    void mask(bool on); ///< masking noise of a study, and nothing else
    const SoundCues& cues() const noexcept { return m_cues; } ///< of the last frame, with an output or without
    bool sounding() const noexcept { return m_sounding; }     ///< they sound now, or would if nobody had switched them off

private:
    SoundCues m_cues;
    bool m_muted = false;
    bool m_sounding = false;
    LoadedSound m_sound;
};

} // namespace chiron::desktop
