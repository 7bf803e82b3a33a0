// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/palpation/desktop/palpation_map.h"

namespace chiron::desktop {

void PalpationMap::take(int trial, std::span<const session::LiveSample> samples) {
    if (trial != m_trial)
        m_map.clear();
    m_trial = trial;
    for (const session::LiveSample& sample : samples) {
        if (sample.phase != core::TrialPhase::running || sample.paused)
            continue;
        for (const auto& press : sample.press)
            if (press[2] > 0.0f)
                m_map.press({static_cast<double>(press[0]), static_cast<double>(press[1])},
                            static_cast<double>(press[2]));
    }
}

} // namespace chiron::desktop
