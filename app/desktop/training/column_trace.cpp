// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/training/column_trace.h"

#include <algorithm>
#include <cmath>

namespace chiron::desktop {

namespace {

void include(ColumnRange& range, double lowest, double highest) noexcept {
    range.lowest = range.any ? std::min(range.lowest, lowest) : lowest;
    range.highest = range.any ? std::max(range.highest, highest) : highest;
    range.any = true;
}

constexpr auto kCount = static_cast<std::int64_t>(ColumnTrace::kCells);

} // namespace

ColumnTrace::ColumnTrace(double span_s) : m_span_s(span_s), m_cells(kCells) {
    m_columns.reserve(kCells);
}

std::int64_t ColumnTrace::cellOf(double t_s) const noexcept {
    return static_cast<std::int64_t>(std::floor(t_s / m_span_s * static_cast<double>(kCells)));
}

ColumnRange& ColumnTrace::cell(std::int64_t index) noexcept {
    return m_cells[static_cast<std::size_t>(index % kCount)];
}
const ColumnRange& ColumnTrace::cell(std::int64_t index) const noexcept {
    return m_cells[static_cast<std::size_t>(index % kCount)];
}

void ColumnTrace::add(double t_s, double value) noexcept {
    if (!std::isfinite(value) || !(t_s >= 0.0))
        return;
    const std::int64_t index = cellOf(t_s);
    if (m_newestCell >= 0 && index <= m_newestCell - kCount)
        return;
    // No samples exist between the newest one and this one, so the cells in between become empty.
    for (std::int64_t i = std::max(m_newestCell + 1, index - kCount + 1); i <= index; ++i)
        cell(i) = {};
    m_newestCell = std::max(m_newestCell, index);
    m_newest_s = std::max(m_newest_s, t_s);
    include(cell(index), value, value);
}

void ColumnTrace::clear() noexcept {
    std::fill(m_cells.begin(), m_cells.end(), ColumnRange{});
    m_newestCell = -1;
    m_newest_s = 0.0;
}

double ColumnTrace::highest() const noexcept {
    double most = 0.0;
    for (const ColumnRange& range : m_cells)
        most = range.any ? std::max(most, range.highest) : most;
    return most;
}

const std::vector<ColumnRange>& ColumnTrace::columns(std::size_t count) {
    count = std::clamp<std::size_t>(count, 1, kCells);
    m_columns.assign(count, {});
    if (m_newestCell < 0)
        return m_columns;
    const std::int64_t oldest = m_newestCell - kCount + 1;
    for (std::int64_t i = std::max<std::int64_t>(oldest, 0); i <= m_newestCell; ++i) {
        const ColumnRange& from = cell(i);
        if (from.any)
            include(
                m_columns[static_cast<std::size_t>((i - oldest) * static_cast<std::int64_t>(count) / kCount)],
                from.lowest, from.highest);
    }
    return m_columns;
}

} // namespace chiron::desktop
