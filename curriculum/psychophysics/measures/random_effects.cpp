// SPDX-License-Identifier: GPL-3.0-or-later
#include "psychophysics/measures/random_effects.h"

#include "core/normal_distribution.h"
#include "core/random.h"
#include "psychophysics/measures/exact_tests.h"
#include "psychophysics/measures/run_curve.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace chiron::psychophysics {

namespace {

struct Weighted {
    std::vector<double> weight; ///< 1/(v + τ²)
    double sum = 0.0;
    double mean = 0.0;
};

Weighted weighted(const std::vector<double>& y, const std::vector<double>& v, double tauSquared) {
    Weighted result;
    for (std::size_t i = 0; i < y.size(); ++i) {
        result.weight.push_back(1.0 / std::max(1e-300, v[i] + tauSquared));
        result.sum += result.weight[i];
    }
    for (std::size_t i = 0; i < y.size(); ++i)
        result.mean += result.weight[i] / result.sum * y[i];
    return result;
}

double reml(const std::vector<double>& y, const std::vector<double>& v) {
    const double k = static_cast<double>(y.size());
    const double middle = std::accumulate(y.begin(), y.end(), 0.0) / k;
    double tauSquared = 0.0; // start: the observed variance minus the mean error variance
    for (std::size_t i = 0; i < y.size(); ++i)
        tauSquared += (y[i] - middle) * (y[i] - middle) / (k - 1.0) - v[i] / k;
    tauSquared = std::max(0.0, tauSquared);
    const double scale = tauSquared + std::accumulate(v.begin(), v.end(), 0.0) / k;
    for (int step = 0; step < 200; ++step) {
        const Weighted w = weighted(y, v, tauSquared);
        double squares = 0.0;
        double spread = 0.0;
        for (std::size_t i = 0; i < y.size(); ++i) {
            squares += w.weight[i] * w.weight[i];
            spread += w.weight[i] * w.weight[i] * ((y[i] - w.mean) * (y[i] - w.mean) - v[i]);
        }
        const double next = std::max(0.0, spread / squares + 1.0 / w.sum);
        if (std::abs(next - tauSquared) <= 1e-10 * scale)
            return next;
        tauSquared = next;
    }
    return tauSquared;
}

/// Fills intervals and p from a mean, its standard error and τ.
void takeIntervals(RandomEffects& result, double degrees) {
    const double half = studentQuantile(0.975, degrees) * result.standardError;
    result.low = result.mean - half;
    result.high = result.mean + half;
    if (result.subjects > 2) {
        const double further =
            studentQuantile(0.975, degrees - 1.0) * std::hypot(result.tau, result.standardError);
        result.predictionLow = result.mean - further;
        result.predictionHigh = result.mean + further;
    }
    result.qP = chiSquareUpperTail(result.q, degrees);
    result.iSquared = result.q > 0.0 ? std::max(0.0, (result.q - degrees) / result.q) : 0.0;
    result.pZero = 2.0 * studentUpperTail(std::abs(result.mean) / result.standardError, degrees);
}

/// Returns the bias correction; not a number if none of the values is below (or above) the estimate.
double biasCorrection(const std::vector<double>& sorted, double estimate) {
    const auto below = std::lower_bound(sorted.begin(), sorted.end(), estimate) - sorted.begin();
    const auto upTo = std::upper_bound(sorted.begin(), sorted.end(), estimate) - sorted.begin();
    const double share = 0.5 * static_cast<double>(below + upTo) / static_cast<double>(sorted.size());
    return share > 0.0 && share < 1.0 ? core::normalQuantile(share)
                                      : std::numeric_limits<double>::quiet_NaN();
}

double acceleration(int subjects, const std::function<double(const std::vector<int>&)>& statistic) {
    std::vector<double> without;
    for (int left = 0; left < subjects; ++left) {
        std::vector<int> rest;
        for (int i = 0; i < subjects; ++i)
            if (i != left)
                rest.push_back(i);
        without.push_back(statistic(rest));
    }
    const double mean = std::accumulate(without.begin(), without.end(), 0.0) / subjects;
    double squares = 0.0;
    double cubes = 0.0;
    for (const double value : without) {
        squares += (mean - value) * (mean - value);
        cubes += std::pow(mean - value, 3);
    }
    return squares > 0.0 ? cubes / (6.0 * std::pow(squares, 1.5)) : 0.0;
}

} // namespace

RandomEffects randomEffects(const std::vector<double>& estimates, const std::vector<double>& variances) {
    RandomEffects result;
    std::vector<double> y;
    std::vector<double> v;
    for (std::size_t i = 0; i < std::min(estimates.size(), variances.size()); ++i)
        if (std::isfinite(estimates[i]) && std::isfinite(variances[i]) && variances[i] >= 0.0) {
            y.push_back(estimates[i]);
            v.push_back(variances[i]);
        }
    result.subjects = static_cast<int>(y.size());
    if (y.empty())
        return result;
    if (y.size() == 1) {
        result.mean = y[0];
        result.weights = {1.0};
        return result;
    }
    const double degrees = result.subjects - 1.0;
    const double tauSquared = reml(y, v);
    const Weighted w = weighted(y, v, tauSquared);
    const Weighted fixed = weighted(y, v, 0.0);
    double factor = 0.0;
    result.q = 0.0;
    for (std::size_t i = 0; i < y.size(); ++i) {
        factor += w.weight[i] * (y[i] - w.mean) * (y[i] - w.mean) / degrees;
        result.q += fixed.weight[i] * (y[i] - fixed.mean) * (y[i] - fixed.mean);
        result.weights.push_back(w.weight[i] / w.sum);
    }
    result.mean = w.mean;
    result.tau = std::sqrt(tauSquared);
    result.standardError = std::sqrt(std::max(1.0, factor) / w.sum);
    takeIntervals(result, degrees);
    return result;
}

BootstrapInterval bootstrapSubjects(int subjects,
                                    const std::function<double(const std::vector<int>&)>& statistic,
                                    std::uint64_t seed, int samples) {
    BootstrapInterval result;
    if (subjects < 3)
        return result;
    auto random = core::Random::stream(seed, "bootstrap over subjects");
    std::vector<int> drawn(static_cast<std::size_t>(subjects));
    std::iota(drawn.begin(), drawn.end(), 0);
    const double estimate = statistic(drawn);
    std::vector<double> values;
    for (int sample = 0; sample < samples; ++sample) {
        for (int& index : drawn)
            index = static_cast<int>(random.below(static_cast<std::uint64_t>(subjects)));
        const double value = statistic(drawn);
        if (std::isfinite(value))
            values.push_back(value);
    }
    std::sort(values.begin(), values.end());
    result.low = result.percentileLow = quantileOf(values, 0.025);
    result.high = result.percentileHigh = quantileOf(values, 0.975);
    const double bias =
        values.empty() ? std::numeric_limits<double>::quiet_NaN() : biasCorrection(values, estimate);
    const double a = acceleration(subjects, statistic);
    if (!std::isfinite(bias) || !std::isfinite(a))
        return result;
    const auto adjusted = [&](double share) {
        const double z = bias + core::normalQuantile(share);
        return core::normalCumulative(bias + z / (1.0 - a * z));
    };
    result.low = quantileOf(values, adjusted(0.025));
    result.high = quantileOf(values, adjusted(0.975));
    return result;
}

} // namespace chiron::psychophysics
