// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace chiron::desktop {

/// Lowest and highest value in one pixel column; `any` is false if it contains no sample.
struct ColumnRange {
    double lowest = 0.0;
    double highest = 0.0;
    bool any = false;
};

/// The last seconds of a 1 kHz signal for a scrolling plot. Each cell keeps the lowest and highest value of
/// its time interval, and columns consist of whole cells, so that no peak is lost between pixels. add() and
/// columns() allocate nothing once the size is known.
/// Thread: one.
class ColumnTrace {
public:
    static constexpr std::size_t kCells = 2048; ///< more than the width of any plot in pixels

    explicit ColumnTrace(double span_s);

    /// Times must not decrease. A sample that is older than the span, or not finite, is ignored.
    void add(double t_s, double value) noexcept;
    void clear() noexcept;

    double newest_s() const noexcept { return m_newest_s; }
    double span_s() const noexcept { return m_span_s; }
    /// Highest value in the span; 0 if there is none.
    double highest() const noexcept;
    /// Returns `count` columns (kCells at most), oldest first; the last one contains the newest sample.
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
