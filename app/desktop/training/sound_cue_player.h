// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/sound/sound_loader.h"
#include "haptics/display_state.h"

#include <cstddef>
#include <functional>

namespace chiron::desktop {

/// How far the force on a tool leans, in rad, as its exercise shows it.
using LeanOfTool = std::function<double(const haptics::DisplayState&, std::size_t tool)>;

/// Writes the force and lean of the tool with the largest force to `cues`. Lean is audible only if the level
/// shows it; without `lean` there is none. Pure.
void takeStrongest(const haptics::DisplayState& state, const LeanOfTool& lean, SoundCues& cues);

/// Plays the sound cues that the level allows, if the station has sound, and reports them in either case.
/// Thread: GUI.
class SoundCuePlayer {
public:
    explicit SoundCuePlayer(double limit_N) { m_cues.limit_N = limit_N; }

    /// Opens the output (some 0.1 s the first time). Returns an empty text, or the reason why there is no
    /// sound.
    QString open();
    /// False if there is no output; an output may also turn out to be missing, or disappear, later.
    bool works() const noexcept { return m_sound.output && m_sound.output->works(); }
    void setSwitches(const SoundSwitches& on) { m_cues.on = on; }
    void setMuted(bool muted) { m_muted = muted; }
    bool muted() const noexcept { return m_muted; }
    /// Call once per frame. `held`: paused or stopped.
    void play(const haptics::DisplayState& state, std::uint32_t contacts, bool held,
              const LeanOfTool& lean = {});
    void silence();     ///< at the end of the session
    void mask(bool on); ///< a study's masking noise, which replaces the cues
    /// Of the last frame, with or without an output.
    const SoundCues& cues() const noexcept { return m_cues; }
    /// The cues are audible now, or would be if nobody had switched them off.
    bool sounding() const noexcept { return m_sounding; }

private:
    SoundCues m_cues;
    bool m_muted = false;
    bool m_sounding = false;
    LoadedSound m_sound;
};

} // namespace chiron::desktop
