// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace chiron::psychophysics {

/// Williams (1949): returns rows, each an order of 0..n-1, in which every number occurs once per row, equally
/// often at each position, and is followed equally often by every other number. There are n rows if n is
/// even, and 2n (a square and its mirror image) if it is odd. Returns no rows if n < 1.
std::vector<std::vector<int>> williamsDesign(int n);

} // namespace chiron::psychophysics
