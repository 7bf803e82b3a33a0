// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/csv_table.h"

#include "cli/input_file.h"
#include "cli/messages.h"

#include <limits>

namespace chiron::cli {

namespace {

/// The cells of one line; false where a quote is not closed.
bool split(const QString& line, QChar separator, QStringList& cells) {
    QString cell;
    bool inside = false;
    cells.clear();
    for (qsizetype i = 0; i < line.size(); ++i) {
        const QChar c = line[i];
        if (inside && c == u'"' && i + 1 < line.size() && line[i + 1] == u'"') {
            cell += c;
            ++i;
        } else if (c == u'"') {
            inside = !inside;
        } else if (c == separator && !inside) {
            cells << cell.trimmed();
            cell.clear();
        } else {
            cell += c;
        }
    }
    cells << cell.trimmed();
    return !inside;
}

QChar separatorOf(const QString& heading) {
    for (const QChar c : {QChar(u','), QChar(u'\t'), QChar(u';')})
        if (heading.contains(c))
            return c;
    return u',';
}

tl::unexpected<core::Error> at(const QString& path, int line, const QString& what) {
    return badInput(QStringLiteral("%1:%2: %3").arg(path).arg(line).arg(what));
}

} // namespace

tl::unexpected<core::Error> CsvTable::fault(std::size_t row, int column, const QString& expected) const {
    return at(name, lines[row], QStringLiteral("column %1: %2: expected %3").arg(header[column], quoted(rows[row][column]), expected));
}

core::Result<double> CsvTable::number(std::size_t row, int column) const {
    const QString& text = rows[row][column];
    const QString lower = text.toLower();
    if (lower.isEmpty() || lower == u"na" || lower == u"n/a" || lower == u"nan")
        return std::numeric_limits<double>::quiet_NaN();
    if (lower == u"inf" || lower == u"+inf" || lower == u"-inf" || lower == u"infinity" || lower == u"-infinity")
        return lower.startsWith(u'-') ? -std::numeric_limits<double>::infinity() : std::numeric_limits<double>::infinity();
    bool ok = false;
    const double value = text.toDouble(&ok);
    if (!ok)
        return fault(row, column, QStringLiteral("a number such as 0.25 or 1e-3"));
    return value;
}

core::Result<CsvTable> readCsvTable(const QString& path) {
    constexpr qint64 kLargest = qint64{256} << 20;
    const auto bytes = readInputFile(path, kLargest);
    if (!bytes)
        return tl::unexpected(bytes.error());
    CsvTable table;
    table.name = path;
    QChar separator = u',';
    QString text = QString::fromUtf8(*bytes);
    if (text.startsWith(QChar(0xFEFF))) // spreadsheets put a byte-order mark before the heading
        text.remove(0, 1);
    int number = 0;
    for (const QString& raw : text.split(u'\n')) {
        ++number;
        const QString line = raw.trimmed();
        if (line.isEmpty() || line.startsWith(u'#'))
            continue;
        QStringList cells;
        if (table.header.isEmpty())
            separator = separatorOf(line);
        if (!split(line, separator, cells))
            return at(path, number, QStringLiteral("a quote is not closed; expected \" before the line's end"));
        if (table.header.isEmpty()) {
            for (const QString& heading : cells)
                if (heading.isEmpty() || cells.count(heading) > 1)
                    return at(path, number, QStringLiteral("heading %1: expected names that are not empty and each given once").arg(quoted(heading)));
            table.header = cells;
            continue;
        }
        if (cells.size() != table.header.size())
            return at(path, number, QStringLiteral("%1 cells; expected %2 as in the heading").arg(cells.size()).arg(table.header.size()));
        table.rows.push_back(cells);
        table.lines.push_back(number);
    }
    if (table.header.isEmpty())
        return at(path, 1, QStringLiteral("empty; expected a heading and rows"));
    if (table.rows.empty())
        return at(path, number, QStringLiteral("no rows under the heading; expected at least one"));
    return table;
}

} // namespace chiron::cli
