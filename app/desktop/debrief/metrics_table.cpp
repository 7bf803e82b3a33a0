// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/debrief/metrics_table.h"

#include "desktop/debrief/meaning_table.h"
#include "desktop/widgets/kit.h"
#include "report/report_text.h"
#include "session_report/metric_words.h"

namespace chiron::desktop {

MetricsTable::MetricsTable(const Theme& theme, const std::vector<report::MetricRow>& rows,
                           const QLocale& locale, QWidget* parent)
    : QWidget(parent), m_table(new MeaningTable(theme, 5)) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    m_table->setObjectName(QStringLiteral("debrief.metrics"));
    m_table->setAccessibleName(tr("All metrics"));
    m_table->setHorizontalHeaderLabels(
        {tr("Metric"), tr("Value"), tr("Pass mark"), tr("Benchmark, chance"), tr("Result")});
    fill(theme, rows, locale);
    m_table->hideEmptyColumns();
    column->addWidget(m_table);
}

void MetricsTable::put(int row, int column, const QString& text, const QString& meaning) {
    auto* item = new QTableWidgetItem(text);
    item->setData(Qt::AccessibleDescriptionRole, meaning);
    if (column == 1)
        item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
    m_table->setItem(row, column, item);
}

void MetricsTable::fill(const Theme& theme, const std::vector<report::MetricRow>& rows,
                        const QLocale& locale) {
    m_table->setRowCount(static_cast<int>(rows.size()));
    for (int i = 0; i < static_cast<int>(rows.size()); ++i) {
        const report::MetricRow& row = rows[static_cast<std::size_t>(i)];
        const QString meaning = session_report::metricMeaning(row.id, row.trials);
        put(i, 0, session_report::metricTitle(row.id, row.trials), meaning);
        put(i, 1,
            row.value ? report::formatValue(row.value, row.unit, locale)
                      : session_report::metricReason(row.reason),
            meaning);
        put(i, 2, report::formatGate(row, locale), meaning);
        const QString band = report::formatBand(row, locale);
        put(i, 3, band.isEmpty() ? report::chanceWords(row, locale) : band, meaning);
        put(i, 4, !row.passed ? QString() : *row.passed ? tr("Met") : tr("Not met"), meaning);
        if (row.passed)
            m_table->item(i, 4)->setIcon(*row.passed
                                             ? theme.icon(QStringLiteral("dialog-ok-apply"), Colour::good)
                                             : theme.icon(QStringLiteral("dialog-close"), Colour::bad));
    }
}

} // namespace chiron::desktop
