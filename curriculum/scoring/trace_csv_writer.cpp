// SPDX-License-Identifier: GPL-3.0-or-later
#include "scoring/trace_columns.h"
#include "scoring/trace_csv.h"

#include "core/units.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>

namespace chiron::scoring {

namespace {

void appendInteger(std::string& out, std::int64_t value) {
    std::array<char, 24> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
    out.append(text.data(), end);
}

/// Appends `count` units of 10^-decimals, exactly.
void appendDecimal(std::string& out, std::int64_t count, int decimals) {
    std::int64_t scale = 1;
    for (int i = 0; i < decimals; ++i)
        scale *= 10;
    if (count < 0)
        out += '-';
    const std::int64_t magnitude = count < 0 ? -count : count;
    appendInteger(out, magnitude / scale);
    out += '.';
    std::int64_t rest = magnitude % scale;
    for (scale /= 10; scale > 0; scale /= 10) {
        out += static_cast<char>('0' + rest / scale);
        rest %= scale;
    }
}

/// Rounds as in trace_grid.h.
std::int64_t nearest(double count) {
    return static_cast<std::int64_t>(std::nearbyint(count));
}

void appendShortest(std::string& out, double value) {
    std::array<char, 40> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
    out.append(text.data(), end);
}

void appendValue(std::string& out, const TraceColumn& column, double value) {
    switch (column.kind) {
    case ColumnKind::time:
        appendDecimal(out, nearest(value * 1e6), 6);
        break;
    case ColumnKind::length:
        appendDecimal(out, nearest(value * 1e9), 6);
        break;
    case ColumnKind::force:
        appendDecimal(out, nearest(value * 1e3), 3);
        break;
    case ColumnKind::number:
        appendShortest(out, value);
        break;
    case ColumnKind::angle:
        appendShortest(out, core::degFromRad(value));
        break;
    case ColumnKind::integer:
        appendInteger(out, static_cast<std::int64_t>(value));
        break;
    case ColumnKind::word:
        out += column.words[std::min(static_cast<std::size_t>(value), column.words.size() - 1)];
        break;
    case ColumnKind::torque:
        appendDecimal(out, nearest(value * 1e5), 2);
        break;
    case ColumnKind::fineAngle:
        appendDecimal(out, nearest(core::degFromRad(value) * 1e6), 6);
        break;
    }
}

/// Writes an empty field for a value that is missing or not finite.
void appendNamed(std::string& out, std::size_t count, const std::vector<double>& values) {
    for (std::size_t i = 0; i < count; ++i) {
        out += ',';
        if (i < values.size() && std::isfinite(values[i]))
            appendShortest(out, values[i] + 0.0); // no minus zero
    }
}

} // namespace

std::string traceCsvHeader(const TraceColumns& columns) {
    std::string out;
    for (const TraceColumn& column : traceColumns())
        if (column.presentIn(columns)) {
            out += out.empty() ? "" : ",";
            out += column.name;
        }
    for (const std::string& id : columns.quantities)
        out.append(",").append(kQuantityPrefix).append(id);
    for (const std::string& id : columns.truth)
        out.append(",").append(kTruthPrefix).append(id);
    return out + "\n";
}

void appendTraceCsvRow(std::string& out, const TraceColumns& columns, const TraceRow& row) {
    bool first = true;
    for (const TraceColumn& column : traceColumns())
        if (column.presentIn(columns)) {
            if (!first)
                out += ',';
            first = false;
            appendValue(out, column, column.valueIn(row));
        }
    appendNamed(out, columns.quantities.size(), row.quantities);
    appendNamed(out, columns.truth.size(), row.truth);
    out += '\n';
}

std::string writeTraceCsv(const TraceRows& rows) {
    std::array<std::int64_t, 256> last{};
    last.fill(std::numeric_limits<std::int64_t>::min());
    std::string out = traceCsvHeader(rows.columns);
    for (const TraceRow& row : rows.rows) {
        const std::int64_t t_us = nearest(row.t_s * 1e6);
        if (t_us <= last[row.tool])
            continue;
        last[row.tool] = t_us;
        appendTraceCsvRow(out, rows.columns, row);
    }
    return out;
}

} // namespace chiron::scoring
