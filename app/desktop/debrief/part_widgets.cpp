// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/debrief/part_widgets.h"

#include "desktop/debrief/debrief_part.h"
#include "desktop/plots/fitted_table.h"

#include <QVBoxLayout>

namespace chiron::desktop {

PartColumn::PartColumn(const Theme& theme)
    : holder(std::make_unique<QWidget>()), layout(new QVBoxLayout(holder.get())) {
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(theme.px(8));
}

QWidget* partPlot(const Theme& theme, std::unique_ptr<report::PlotView> view, const char* name,
                  int height_px) {
    view->setObjectName(QLatin1String(name));
    view->setMinimumHeight(theme.px(height_px));
    return view.release(); // the caller's layout owns it now
}

QWidget* trialTable(const Theme& theme, const report::WordTable& words, const char* name) {
    auto* table = new FittedTable(theme, static_cast<int>(words.head.size()));
    table->setObjectName(QLatin1String(name));
    table->setAccessibleName(DebriefPartTexts::tr("Result of each trial"));
    table->setHorizontalHeaderLabels(QStringList(words.head.begin(), words.head.end()));
    table->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    table->setRowCount(static_cast<int>(words.rows.size()));
    for (int row = 0; row < table->rowCount(); ++row)
        for (int column = 0; column < table->columnCount(); ++column) {
            auto* item = new QTableWidgetItem(
                words.rows[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)]);
            if (column != 1 && column + 1 < table->columnCount()) // the last column takes the remaining width
                item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
            table->setItem(row, column, item);
        }
    table->setRowsSeen(table->rowCount());
    return table;
}

} // namespace chiron::desktop
