// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/debrief/headline_card.h"

#include "desktop/debrief/band_bar.h"
#include "desktop/widgets/kit.h"
#include "report/report_text.h"
#include "session_report/metric_words.h"

namespace chiron::desktop {

HeadlineCard::HeadlineCard(const Theme& theme, const report::MetricRow& row, const QLocale& locale,
                           QWidget* parent)
    : QFrame(parent) {
    setProperty("kind", QStringLiteral("card"));
    setObjectName(QStringLiteral("headline.%1").arg(row.id));
    auto* column = new QVBoxLayout(this);
    const int padding = theme.px(16);
    column->setContentsMargins(padding, theme.px(12), padding, theme.px(12));
    column->setSpacing(theme.px(4));
    column->addWidget(
        kit::label(theme, session_report::metricTitle(row.id, row.trials), TextStyle::label, "muted"));
    auto* value = kit::label(theme, report::formatValue(row.value, row.unit, locale), TextStyle::display);
    value->setObjectName(QStringLiteral("headline.value"));
    column->addWidget(value);
    auto* bar = new BandBar(theme, row);
    column->addWidget(bar);
    const QString gate = report::formatGate(row, locale);
    auto* verdict = new QHBoxLayout;
    verdict->setSpacing(theme.px(6));
    QString words = gate.isEmpty() ? tr("No pass mark") : tr("Pass mark %1").arg(gate);
    if (row.passed) {
        words = *row.passed ? tr("Met: pass mark %1").arg(gate) : tr("Not met: pass mark %1").arg(gate);
        auto* sign = new QLabel;
        const QString icon = *row.passed ? QStringLiteral("dialog-ok-apply") : QStringLiteral("dialog-close");
        sign->setPixmap(
            theme.icon(icon, *row.passed ? Colour::good : Colour::bad).pixmap(theme.px(18), theme.px(18)));
        verdict->addWidget(sign, 0, Qt::AlignTop);
    }
    auto* verdictLabel =
        kit::label(theme, words, TextStyle::strong, row.passed ? (*row.passed ? "good" : "bad") : "muted");
    verdictLabel->setObjectName(QStringLiteral("headline.verdict"));
    verdict->addWidget(verdictLabel, 1);
    column->addLayout(verdict);
    if (!row.value)
        column->addWidget(
            kit::label(theme, session_report::metricReason(row.reason), TextStyle::small, "muted"));
    const QString band = report::formatBand(row, locale);
    if (!band.isEmpty())
        column->addWidget(kit::label(
            theme, tr("Benchmark %1 (%2)").arg(band, session_report::bandSourceText(row.bandSource)),
            TextStyle::small, "muted"));
    if (row.chance)
        column->addWidget(kit::label(theme, report::chanceWords(row, locale), TextStyle::small, "muted"));
    column->addStretch();
    bar->setToolTip(session_report::metricMeaning(row.id, row.trials));
    setToolTip(session_report::metricMeaning(row.id, row.trials));
}

} // namespace chiron::desktop
