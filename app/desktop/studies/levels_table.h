// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/theme/theme.h"

#include <QLocale>
#include <QWidget>
#include <functional>
#include <vector>

class QTableWidget;

namespace chiron::desktop {

/// Differences from the reference in per cent, a row each, with the value that an object then has: typed, or pasted from a table with decimal points or
/// commas. GUI thread.
class LevelsTable final : public QWidget {
    Q_OBJECT
public:
    /// `value` says what an object of so many per cent more is ("66 N/m"). `name`: of the table; its buttons are "<name>.paste", ".add", ".remove".
    LevelsTable(const Theme& theme, const QLocale& locale, bool readOnly, const QString& name, const std::vector<double>& percents,
                std::function<QString(double)> value, QWidget* parent = nullptr);

    /// Replaces all rows by the numbers of a text; what is no number is said, and nothing is taken.
    void paste(const QString& text);
    void showValues(); ///< of the objects anew: the reference is another one

signals:
    void changed(const std::vector<double>& percents); ///< by a person, all of them numbers
    void unread(const QString& words); ///< what cannot be taken, in words; empty: everything can

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void fill(const std::vector<double>& percents);
    void setRow(int row, double percent);
    QString shown(double percent) const;
    void taken();
    void edited(int row);
    void pasteClipboard();

    QLocale m_locale;
    bool m_readOnly;
    bool m_filling = false;
    std::function<QString(double)> m_value;
    QTableWidget* m_table;
};

} // namespace chiron::desktop
