// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/theme/theme.h"

#include <QTableWidget>

namespace chiron::desktop {

/// A table to be read, row by row, whose columns are as wide as their words: where they all fit the last one takes the rest of the
/// width, where they do not the table scrolls sideways; nothing is cut off. GUI thread.
class FittedTable : public QTableWidget {
    Q_OBJECT
public:
    FittedTable(const Theme& theme, int columns, QWidget* parent = nullptr);
    /// As high as `rows` rows, head and scroll bar included.
    void setRowsSeen(int rows);

protected:
    void resizeEvent(QResizeEvent* event) override;
    void showEvent(QShowEvent* event) override;

private:
    void fit();

    const Theme& m_theme;
};

} // namespace chiron::desktop
