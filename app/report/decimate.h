// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

namespace chiron::report {

struct Polyline {
    std::vector<double> x;
    std::vector<double> y;
};

/// Reduces a long line for drawing on `columns` pixel columns: of each column it keeps the first, the lowest,
/// the highest and the last sample, in their order, so that no peak and no join between columns is lost (M4:
/// Jugel et al., PVLDB 7(10), 2014). x ascending; a run of non-finite y stays as one gap; the shorter vector
/// counts. A line of at most 4·columns points comes back as it is. Pure.
Polyline decimate(std::span<const double> x, std::span<const double> y, int columns);

/// The line max(y, limit), with the crossings put in where the line passes the limit: together with the limit
/// it bounds the area above. Non-finite y count as not above. Pure.
Polyline partAbove(const Polyline& line, double limit);

} // namespace chiron::report
