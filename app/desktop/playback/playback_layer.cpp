// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/playback/playback_layer.h"

#include "report/report_text.h"

namespace chiron::desktop {

QString stillWords(const session::PlaybackMoment& moment) {
    if (!moment.paused)
        return {};
    return moment.force == core::ForceState::stopped || moment.force == core::ForceState::fault
               ? PlaybackTexts::tr("force stopped")
               : PlaybackTexts::tr("paused");
}

QString trialReadout(const session::PlaybackView& view, const QLocale& locale) {
    const session::PlaybackTool& tool = view.tools.front();
    const QString trial = locale.toString(view.moment.trial + 1);
    const QString force = report::formatValue(tool.tissue_N.norm(), QStringLiteral("N"), locale);
    const QString speed = report::formatValue(1e3 * tool.speed_m_per_s, QStringLiteral("mm/s"), locale);
    return view.moment.paused ? PlaybackTexts::tr("Trial %1 · %2 · force %3 · speed %4")
                                    .arg(trial, stillWords(view.moment), force, speed)
                              : PlaybackTexts::tr("Trial %1 · force %2 · speed %3").arg(trial, force, speed);
}

} // namespace chiron::desktop
