// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <vector>

namespace chiron::psychophysics {

/// Mean over subjects whose own estimates have known errors: y_i = μ + u_i + e_i, u ~ N(0, τ²), e_i ~ N(0,
/// v_i).
struct RandomEffects {
    double mean = std::numeric_limits<double>::quiet_NaN();
    double standardError = std::numeric_limits<double>::quiet_NaN(); ///< Hartung–Knapp
    double low = std::numeric_limits<double>::quiet_NaN(); ///< 95 %, t with k − 1 degrees of freedom
    double high = std::numeric_limits<double>::quiet_NaN();
    /// 95 % prediction interval for a further subject's true value, k − 2 degrees of freedom.
    double predictionLow = std::numeric_limits<double>::quiet_NaN();
    double predictionHigh = std::numeric_limits<double>::quiet_NaN();
    double tau = std::numeric_limits<double>::quiet_NaN(); ///< between subjects; REML
    /// Cochran's Q and its p (null hypothesis: all subjects are alike)
    double q = std::numeric_limits<double>::quiet_NaN();
    double qP = std::numeric_limits<double>::quiet_NaN();
    /// Share of the variance that is between subjects.
    double iSquared = std::numeric_limits<double>::quiet_NaN();
    double pZero = std::numeric_limits<double>::quiet_NaN(); ///< two-sided, of μ = 0
    int subjects = 0;
    std::vector<double> weights; ///< shares, adding up to 1
};

/// Estimates τ² by restricted maximum likelihood (Fisher scoring, Viechtbauer 2005), and the interval of the
/// mean after Hartung & Knapp (2001) with a factor of at least 1 (Röver, Knapp & Friede 2015), so that a few
/// subjects who happen to agree do not make it too short. With one subject there is only the mean.
RandomEffects randomEffects(const std::vector<double>& estimates, const std::vector<double>& variances);

/// Interval of a statistic from drawing subjects with replacement: bias-corrected and accelerated (Efron
/// 1987), with the acceleration from leaving out one subject at a time; plain percentiles if the correction
/// is undefined. Both are not numbers for fewer than 3 subjects.
struct BootstrapInterval {
    double low = std::numeric_limits<double>::quiet_NaN();
    double high = std::numeric_limits<double>::quiet_NaN();
    double percentileLow = std::numeric_limits<double>::quiet_NaN();
    double percentileHigh = std::numeric_limits<double>::quiet_NaN();
};
BootstrapInterval bootstrapSubjects(int subjects,
                                    const std::function<double(const std::vector<int>&)>& statistic,
                                    std::uint64_t seed, int samples = 2000);

} // namespace chiron::psychophysics
