// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>
#include <vector>

namespace chiron::cli {

/// A table for a terminal. Each column is as wide as its widest cell, columns are two spaces apart, and
/// numbers are right-aligned.
class TextTable {
public:
    /// A column whose heading begins with '>' is right-aligned; the '>' is not shown.
    explicit TextTable(const QStringList& headings);
    void add(const QStringList& cells); ///< missing cells are empty
    /// Returns the table with headings and a rule, and with "(none)" under them if there are no rows. The
    /// text ends in a line feed.
    QString toText() const;

private:
    QStringList m_headings;
    std::vector<bool> m_right;
    std::vector<QStringList> m_rows;
};

/// Lines of the form "name: value" with the values aligned in a column.
QString alignedPairs(const std::vector<std::pair<QString, QString>>& pairs);

/// The shortest decimal number that reads back as the same double; "-" if the value is not finite.
QString exactNumber(double value);
/// A number for tables, with six significant digits.
QString shortNumber(double value);

} // namespace chiron::cli
