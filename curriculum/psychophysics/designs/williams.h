// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace chiron::psychophysics {

/// Williams (1949): rows of orders of 0..n-1 in which each comes once a row, equally often at each place, and is followed by each other
/// equally often: n rows where n is even, 2n (a square and its mirror image) where it is odd. n < 1: no rows.
std::vector<std::vector<int>> williamsDesign(int n);

} // namespace chiron::psychophysics
