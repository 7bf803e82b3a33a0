// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/study/study_design.h"

#include <cstdint>
#include <vector>

namespace chiron::psychophysics {

/// n rows of orders of 0..n-1, each once a row and once a place: the cyclic square with rows, places and names shuffled (not all Latin
/// squares, each of these alike likely). n < 1: no rows.
std::vector<std::vector<int>> latinSquare(int n, std::uint64_t seed);

/// The order of n conditions for the participant who came `row`-th (from 0; the design's rows are used over and over).
/// fixed: 0..n-1; random: shuffled, by seed and row alone.
std::vector<int> orderFor(OrderDesign design, int n, int row, std::uint64_t seed);

} // namespace chiron::psychophysics
