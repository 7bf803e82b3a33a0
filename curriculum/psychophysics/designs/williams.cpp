// SPDX-License-Identifier: GPL-3.0-or-later
#include "psychophysics/designs/williams.h"

#include <cstddef>

namespace chiron::psychophysics {

std::vector<std::vector<int>> williamsDesign(int n) {
    std::vector<std::vector<int>> rows;
    if (n < 1)
        return rows;
    // The first row alternates, 0 1 n-1 2 n-2 ..., so that the differences of its neighbours take every value
    // once. Each further row adds one to all numbers.
    std::vector<int> first;
    for (int i = 0; i < n; ++i)
        first.push_back(i % 2 == 1 ? (i + 1) / 2 : (n - i / 2) % n);
    for (int row = 0; row < n; ++row) {
        rows.push_back(first);
        for (int& item : rows.back())
            item = (item + row) % n;
    }
    for (std::size_t row = 0; n % 2 == 1 && n > 1 && row < static_cast<std::size_t>(n); ++row)
        rows.emplace_back(rows[row].rbegin(), rows[row].rend());
    return rows;
}

} // namespace chiron::psychophysics
