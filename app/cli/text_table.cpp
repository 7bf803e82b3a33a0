// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/text_table.h"

#include "cli/cli_errors.h"

#include <QLocale>
#include <algorithm>
#include <charconv>
#include <cmath>

namespace chiron::cli {

TextTable::TextTable(const QStringList& headings) {
    for (const QString& heading : headings) {
        const bool right = heading.startsWith(QLatin1Char('>'));
        m_headings << (right ? heading.mid(1) : heading);
        m_right.push_back(right);
    }
}

void TextTable::add(const QStringList& cells) {
    QStringList row;
    for (qsizetype i = 0; i < m_headings.size(); ++i)
        row << printable(cells.value(i)).replace(QLatin1Char('\n'), QLatin1Char(' '));
    m_rows.push_back(row);
}

QString TextTable::toText() const {
    std::vector<qsizetype> widths;
    for (qsizetype i = 0; i < m_headings.size(); ++i) {
        qsizetype width = m_headings[i].size();
        for (const QStringList& row : m_rows)
            width = std::max(width, row[i].size());
        widths.push_back(width);
    }
    const auto line = [&](const QStringList& cells, QChar fill) {
        QString out;
        for (qsizetype i = 0; i < m_headings.size(); ++i) {
            const auto column = static_cast<std::size_t>(i);
            out += i > 0 ? QStringLiteral("  ") : QString();
            out += m_right[column] ? cells.value(i).rightJustified(widths[column], fill)
                                   : cells.value(i).leftJustified(widths[column], fill);
        }
        while (out.endsWith(QLatin1Char(' ')))
            out.chop(1);
        return out + QLatin1Char('\n');
    };
    QString text = line(m_headings, QLatin1Char(' ')) + line({}, QLatin1Char('-'));
    for (const QStringList& row : m_rows)
        text += line(row, QLatin1Char(' '));
    return m_rows.empty() ? text + QStringLiteral("(none)\n") : text;
}

QString alignedPairs(const std::vector<std::pair<QString, QString>>& pairs) {
    qsizetype widest = 0;
    for (const auto& [name, value] : pairs)
        widest = std::max(widest, name.size());
    QString text;
    for (const auto& [name, value] : pairs)
        text += (name + QLatin1Char(':')).leftJustified(widest + 2) + printable(value) + QLatin1Char('\n');
    return text;
}

QString exactNumber(double value) {
    if (!std::isfinite(value))
        return QStringLiteral("-");
    char buffer[40];
    const auto end = std::to_chars(buffer, buffer + sizeof buffer, value);
    return QString::fromLatin1(buffer, end.ptr - buffer);
}

QString shortNumber(double value) {
    return std::isfinite(value) ? QString::number(value, 'g', 6) : QStringLiteral("-");
}

} // namespace chiron::cli
