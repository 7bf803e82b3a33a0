// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/study/study_design.h"

#include <cstddef>
#include <vector>

namespace chiron::psychophysics {

// What usual procedures are made of.

inline constexpr double kSmallestDifference = 1e-4; ///< that a logarithm is taken of

/// The condition's table of differences in the scale of the procedure's x, ascending; never empty.
std::vector<double> usualLevels(const Condition& condition);
/// The proportion right of somebody who feels nothing.
double guessRateOf(Task task);
/// `count` values from `low` to `high`, both included.
std::vector<double> evenGrid(double low, double high, int count);
/// At most `most` of the values, evenly taken, the ends included.
std::vector<double> someOf(const std::vector<double>& values, std::size_t most);

} // namespace chiron::psychophysics
