// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/plots/fitted_table.h"
#include "desktop/results/results_data.h"

#include <QLocale>

namespace chiron::desktop {

/// Lists a person's attempts, newest first. Return or a double click opens one.
/// Thread: GUI.
class AttemptsTable : public FittedTable {
    Q_OBJECT
public:
    AttemptsTable(const Theme& theme, const QLocale& locale, QWidget* parent = nullptr);

    /// `metric` selects the column of values; if empty, no values are shown.
    void show(const std::vector<Attempt>& attempts, const QString& metric);

signals:
    void openAsked(chiron::database::SessionId session);

protected:
    void keyPressEvent(QKeyEvent* event) override;

private:
    void put(int row, int column, const QString& text, const QString& icon = {}, Colour ink = Colour::text);
    void openRow(int row);

    const Theme& m_theme;
    QLocale m_locale;
};

} // namespace chiron::desktop
