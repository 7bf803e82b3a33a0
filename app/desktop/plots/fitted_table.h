// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/theme/theme.h"

#include <QTableWidget>

namespace chiron::desktop {

/// A read-only table, navigated by row, whose columns are as wide as their text. If all columns fit, the last
/// one takes the remaining width; otherwise the table scrolls sideways. Nothing is cut off.
/// Thread: GUI.
class FittedTable : public QTableWidget {
    Q_OBJECT
public:
    FittedTable(const Theme& theme, int columns, QWidget* parent = nullptr);
    /// Makes the table high enough for `rows` rows, header and scroll bar included.
    void setRowsSeen(int rows);

protected:
    void resizeEvent(QResizeEvent* event) override;
    void showEvent(QShowEvent* event) override;

private:
    void fit();

    const Theme& m_theme;
};

} // namespace chiron::desktop
