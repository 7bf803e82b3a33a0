// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <limits>
#include <vector>

namespace chiron::psychophysics {

struct SampleMoments {
    int count = 0;
    double mean = std::numeric_limits<double>::quiet_NaN(); ///< not a number without values
    double sd = std::numeric_limits<double>::quiet_NaN();   ///< with count − 1; not a number for fewer than
                                                            ///< two values
};

/// Computes the moments in two passes, summed in order.
inline SampleMoments momentsOf(const std::vector<double>& values) {
    SampleMoments result;
    result.count = static_cast<int>(values.size());
    if (values.empty())
        return result;
    double sum = 0.0;
    for (const double value : values)
        sum += value;
    result.mean = sum / result.count;
    if (result.count < 2)
        return result;
    double squares = 0.0;
    for (const double value : values)
        squares += (value - result.mean) * (value - result.mean);
    result.sd = std::sqrt(squares / (result.count - 1));
    return result;
}

} // namespace chiron::psychophysics
