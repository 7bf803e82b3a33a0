// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

namespace chiron::psychophysics {

using Matrix = std::vector<std::vector<double>>; ///< small; a vector of rows

/// Returns the inverse by Gauss–Jordan elimination with partial pivoting; empty if the matrix is singular.
Matrix inverseOf(Matrix a);

/// A maximum of a smooth function of a few unknowns.
struct Maximum {
    bool found = false;
    std::vector<double> at;
    double value = 0.0;
    Matrix covariance; ///< inverse of the negative Hessian; empty if singular
    int iterations = 0;
};

/// Finds a maximum by Newton's method with derivatives by central differences; steps are halved until the
/// function rises. It is meant for functions that are concave near their maximum, with unknowns scaled to
/// order one. The maximum is found to about 1e-7.
Maximum maximise(const std::function<double(const std::vector<double>&)>& f, std::vector<double> start);

} // namespace chiron::psychophysics
