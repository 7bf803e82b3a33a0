// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/study/study_design.h"

#include <cstddef>
#include <vector>

namespace chiron::psychophysics {

// Building blocks of default procedures.

inline constexpr double kSmallestDifference = 1e-4; ///< smallest difference whose logarithm is taken

/// Returns the condition's table of differences on the scale of the procedure's x, ascending; never empty.
std::vector<double> usualLevels(const Condition& condition);
/// Returns the proportion of right answers of a person who feels nothing.
double guessRateOf(Task task);
/// Returns `count` equally spaced values from `low` to `high`, both included.
std::vector<double> evenGrid(double low, double high, int count);
/// Returns at most `most` of the values, evenly selected, with both ends included.
std::vector<double> someOf(const std::vector<double>& values, std::size_t most);

} // namespace chiron::psychophysics
