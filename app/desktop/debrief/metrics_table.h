// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/theme/theme.h"
#include "report/report_data.h"

#include <QLocale>
#include <QWidget>
#include <vector>

class QLabel;

namespace chiron::desktop {

class FittedTable;

/// Every metric of a session with value, unit, pass mark and benchmark; what a metric means is said below for the row that has the
/// focus, and as a tool tip. GUI thread.
class MetricsTable : public QWidget {
    Q_OBJECT
public:
    MetricsTable(const Theme& theme, const std::vector<report::MetricRow>& rows, const QLocale& locale, QWidget* parent = nullptr);

private:
    void fill(const Theme& theme, const std::vector<report::MetricRow>& rows, const QLocale& locale);
    void put(int row, int column, const QString& text, const QString& meaning);

    FittedTable* m_table;
    QLabel* m_meaning;
};

} // namespace chiron::desktop
