// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/plots/fitted_table.h"

namespace chiron::desktop {

/// A table whose first column gives the name of each row and, below it in smaller type, its explanation
/// (Qt::AccessibleDescriptionRole of the cell). The first column takes the width that the other columns
/// leave. Rows are as high as their text, and the table is as high as all its rows.
/// Thread: GUI.
class MeaningTable : public FittedTable {
    Q_OBJECT
public:
    MeaningTable(const Theme& theme, int columns, QWidget* parent = nullptr);

    /// Hides every column except the first whose cells are all empty. Call it after the table has been
    /// filled.
    void hideEmptyColumns();

protected:
    void resizeEvent(QResizeEvent* event) override;
    void showEvent(QShowEvent* event) override;

private:
    void fitWords();

    const Theme& m_theme;
};

} // namespace chiron::desktop
