// SPDX-License-Identifier: GPL-3.0-or-later
#include "psychophysics/fits/bootstrap.h"

#include "core/normal_distribution.h"
#include "core/random.h"
#include "psychophysics/fits/binomial_sampler.h"
#include "psychophysics/fits/fit_summary.h"

#include <algorithm>
#include <cmath>

namespace chiron::psychophysics {
namespace {

constexpr double kFewestForInterval = 100.0; ///< repetitions: with fewer, the ends at 2.5 % would rest on
                                             ///< single ones

/// Fits data sets that differ from the original one only in their answers.
class Refits {
public:
    Refits(const PreparedLevels& levels, const FitOptions& options)
        : m_levels(levels), m_sigmoid(options.function), m_free(freeParameters(options)),
          m_lapse(m_free.lapse ? 0.0 : options.lapse.value),
          m_guess(m_free.guess || m_free.equal ? 0.0 : options.guess.value), m_right(levels.right),
          m_of(levels.of) {}

    std::vector<double>& right() noexcept { return m_right; }
    std::vector<double>& of() noexcept { return m_of; }
    LevelsView view() const noexcept {
        return {m_levels.unit.data(), m_right.data(), m_of.data(), m_right.size()};
    }
    SearchResult search() const noexcept {
        return searchMaximum(m_sigmoid, view(), m_free, m_lapse, m_guess);
    }
    CurveParameters parameters(const SearchResult& found) const noexcept {
        return fromUnit(found.curve, m_levels, m_sigmoid);
    }
    void draw(const std::vector<BinomialSampler>& samplers, core::Random& random) noexcept {
        for (std::size_t i = 0; i < samplers.size(); ++i) {
            m_right[i] = samplers[i].draw(random);
        }
    }

private:
    const PreparedLevels& m_levels;
    Sigmoid m_sigmoid;
    FreeParameters m_free;
    double m_lapse, m_guess;
    std::vector<double> m_right, m_of;
};

std::vector<BinomialSampler> samplersOf(const FitResult& result, bool fromCurve) {
    std::vector<BinomialSampler> samplers;
    for (const FittedLevel& level : result.levels) {
        samplers.emplace_back(level.of, fromCurve ? level.fitted : level.right / level.of);
    }
    return samplers;
}

double monteCarloP(const FitResult& result, const PreparedLevels& levels, const FitOptions& options) {
    Refits refits(levels, options);
    const auto samplers = samplersOf(result, true);
    core::Random random = core::Random::stream(options.seed, "goodness of fit");
    int asLarge = 0;
    for (int i = 0; i < options.monteCarlo; ++i) {
        refits.draw(samplers, random);
        const double deviance = 2.0 * (saturatedLogLikelihood(refits.view()) - refits.search().logLikelihood);
        asLarge += deviance >= result.deviance - 1e-9 ? 1 : 0;
    }
    return (1.0 + asLarge) / (1.0 + options.monteCarlo);
}

void drawBootstrap(FitResult& result, const PreparedLevels& levels, const FitOptions& options) {
    Refits refits(levels, options);
    const auto samplers = samplersOf(result, options.bootstrap == Bootstrap::parametric);
    core::Random random = core::Random::stream(options.seed, "bootstrap");
    result.draws.reserve(static_cast<std::size_t>(options.bootstrapSamples));
    for (int i = 0; i < options.bootstrapSamples; ++i) {
        refits.draw(samplers, random);
        const SearchResult found = refits.search();
        if (found.kind != SearchResult::Kind::flat) {
            result.draws.push_back(refits.parameters(found));
        }
    }
}

using Field = double CurveParameters::*;

/// An estimate with one answer left out, and the number of answers that lead to this estimate.
struct LeftOut {
    CurveParameters estimate;
    double weight;
};

std::vector<LeftOut> leaveOneOut(const PreparedLevels& levels, const FitOptions& options) {
    std::vector<LeftOut> out;
    Refits refits(levels, options);
    for (std::size_t i = 0; i < levels.size(); ++i) {
        for (const double right : {1.0, 0.0}) {
            const double weight = right > 0.0 ? levels.right[i] : levels.of[i] - levels.right[i];
            if (weight <= 0.0 || levels.of[i] < 2.0) {
                continue;
            }
            refits.right()[i] = levels.right[i] - right;
            refits.of()[i] = levels.of[i] - 1.0;
            const SearchResult found = refits.search();
            if (found.kind != SearchResult::Kind::flat) {
                out.push_back({refits.parameters(found), weight});
            }
            refits.right()[i] = levels.right[i];
            refits.of()[i] = levels.of[i];
        }
    }
    return out;
}

double acceleration(const std::vector<LeftOut>& estimates, Field field) noexcept {
    double sum = 0.0, weight = 0.0;
    for (const LeftOut& one : estimates) {
        sum += one.weight * one.estimate.*field;
        weight += one.weight;
    }
    double squares = 0.0, cubes = 0.0;
    for (const LeftOut& one : estimates) {
        const double away = sum / weight - one.estimate.*field;
        squares += one.weight * away * away;
        cubes += one.weight * away * away * away;
    }
    return squares > 0.0 ? cubes / (6.0 * std::pow(squares, 1.5)) : 0.0;
}

/// Returns the BCa interval of one parameter (Efron 1987): percentiles at Φ(z0 + (z0 + z)/(1 − a(z0 + z))).
FitInterval correctedInterval(const FitResult& result, const std::vector<LeftOut>& leftOut, Field field) {
    std::vector<double> values;
    double below = 0.0;
    for (const CurveParameters& draw : result.draws) {
        values.push_back(draw.*field);
        below += draw.*field < result.best.*field ? 1.0 : draw.*field == result.best.*field ? 0.5 : 0.0;
    }
    std::sort(values.begin(), values.end());
    const double count = static_cast<double>(values.size());
    const double bias = core::normalQuantile(std::clamp(below / count, 0.5 / count, 1.0 - 0.5 / count));
    const double a = acceleration(leftOut, field);
    const auto quantile = [&](double tail) {
        const double z = bias + core::normalQuantile(tail);
        const double corrected = core::normalCumulative(bias + z / (1.0 - a * z));
        const double place = std::clamp(corrected * (count + 1.0) - 1.0, 0.0, count - 1.0);
        const auto at = static_cast<std::size_t>(place);
        const double next = values[std::min(at + 1, values.size() - 1)];
        return values[at] + (place - static_cast<double>(at)) * (next - values[at]);
    };
    const double tail = 0.5 * (1.0 - result.confidence);
    return {quantile(tail), quantile(1.0 - tail)};
}

void addBootstrapIntervals(FitResult& result, const PreparedLevels& levels, const FitOptions& options) {
    const auto asked = static_cast<double>(options.bootstrapSamples);
    const auto had = static_cast<double>(result.draws.size());
    if (had < 0.95 * asked) {
        result.warnings.push_back(
            "bootstrap_failures: " + std::to_string(options.bootstrapSamples - static_cast<int>(had)) +
            " of " + std::to_string(options.bootstrapSamples) +
            " simulated repetitions had no threshold; the interval is too narrow");
    }
    if (had < kFewestForInterval) {
        result.warnings.push_back("no_interval: " + std::to_string(static_cast<int>(had)) +
                                  " simulated repetitions give no interval; expected at least " +
                                  std::to_string(static_cast<int>(kFewestForInterval)));
        return;
    }
    const auto leftOut = leaveOneOut(levels, options);
    const auto interval = [&](Field field) { return correctedInterval(result, leftOut, field); };
    result.ci.threshold = interval(&CurveParameters::threshold);
    result.ci.threshold = {fromScale(result.ci.threshold.low, result.scale),
                           fromScale(result.ci.threshold.high, result.scale)};
    result.ci.width = interval(&CurveParameters::width);
    const FreeParameters free = freeParameters(options);
    if (free.lapse) {
        result.ci.lapse = interval(&CurveParameters::lapse);
    }
    if (free.guess || free.equal) {
        result.ci.guess = interval(&CurveParameters::guess);
    }
}

} // namespace

void addSimulations(FitResult& result, const PreparedLevels& levels, const FitOptions& options) {
    if (options.monteCarlo > 0) {
        result.pValue = monteCarloP(result, levels, options);
    }
    if (options.bootstrap != Bootstrap::none && options.bootstrapSamples > 0) {
        drawBootstrap(result, levels, options);
        addBootstrapIntervals(result, levels, options);
    }
}

} // namespace chiron::psychophysics
