// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/plots/fitted_table.h"

#include <QHeaderView>
#include <algorithm>

namespace chiron::desktop {

namespace {
constexpr int kRow_px = 36;
}

FittedTable::FittedTable(const Theme& theme, int columns, QWidget* parent)
    : QTableWidget(0, columns, parent), m_theme(theme) {
    verticalHeader()->hide();
    verticalHeader()->setDefaultSectionSize(theme.px(kRow_px));
    horizontalHeader()->setFixedHeight(theme.px(kRow_px));
    horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    setEditTriggers(QAbstractItemView::NoEditTriggers);
    setSelectionBehavior(QAbstractItemView::SelectRows);
    setSelectionMode(QAbstractItemView::SingleSelection);
    setTabKeyNavigation(false);
    setAlternatingRowColors(true);
    setShowGrid(false);
    setIconSize(QSize(theme.px(18), theme.px(18)));
}

void FittedTable::setRowsSeen(int rows) {
    setFixedHeight(m_theme.px(kRow_px) * (rows + 1) + m_theme.px(18));
}

void FittedTable::fit() {
    for (int column = 0; column < columnCount(); ++column)
        // That column takes the remaining width.
        if (horizontalHeader()->sectionResizeMode(column) == QHeaderView::Stretch)
            return horizontalHeader()->setStretchLastSection(false);
    int needed = 0;
    for (int column = 0; column < columnCount(); ++column)
        needed += std::max(sizeHintForColumn(column), horizontalHeader()->sectionSizeHint(column));
    horizontalHeader()->setStretchLastSection(needed <= viewport()->width());
}

void FittedTable::resizeEvent(QResizeEvent* event) {
    QTableWidget::resizeEvent(event);
    fit();
}

void FittedTable::showEvent(QShowEvent* event) {
    QTableWidget::showEvent(event);
    fit();
}

} // namespace chiron::desktop
