// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/random.h"

#include <vector>

namespace chiron::psychophysics {

/// Draws from Binomial(n, p) by inversion of a table of the distribution, which is truncated at ten standard
/// deviations from the mean.
class BinomialSampler {
public:
    BinomialSampler(double n, double p);
    double draw(core::Random& random) const noexcept;

private:
    double m_first = 0.0;             ///< count of the table's first entry
    std::vector<double> m_cumulative; ///< ascending; the last one is 1
};

} // namespace chiron::psychophysics
