// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/training/sound_cue_player.h"

#include "haptics/safety_display.h"

#include <algorithm>
#include <cmath>

namespace chiron::desktop {

void takeStrongest(const haptics::DisplayState& state, SoundCues& cues) {
    cues.force_N = 0.0;
    cues.lean = 0.0;
    for (std::size_t i = 0; i < state.tool.size() && static_cast<int>(i) < state.tools; ++i) {
        const core::Array6& tissue = state.tool[i].tissue;
        const double force_N = std::hypot(tissue[0], tissue[1], tissue[2]);
        if (force_N <= cues.force_N)
            continue;
        cues.force_N = force_N;
        cues.lean = std::min(1.0, state.palpation.lean_rad[i] / haptics::kMaximumPitch_rad);
    }
}

QString SoundCuePlayer::open() {
    m_sound = loadSound();
    return m_sound.whySilent;
}

void SoundCuePlayer::play(const haptics::DisplayState& state, std::uint32_t contacts, bool held) {
    takeStrongest(state, m_cues);
    m_cues.contacts = contacts;
    m_sounding = !held && !state.ended && state.phase == core::TrialPhase::running;
    m_cues.audible = m_sounding && !m_muted;
    if (m_sound.output)
        m_sound.output->set(m_cues);
}

void SoundCuePlayer::mask(bool on) {
    m_cues.masking = on ? 1.0 : 0.0;
    m_cues.audible = m_sounding = on;
    if (m_sound.output)
        m_sound.output->set(m_cues);
}

void SoundCuePlayer::silence() {
    m_cues.audible = m_sounding = false;
    if (m_sound.output)
        m_sound.output->set(m_cues);
}

} // namespace chiron::desktop
