// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <vector>

namespace chiron::psychophysics {

/// One-way random effects: y_ij = μ + u_i + e_ij, u ~ N(0, between), e ~ N(0, within); group i is a participant, j a trial.
struct VarianceComponents {
    double mean = std::numeric_limits<double>::quiet_NaN();    ///< generalised least squares
    double within = std::numeric_limits<double>::quiet_NaN();  ///< variances
    double between = std::numeric_limits<double>::quiet_NaN(); ///< not a number with one group
    bool cut = false; ///< groups differ less than chance lets them: between is 0 and all trials are pooled
};

/// By restricted maximum likelihood (Patterson & Thompson 1971; Searle, Casella & McCulloch 1992, §3.8), groups of any sizes: the ratio of the variances
/// is searched from 0 on, the rest follows in closed form. Where 0 is best, `within` is the variance of all trials about their mean, and not the mean
/// square within groups. Groups without a trial are left out; not numbers where no variance can be had.
VarianceComponents varianceComponents(const std::vector<std::vector<double>>& groups);

} // namespace chiron::psychophysics
