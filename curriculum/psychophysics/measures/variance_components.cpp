// SPDX-License-Identifier: GPL-3.0-or-later
#include "psychophysics/measures/variance_components.h"

#include "psychophysics/measures/sample_moments.h"

#include <algorithm>
#include <cmath>

namespace chiron::psychophysics {

namespace {

struct Group {
    double size = 0.0;
    double mean = 0.0;
};

struct Layout {
    std::vector<Group> groups;
    double trials = 0.0;
    double squaresWithin = 0.0;
};

/// The terms of the restricted likelihood at one ratio of between to within.
struct AtRatio {
    double mean = 0.0;
    double squares = 0.0;  ///< (trials − 1) times the variance within
    double deviance = 0.0; ///< −2 ln of the restricted likelihood, up to a constant
    double slope = 0.0;    ///< derivative of the deviance with respect to the ratio
};

AtRatio atRatio(const Layout& layout, double ratio) {
    double weights = 0.0, weighted = 0.0, squaresOfWeights = 0.0, logs = 0.0;
    for (const Group& group : layout.groups) {
        const double weight = group.size / (1.0 + group.size * ratio);
        weights += weight;
        weighted += weight * group.mean;
        squaresOfWeights += weight * weight;
        logs += std::log1p(group.size * ratio);
    }
    AtRatio result;
    result.mean = weighted / weights;
    result.squares = layout.squaresWithin;
    double pull = 0.0;
    for (const Group& group : layout.groups) {
        const double weight = group.size / (1.0 + group.size * ratio);
        const double off = weight * (group.mean - result.mean) * (group.mean - result.mean);
        result.squares += off;
        pull += weight * off;
    }
    result.deviance = (layout.trials - 1.0) * std::log(result.squares) + logs + std::log(weights);
    result.slope = weights - squaresOfWeights / weights - (layout.trials - 1.0) * pull / result.squares;
    return result;
}

/// Returns the ratio with the smallest deviance: the best point of a grid over decades, then bisection
/// between its neighbours by the sign of the slope.
double bestRatio(const Layout& layout) {
    constexpr double kFirst = -8.0, kLast = 12.0, kStep = 0.05; // log10
    double best = 0.0, least = atRatio(layout, 0.0).deviance, low = 0.0, high = std::pow(10.0, kFirst);
    for (double place = kFirst; place <= kLast; place += kStep) {
        const double ratio = std::pow(10.0, place);
        if (const double deviance = atRatio(layout, ratio).deviance; deviance < least) {
            least = deviance;
            best = ratio;
            low = place > kFirst ? std::pow(10.0, place - kStep) : 0.0;
            high = std::pow(10.0, place + kStep);
        }
    }
    if (best == 0.0 && !(atRatio(layout, 0.0).slope < 0.0))
        return 0.0;
    constexpr int kHalvings = 200;
    for (int i = 0; i < kHalvings && low < high; ++i) {
        const double middle = 0.5 * (low + high);
        (atRatio(layout, middle).slope < 0.0 ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

Layout layoutOf(const std::vector<std::vector<double>>& groups) {
    Layout layout;
    for (const std::vector<double>& group : groups) {
        if (group.empty())
            continue;
        const SampleMoments m = momentsOf(group);
        layout.groups.push_back({static_cast<double>(m.count), m.mean});
        layout.trials += m.count;
        layout.squaresWithin += m.count > 1 ? m.sd * m.sd * (m.count - 1) : 0.0;
    }
    return layout;
}

} // namespace

VarianceComponents varianceComponents(const std::vector<std::vector<double>>& groups) {
    const Layout layout = layoutOf(groups);
    VarianceComponents result;
    if (layout.groups.empty())
        return result;
    const auto count = static_cast<double>(layout.groups.size());
    result.mean = atRatio(layout, 0.0).mean;
    if (!(layout.trials > count)) // one trial per group: the two variances cannot be separated
        return result;
    if (layout.groups.size() == 1) {
        result.within = layout.squaresWithin / (layout.trials - 1.0);
        return result;
    }
    if (!(layout.squaresWithin > 0.0)) { // all trials within each participant are equal: any variance is
                                         // between
        std::vector<double> means;
        for (const Group& group : layout.groups)
            means.push_back(group.mean);
        const SampleMoments m = momentsOf(means);
        result.mean = m.mean;
        result.within = 0.0;
        result.between = m.sd * m.sd;
        result.cut = !(result.between > 0.0);
        return result;
    }
    const double ratio = bestRatio(layout);
    const AtRatio best = atRatio(layout, ratio);
    result.mean = best.mean;
    result.within = best.squares / (layout.trials - 1.0);
    result.between = ratio * result.within;
    result.cut = ratio == 0.0;
    return result;
}

} // namespace chiron::psychophysics
