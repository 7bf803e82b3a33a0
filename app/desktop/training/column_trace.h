// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace chiron::desktop {

/// Lowest and highest value of one pixel column; `any` false where nothing was measured.
struct ColumnRange {
    double lowest = 0.0;
    double highest = 0.0;
    bool any = false;
};

/// The last seconds of a 1 kHz signal for a plot that scrolls: each cell keeps the lowest and highest value of its piece of
/// time, and columns are made from whole cells, so that no peak is ever lost between pixels. add() and columns() allocate
/// nothing once the size is known. One thread.
class ColumnTrace {
public:
    static constexpr std::size_t kCells = 2048; ///< finer than any plot is wide

    explicit ColumnTrace(double span_s);

    /// Times must not go back; a sample older than the newest cell's span is ignored, as one that is not finite.
    void add(double t_s, double value) noexcept;
    void clear() noexcept;

    double newest_s() const noexcept { return m_newest_s; }
    double span_s() const noexcept { return m_span_s; }
    /// Highest value in the span; 0 if there is none.
    double highest() const noexcept;
    /// `count` columns, oldest first; the last one holds the newest sample. kCells at most.
    const std::vector<ColumnRange>& columns(std::size_t count);

private:
    std::int64_t cellOf(double t_s) const noexcept;
    ColumnRange& cell(std::int64_t index) noexcept;
    const ColumnRange& cell(std::int64_t index) const noexcept;

    double m_span_s;
    double m_newest_s = 0.0;
    std::int64_t m_newestCell = -1; ///< -1: nothing yet
    std::vector<ColumnRange> m_cells;
    std::vector<ColumnRange> m_columns;
};

} // namespace chiron::desktop
