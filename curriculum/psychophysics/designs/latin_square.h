// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/study/study_design.h"

#include <cstdint>
#include <vector>

namespace chiron::psychophysics {

/// Returns n rows, each an order of 0..n-1, in which every number occurs once per row and once per position:
/// the cyclic square with rows, positions and names shuffled. Not every Latin square can result, but those
/// that can are equally likely. Returns no rows if n < 1.
std::vector<std::vector<int>> latinSquare(int n, std::uint64_t seed);

/// Returns the order of n conditions for participant number `row` (from 0; the rows of the design are reused
/// cyclically). fixed: 0..n-1; random: shuffled, depending only on seed and row.
std::vector<int> orderFor(OrderDesign design, int n, int row, std::uint64_t seed);

} // namespace chiron::psychophysics
