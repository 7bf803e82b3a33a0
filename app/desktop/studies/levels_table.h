// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/studies/number_list.h"
#include "desktop/theme/theme.h"
#include "psychophysics/study/study_design.h"

#include <QLocale>
#include <QStringList>
#include <QWidget>
#include <functional>
#include <vector>

class QTableWidget;

namespace chiron::desktop {

/// The objects with these differences from the reference in per cent ("66 N/m"); neighbours read differently.
QStringList objectsOf(const psychophysics::StimulusDesign& stimulus, const std::vector<double>& percents,
                      const QLocale& locale);

/// A table of differences from the reference in per cent, one per row, with the resulting value of the
/// object. The numbers are typed, or pasted from a table with decimal points or commas.
/// Thread: GUI.
class LevelsTable final : public QWidget {
    Q_OBJECT
public:
    using Objects = std::function<QStringList(const std::vector<double>& percents)>;

    /// `objects` writes the objects with these differences, as objectsOf() does. `name` is the table's object
    /// name; its buttons are "<name>.paste", ".add", ".remove".
    LevelsTable(const Theme& theme, const QLocale& locale, bool readOnly, const QString& name,
                const std::vector<double>& percents, Objects objects, QWidget* parent = nullptr);

    /// Replaces all rows by the numbers in a text. If it contains anything else, the table reports that and
    /// changes nothing.
    void paste(const QString& text);
    void showValues(); ///< updates the objects' values after a change of the reference

signals:
    void changed(const std::vector<double>& percents); ///< changed by a person; all entries are numbers
    void unread(const QString& words); ///< describes input that cannot be read; empty if all of it can

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void fill(const std::vector<double>& percents);
    void setRow(int row, double percent);
    QString shown(double percent) const;
    NumberList numberOfRow(int row) const;
    void taken();
    void edited();
    void pasteClipboard();

    QLocale m_locale;
    bool m_readOnly;
    bool m_filling = false;
    Objects m_objects;
    QTableWidget* m_table;
    int m_digits; ///< of the differences: as many as tell neighbours apart
};

} // namespace chiron::desktop
