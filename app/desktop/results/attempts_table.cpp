// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/results/attempts_table.h"

#include "desktop/plots/session_token_words.h"
#include "desktop/sessions/session_words.h"
#include "report/report_text.h"
#include "session_report/metric_words.h"

#include <QKeyEvent>
#include <algorithm>

namespace chiron::desktop {

namespace {

constexpr int kMostRowsSeen = 14; // with more rows the table scrolls by itself

Colour outcomeColour(const database::SessionSummary& session) {
    if (session.state != database::SessionState::completed)
        return Colour::warning;
    return session.passed.value_or(false) && !session.familiarisation ? Colour::good : Colour::muted;
}

} // namespace

AttemptsTable::AttemptsTable(const Theme& theme, const QLocale& locale, QWidget* parent)
    : FittedTable(theme, 5, parent), m_theme(theme), m_locale(locale) {
    setObjectName(QStringLiteral("results.attempts"));
    setAccessibleName(tr("My attempts"));
    connect(this, &QTableWidget::cellDoubleClicked, this, [this](int row) { openRow(row); });
}

void AttemptsTable::put(int row, int column, const QString& text, const QString& icon, Colour ink) {
    auto* item = new QTableWidgetItem(text);
    if (!icon.isEmpty())
        item->setIcon(m_theme.icon(icon, ink));
    setItem(row, column, item);
}

void AttemptsTable::show(const std::vector<Attempt>& attempts, const QString& metric) {
    setHorizontalHeaderLabels({tr("When"), tr("Attempt"), tr("Force"),
                               metric.isEmpty() ? tr("Value") : session_report::metricTitle(metric),
                               tr("Outcome")});
    setRowCount(static_cast<int>(attempts.size()));
    for (int row = 0; row < rowCount(); ++row) {
        const Attempt& attempt = attempts[attempts.size() - 1 - static_cast<std::size_t>(row)];
        const database::SessionSummary& summary = attempt.summary;
        put(row, 0, whenText(summary, m_locale));
        item(row, 0)->setData(Qt::UserRole, qlonglong(summary.id));
        const QString level = m_locale.toString(summary.level);
        put(row, 1,
            summary.familiarisation ? tr("Level %1, familiarisation").arg(level)
            : summary.attempt > 0   ? SessionWords::attempt(summary, m_locale)
                                    : tr("Level %1").arg(level));
        put(row, 2, feltText(summary.felt));
        put(row, 4, outcomeText(summary), outcomeIcon(summary), outcomeColour(summary));
        const scoring::MetricValue* value = attempt.metric(metric.toStdString());
        put(row, 3,
            value ? report::formatValue(
                        value->value, session_report::unitText(QString::fromStdString(value->unit)), m_locale)
                  : QStringLiteral("–"));
        item(row, 3)->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
    }
    setRowsSeen(std::clamp(rowCount(), 1, kMostRowsSeen));
    if (rowCount() > 0)
        setCurrentCell(0, 0);
}

void AttemptsTable::openRow(int row) {
    if (row >= 0 && row < rowCount())
        emit openAsked(item(row, 0)->data(Qt::UserRole).toLongLong());
}

void AttemptsTable::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter)
        openRow(currentRow());
    else
        FittedTable::keyPressEvent(event);
}

} // namespace chiron::desktop
