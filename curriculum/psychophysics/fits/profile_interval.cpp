// SPDX-License-Identifier: GPL-3.0-or-later
#include "psychophysics/fits/profile_interval.h"

#include "psychophysics/fits/chi_square.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace chiron::psychophysics {
namespace {

constexpr int kDoublings = 14;
constexpr int kHalvings = 34;
constexpr double kInfinite = std::numeric_limits<double>::infinity();

/// The profile likelihood, with one parameter held fixed.
class Profile {
public:
    Profile(const PreparedLevels& levels, const FitOptions& options, const SearchResult& best)
        : m_levels(levels), m_sigmoid(options.function), m_free(freeParameters(options)), m_best(best),
          m_units(unitsOf(options.function)), m_shifted(levels.size()) {}

    double best() const noexcept { return m_best.logLikelihood; }

    /// Holds the threshold at `middle` (unit axis) by shifting the axis there and holding alpha.
    double atThreshold(double middle) {
        for (std::size_t i = 0; i < m_shifted.size(); ++i) {
            m_shifted[i] = m_levels.unit[i] - middle;
        }
        FreeParameters free = m_free;
        free.alpha = false;
        const LevelsView view{m_shifted.data(), m_levels.right.data(), m_levels.of.data(), m_shifted.size()};
        UnitCurve start = startFrom();
        start.alpha = m_units.middle;
        double most = -kInfinite;
        for (const double steeper : {1.0, 6.0}) {
            UnitCurve from = start;
            from.beta = std::min(start.beta, 40.0 * static_cast<double>(m_levels.size())) * steeper;
            most = std::max(most, climb(m_sigmoid, view, free, from).logLikelihood);
        }
        return most;
    }

    /// Holds the slope at `beta`.
    double atBeta(double beta) {
        FreeParameters free = m_free;
        free.beta = false;
        UnitCurve start = startFrom();
        const double middle = (m_units.middle - start.alpha) / start.beta;
        start.beta = beta;
        double most = -kInfinite;
        for (const double place : {middle, 0.0}) {
            start.alpha = m_units.middle - beta * place;
            most = std::max(most, climb(m_sigmoid, viewOf(m_levels), free, start).logLikelihood);
        }
        return most;
    }

private:
    UnitCurve startFrom() const noexcept {
        UnitCurve start = m_best.curve;
        if (m_free.lapse) {
            start.lapse = FreeParameters::startOfAsymptote(start.lapse, m_free.largestLapse);
        }
        start.guess = m_free.equal   ? start.lapse
                      : m_free.guess ? FreeParameters::startOfAsymptote(start.guess, m_free.largestGuess)
                                     : start.guess;
        return start;
    }

    const PreparedLevels& m_levels;
    Sigmoid m_sigmoid;
    FreeParameters m_free;
    const SearchResult& m_best;
    SigmoidUnits m_units;
    std::vector<double> m_shifted;
};

/// Returns the position beyond `from` where `drop` crosses 0. It searches outwards by `step`, doubled each
/// time; infinite if there is no crossing.
template <class Drop> double crossing(Drop&& drop, double from, double step) {
    double inside = from, outside = from;
    int doubling = 0;
    for (; doubling < kDoublings; ++doubling, step *= 2.0) {
        outside = inside + step;
        if (drop(outside) > 0.0) {
            break;
        }
        inside = outside;
    }
    if (doubling == kDoublings) {
        return std::copysign(kInfinite, step);
    }
    for (int halving = 0; halving < kHalvings && std::abs(outside - inside) > 1e-9 * (1.0 + std::abs(inside));
         ++halving) {
        const double between = 0.5 * (inside + outside);
        (drop(between) > 0.0 ? outside : inside) = between;
    }
    return 0.5 * (inside + outside);
}

} // namespace

ParameterIntervals profileIntervals(const PreparedLevels& levels, const FitOptions& options,
                                    const SearchResult& best) {
    Profile profile(levels, options, best);
    const int bounded = freeParameters(options).bounded();
    const double allowed = 0.5 * chiBarSquareQuantile(options.confidence, bounded);
    const StimulusScale scale = options.scale.value_or(ownScale(options.function));
    const SigmoidUnits units = unitsOf(options.function);
    const double middle = (units.middle - best.curve.alpha) / best.curve.beta;
    const auto thresholdDrop = [&](double at) { return profile.best() - profile.atThreshold(at) - allowed; };
    ParameterIntervals intervals;
    const auto given = [&](double unit) { return fromScale(levels.centre + levels.range * unit, scale); };
    intervals.threshold = {given(crossing(thresholdDrop, middle, -0.03)),
                           given(crossing(thresholdDrop, middle, 0.03))};
    const auto widthDrop = [&](double logWidth) {
        return profile.best() - profile.atBeta(units.spread / std::exp(logWidth)) - allowed;
    };
    const double least = std::log(0.05 * levels.spacing / levels.range);
    const double logWidth = std::max(std::log(units.spread / best.curve.beta), least);
    const auto widthFrom = [&](double unit) { return levels.range * std::exp(unit); };
    const bool canBeStep = best.step.logLikelihood > best.logLikelihood - allowed;
    intervals.width = {canBeStep ? 0.0 : widthFrom(crossing(widthDrop, logWidth, -0.1)),
                       widthFrom(crossing(widthDrop, logWidth, 0.1))};
    return intervals;
}

} // namespace chiron::psychophysics
