// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>
#include <vector>

namespace chiron::cli {

/// A table for a terminal: columns as wide as their widest cell, two spaces apart, numbers to the right.
class TextTable {
public:
    /// A column whose heading begins with '>' is right-aligned; the sign is not shown.
    explicit TextTable(const QStringList& headings);
    void add(const QStringList& cells); ///< missing cells are empty
    /// With headings and a rule; "(none)" under them without rows. Ends in a line's end.
    QString toText() const;

private:
    QStringList m_headings;
    std::vector<bool> m_right;
    std::vector<QStringList> m_rows;
};

/// "name: value" lines with the values under each other.
QString alignedPairs(const std::vector<std::pair<QString, QString>>& pairs);

/// The shortest decimal that reads back as the same double; "-" for what is not finite.
QString exactNumber(double value);
/// As people read it in a table: six significant digits.
QString shortNumber(double value);

} // namespace chiron::cli
