// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/plots/fitted_table.h"

namespace chiron::desktop {

/// A table whose first column says what a row is and, below it and smaller, what that means (Qt::AccessibleDescriptionRole of the cell). That
/// column takes the width that the others leave, and rows are as high as its words; the table is as high as all its rows. GUI thread.
class MeaningTable : public FittedTable {
    Q_OBJECT
public:
    MeaningTable(const Theme& theme, int columns, QWidget* parent = nullptr);

    /// Hides each column but the first in which every cell is empty. Call it once the table is filled.
    void hideEmptyColumns();

protected:
    void resizeEvent(QResizeEvent* event) override;
    void showEvent(QShowEvent* event) override;

private:
    void fitWords();

    const Theme& m_theme;
};

} // namespace chiron::desktop
