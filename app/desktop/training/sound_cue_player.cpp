// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/training/sound_cue_player.h"

#include "haptics/safety_display.h"

#include <algorithm>
#include <cmath>

namespace chiron::desktop {

void takeStrongest(const haptics::DisplayState& state, const LeanOfTool& lean, SoundCues& cues) {
    cues.force_N = 0.0;
    cues.lean = 0.0;
    for (std::size_t i = 0; i < state.tool.size() && static_cast<int>(i) < state.tools; ++i) {
        const core::Array6& tissue = state.tool[i].tissue;
        const double force_N = std::hypot(tissue[0], tissue[1], tissue[2]);
        if (force_N <= cues.force_N)
            continue;
        cues.force_N = force_N;
        cues.lean = lean ? std::min(1.0, lean(state, i) / haptics::kMaximumPitch_rad) : 0.0;
    }
}

QString SoundCuePlayer::open() {
    m_sound = loadSound();
    return m_sound.whySilent;
}

void SoundCuePlayer::play(const haptics::DisplayState& state, std::uint32_t contacts, bool held,
                          const LeanOfTool& lean) {
    takeStrongest(state, lean, m_cues);
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
