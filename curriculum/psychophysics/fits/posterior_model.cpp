// SPDX-License-Identifier: GPL-3.0-or-later
#include "psychophysics/fits/posterior_model.h"

#include "psychophysics/fits/beta_binomial.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace chiron::psychophysics {
namespace {

constexpr double kImpossible = -std::numeric_limits<double>::infinity();

} // namespace

double PosteriorModel::logDensity(const CurveParameters& at) const noexcept {
    if (!(at.eta >= 0.0 && at.eta < kMostEta) || (free.lapse && at.lapse > free.largestLapse) ||
        (free.guess && at.guess > free.largestGuess)) {
        return kImpossible;
    }
    double sum = priors.logThreshold(at.threshold) + priors.logWidth(at.width) + priors.logShare(at.eta) +
                 (free.lapse ? priors.logShare(at.lapse) : 0.0) +
                 (free.guess ? priors.logShare(at.guess) : 0.0);
    if (!std::isfinite(sum)) {
        return kImpossible;
    }
    const SigmoidUnits units = unitsOf(sigmoid);
    const double reach = 1.0 - at.lapse - at.guess, slope = units.spread / at.width;
    for (std::size_t i = 0; i < levels.size(); ++i) {
        const SigmoidValue s = sigmoidAt(sigmoid, units.middle + slope * (levels.unit[i] - at.threshold));
        sum += betaBinomialLog(levels.right[i], levels.of[i], at.guess + reach * s.rise,
                               at.lapse + reach * s.rest, at.eta);
    }
    return sum;
}

} // namespace chiron::psychophysics
