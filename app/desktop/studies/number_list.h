// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLocale>
#include <QString>
#include <vector>

namespace chiron::desktop {

/// Numbers read from one line, or from text copied from a table.
struct NumberList {
    std::vector<double> values;
    QString unread; ///< the first part that is not a number; `values` must not be used then
};

/// Reads numbers that are separated by semicolons, tabs, line ends or spaces, with decimal points or decimal
/// commas as in the table that they come from. Commas alone separate if the numbers contain points ("0.5,
/// 1.5"). Ambiguous text ("0,5,1,5") is rejected.
NumberList readNumbers(const QString& text, const QLocale& locale);
/// Describes the error and how to correct it; empty if there is none.
QString unreadWords(const NumberList& list);

/// "0.02; 0.05; 0.1" in the locale.
QString listText(const std::vector<double>& values, const QLocale& locale);

} // namespace chiron::desktop
