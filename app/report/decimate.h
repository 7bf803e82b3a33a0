// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

namespace chiron::report {

struct Polyline {
    std::vector<double> x;
    std::vector<double> y;
};

/// Reduces a long line for drawing on `columns` pixel columns. For each column it keeps the first, the
/// lowest, the highest and the last sample in their order, so that no peak and no connection between columns
/// is lost (M4: Jugel et al., PVLDB 7(10), 2014). x must be ascending. A run of non-finite y remains as one
/// gap. If the vectors differ in length, the shorter one determines the number of samples. A line of at most
/// 4·columns points is returned unchanged. Pure function.
Polyline decimate(std::span<const double> x, std::span<const double> y, int columns);

/// Returns the line max(y, limit), with the points inserted at which the line crosses the limit; together
/// with the limit it bounds the area above. Non-finite y count as not above. Pure function.
Polyline partAbove(const Polyline& line, double limit);

} // namespace chiron::report
