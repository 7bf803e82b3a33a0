// SPDX-License-Identifier: GPL-3.0-or-later
// What a playback has for palpations: what is looked at, and the readout.
#include "desktop/frame/app_context.h"
#include "desktop/playback/playback_screen.h"
#include "desktop/plots/responsive_row.h"
#include "app/exercises/palpation/desktop/palpation_words.h"
#include "report/report_text.h"

#include <QCheckBox>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace chiron::desktop {

QWidget* PlaybackScreen::palpationRow() {
    const Theme& theme = context().theme();
    auto* row = new ResponsiveRow(theme.px(560), theme.px(8));
    const auto add = [&](const char* name, const QString& text, const QString& tip, bool on, auto set) {
        auto* box = new QCheckBox(text);
        box->setObjectName(QStringLiteral("playback.%1").arg(QLatin1String(name)));
        box->setToolTip(tip);
        box->setChecked(place().parameters.value(QLatin1String(name), on).toBool());
        const auto take = [this, set, key = QString(QLatin1String(name))](bool checked) {
            set(m_palpationLook, checked);
            QVariantMap parameters = context().navigator().current().parameters;
            parameters.insert(key, checked);
            context().navigator().note(parameters);
            showMoment(m_clock.position_s());
        };
        set(m_palpationLook, box->isChecked());
        connect(box, &QCheckBox::toggled, this, take);
        row->add(box);
    };
    add("truth", tr("Show the lumps"), tr("Where the lumps were, and how the findings were scored"), true,
        [](PalpationLook& look, bool on) { look.truth = on; });
    add("whole_trial", tr("Map of the whole trial"), tr("Off: the map up to this moment"), false,
        [](PalpationLook& look, bool on) { look.wholeTrial = on; });
    add("force_map", tr("Force map"), tr("On: how hard the tissue was pressed. Off: where it was searched."), false,
        [](PalpationLook& look, bool on) { look.map = on ? core::SurfaceMapKind::force : core::SurfaceMapKind::coverage; });
    return row;
}

QString PlaybackScreen::palpationReadout(const session::PlaybackView& view) const {
    const QLocale locale = context().locale();
    const core::PalpationCues cues = m_data->palpation->cuesAt(m_data->track, m_clock.position_s(), false);
    std::size_t hardest = 0; // of several fingers the one that presses hardest
    for (std::size_t i = 1; i < view.tools.size(); ++i)
        if (view.tools[i].tissue_N.norm() > view.tools[hardest].tissue_N.norm())
            hardest = i;
    const QString trial = locale.toString(view.moment.trial + 1);
    const QString force = report::formatValue(view.tools[hardest].tissue_N.norm(), QStringLiteral("N"), locale);
    const QString lean = locale.toString(qRound(cues.lean_rad[hardest] * 180.0 / std::numbers::pi));
    const QString depth = report::formatValue(1e3 * cues.depth_m[hardest], QStringLiteral("mm"), locale);
    const QString searched = locale.toString(static_cast<int>(100.0 * cues.coverage));
    const QString findings = locale.toString(findingCount(cues));
    const double squeeze_N = std::max(cues.squeeze_N[0], cues.squeeze_N[1]);
    const QString squeeze =
        squeeze_N > 0.0 ? QStringLiteral(" · ") + tr("squeeze %1").arg(report::formatValue(squeeze_N, QStringLiteral("N"), locale)) : QString();
    return (view.moment.paused ? tr("Trial %1 · %7 · force %2 · tilt %3° · depth %4 · searched %5 % · findings %6")
                                    .arg(trial, force, lean, depth, searched, findings, stillWords(view.moment))
                              : tr("Trial %1 · force %2 · tilt %3° · depth %4 · searched %5 % · findings %6").arg(trial, force, lean, depth, searched, findings)) +
           squeeze;
}

} // namespace chiron::desktop
