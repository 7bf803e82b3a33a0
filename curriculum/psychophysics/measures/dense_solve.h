// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

namespace chiron::psychophysics {

using Matrix = std::vector<std::vector<double>>; ///< small, rows

/// Inverse by Gauss–Jordan with partial pivoting; empty where singular.
Matrix inverseOf(Matrix a);

/// A maximum of a smooth function of a few unknowns.
struct Maximum {
    bool found = false;
    std::vector<double> at;
    double value = 0.0;
    Matrix covariance; ///< inverse of minus the Hessian; empty where singular
    int iterations = 0;
};

/// Newton's method with derivatives by central differences, steps halved until the function rises. For functions that are concave about
/// their maximum and scaled to unknowns of order one; the maximum is found to about 1e-7.
Maximum maximise(const std::function<double(const std::vector<double>&)>& f, std::vector<double> start);

} // namespace chiron::psychophysics
