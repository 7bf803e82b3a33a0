// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/training/sound_cue_player.h"

#include <cmath>

namespace chiron::desktop {

QString SoundCuePlayer::open() {
    m_sound = loadSound();
    return m_sound.whySilent;
}

void SoundCuePlayer::play(const haptics::DisplayState& state, std::uint32_t contacts, bool held) {
    if (!m_sound.output)
        return;
    const core::Array6& tissue = state.tool[0].tissue;
    m_cues.force_N = std::hypot(tissue[0], tissue[1], tissue[2]);
    m_cues.contacts = contacts;
    m_cues.audible = !m_muted && !held && !state.ended && state.phase == core::TrialPhase::running;
    m_sound.output->set(m_cues);
}

void SoundCuePlayer::silence() {
    m_cues.audible = false;
    if (m_sound.output)
        m_sound.output->set(m_cues);
}

} // namespace chiron::desktop
