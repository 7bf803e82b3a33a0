// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/theme/theme.h"
#include "report/report_data.h"

#include <QLocale>
#include <QWidget>
#include <vector>

namespace chiron::desktop {

class MeaningTable;

/// Lists every metric of a session with its value, unit, pass mark and benchmark. The explanation of a metric
/// stands below its title. Columns that are empty for all metrics are left out.
/// Thread: GUI.
class MetricsTable : public QWidget {
    Q_OBJECT
public:
    MetricsTable(const Theme& theme, const std::vector<report::MetricRow>& rows, const QLocale& locale,
                 QWidget* parent = nullptr);

private:
    void fill(const Theme& theme, const std::vector<report::MetricRow>& rows, const QLocale& locale);
    void put(int row, int column, const QString& text, const QString& meaning);

    MeaningTable* m_table;
};

} // namespace chiron::desktop
