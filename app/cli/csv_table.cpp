// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/csv_table.h"

#include "cli/cli_errors.h"
#include "cli/input_file.h"

#include <algorithm>
#include <limits>
#include <optional>

namespace chiron::cli {

namespace {

/// Returns the line at `next`, together with the lines over which a quoted cell of it continues, and advances
/// `next` to the line after them. Returns nothing if a quote is not closed. Quotes in a note (#) have no
/// meaning.
std::optional<QString> record(const QStringList& lines, qsizetype& next) {
    const auto line = [&](qsizetype at) {
        return lines[at].endsWith(u'\r') ? lines[at].chopped(1) : lines[at];
    };
    QString whole = line(next++);
    qsizetype quotes = whole.count(u'"');
    while (quotes % 2 != 0 && !whole.startsWith(u'#')) {
        if (next == lines.size())
            return std::nullopt;
        quotes += lines[next].count(u'"');
        whole += u'\n' + line(next++);
    }
    return whole;
}

QStringList split(const QString& line, QChar separator) {
    QStringList cells;
    QString cell;
    bool inside = false;
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
    return cells << cell.trimmed();
}

bool saysNothing(const QStringList& cells) {
    return cells[0].startsWith(u'#') ||
           std::all_of(cells.begin(), cells.end(), [](const QString& cell) { return cell.isEmpty(); });
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

core::Result<void> add(CsvTable& table, const QStringList& cells, int line) {
    if (!table.header.isEmpty()) {
        if (cells.size() != table.header.size())
            return at(table.name, line,
                      QStringLiteral("%1 cells; expected %2 as in the heading")
                          .arg(cells.size())
                          .arg(table.header.size()));
        table.rows.push_back(cells);
        table.lines.push_back(line);
        return {};
    }
    for (const QString& heading : cells)
        if (heading.isEmpty() || cells.count(heading) > 1)
            return at(table.name, line,
                      QStringLiteral("heading %1: expected names that are not empty and each given once")
                          .arg(quoted(heading)));
    table.header = cells;
    table.headerLine = line;
    return {};
}

} // namespace

tl::unexpected<core::Error> CsvTable::fault(std::size_t row, int column, const QString& expected) const {
    return at(name, lines[row],
              QStringLiteral("column %1: %2: expected %3")
                  .arg(header[column], quoted(rows[row][column]), expected));
}

core::Result<double> CsvTable::number(std::size_t row, int column) const {
    const QString& text = rows[row][column];
    const QString lower = text.toLower();
    if (lower.isEmpty() || lower == u"na" || lower == u"n/a" || lower == u"nan")
        return std::numeric_limits<double>::quiet_NaN();
    if (lower == u"inf" || lower == u"+inf" || lower == u"-inf" || lower == u"infinity" ||
        lower == u"+infinity" || lower == u"-infinity")
        return lower.startsWith(u'-') ? -std::numeric_limits<double>::infinity()
                                      : std::numeric_limits<double>::infinity();
    bool ok = false;
    const double value = text.toDouble(&ok);
    if (!ok)
        return fault(row, column, QStringLiteral("a number such as 0.25 or 1e-3"));
    return value;
}

core::Result<CsvTable> readCsvTable(const QString& path) {
    constexpr qint64 kLargest = qint64{256} << 20;
    const auto bytes = readInputFile(path, kLargest);
    CHIRON_TRY(bytes);
    return parseCsvTable(QString::fromUtf8(*bytes), path);
}

core::Result<CsvTable> parseCsvTable(QString text, const QString& path) {
    CsvTable table;
    table.name = path;
    QChar separator = u',';
    // Spreadsheets put a byte-order mark before the heading.
    if (text.startsWith(QChar(0xFEFF)))
        text.remove(0, 1);
    const QStringList lines = text.split(u'\n');
    for (qsizetype next = 0; next < lines.size();) {
        const int number = static_cast<int>(next) + 1;
        const auto line = record(lines, next);
        if (!line)
            return at(path, number,
                      QStringLiteral("a quote is not closed; expected \" before the file's end"));
        if (table.header.isEmpty())
            separator = separatorOf(*line);
        const QStringList cells = split(*line, separator);
        if (saysNothing(cells))
            continue;
        CHIRON_TRY(add(table, cells, number));
    }
    if (table.header.isEmpty())
        return at(path, 1, QStringLiteral("empty; expected a heading and rows"));
    if (table.rows.empty())
        return at(path, static_cast<int>(lines.size()),
                  QStringLiteral("no rows under the heading; expected at least one"));
    return table;
}

} // namespace chiron::cli
