// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/training/early_marks.h"

#include <cmath>

namespace chiron::desktop {

void EarlyMarks::wentOn(std::int64_t now_ms) {
    m_until_ms = now_ms + kWait_ms;
    m_from_m.reset();
}

bool EarlyMarks::moved(const haptics::DisplayState& state) const {
    for (std::size_t i = 0; i < static_cast<std::size_t>(state.tools); ++i) {
        const std::array<double, 3>& from = (*m_from_m)[i];
        const std::array<double, 3>& at = state.tool[i].p_WT_m;
        if (std::hypot(at[0] - from[0], at[1] - from[1], at[2] - from[2]) > kMoved_m)
            return true;
    }
    return false;
}

void EarlyMarks::look(const haptics::DisplayState& state, std::int64_t now_ms) {
    const bool running = state.phase == core::TrialPhase::running;
    if (running && (!m_running || state.trial != m_trial))
        wentOn(now_ms);
    m_running = running;
    m_trial = state.trial;
    if (!m_until_ms || state.tools == 0)
        return;
    if (!m_from_m) {
        m_from_m.emplace();
        for (std::size_t i = 0; i < static_cast<std::size_t>(state.tools); ++i)
            (*m_from_m)[i] = state.tool[i].p_WT_m;
    } else if (now_ms >= *m_until_ms || moved(state)) {
        m_until_ms.reset();
    }
}

} // namespace chiron::desktop
