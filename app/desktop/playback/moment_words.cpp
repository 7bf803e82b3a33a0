// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/playback/moment_words.h"

#include "desktop/plots/session_token_words.h"

namespace chiron::desktop {

QString MomentWords::at(double t_s) const {
    constexpr double kRounding_s = 1e-6;
    const session::PlaybackTrial* trial = nullptr;
    for (const session::PlaybackTrial& each : m_trials)
        if (each.start_s <= t_s + kRounding_s)
            trial = &each;
    if (!trial)
        return m_trials.empty()
                   ? clockText(t_s, m_locale)
                   : tr("%1 before the start").arg(clockText(m_trials.front().start_s - t_s, m_locale));
    const QString into = clockText(t_s - trial->start_s, m_locale);
    return m_several ? tr("Trial %1, %2").arg(m_locale.toString(trial->index + 1), into) : into;
}

} // namespace chiron::desktop
