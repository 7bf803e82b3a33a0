// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLocale>
#include <QString>
#include <vector>

namespace chiron::desktop {

/// Numbers of a line, or of what was copied from a table.
struct NumberList {
    std::vector<double> values;
    QString unread; ///< the first piece that is no number; nothing is to be taken then
};

/// Reads numbers separated by semicolons, tabs, line ends or spaces, with a decimal point or a decimal comma, whichever the table had that they
/// come from; by commas alone where the numbers have points ("0.5, 1.5"). What could be read in two ways ("0,5,1,5") is not read.
NumberList readNumbers(const QString& text, const QLocale& locale);
/// What is wrong with it and what to do; empty: nothing.
QString unreadWords(const NumberList& list);

/// "0.02; 0.05; 0.1" in the locale.
QString listText(const std::vector<double>& values, const QLocale& locale);

} // namespace chiron::desktop
