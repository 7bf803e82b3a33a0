// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <vector>

namespace chiron::psychophysics {

/// One-way random effects: y_ij = μ + u_i + e_ij, u ~ N(0, between), e ~ N(0, within). Group i is a
/// participant, j a trial.
struct VarianceComponents {
    double mean = std::numeric_limits<double>::quiet_NaN();    ///< generalised least squares
    double within = std::numeric_limits<double>::quiet_NaN();  ///< variance, as `between`
    double between = std::numeric_limits<double>::quiet_NaN(); ///< not a number for one group
    /// The groups differ less than chance would make them: between is 0 and all trials are pooled.
    bool cut = false;
};

/// Estimates by restricted maximum likelihood (Patterson & Thompson 1971; Searle, Casella & McCulloch 1992,
/// §3.8), for groups of any sizes. The ratio of the variances is searched from 0 upwards; the rest follows in
/// closed form. If 0 is best, `within` is the variance of all trials about their mean and not the mean square
/// within groups. Groups without a trial are left out. The results are not numbers if no variance can be
/// estimated.
VarianceComponents varianceComponents(const std::vector<std::vector<double>>& groups);

} // namespace chiron::psychophysics
