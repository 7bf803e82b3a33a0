// SPDX-License-Identifier: GPL-3.0-or-later
#include "psychophysics/fits/likelihood_search.h"

#include "psychophysics/fits/scoring_step.h"
#include "psychophysics/fits/sigmoid_shapes.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace chiron::psychophysics {
namespace {

constexpr int kMostSteps = 100;
constexpr double kLogisticSpread = 5.8888779583; ///< 2 ln 19

template <class Shape, bool Ends>
SearchResult climbShape(const LevelsView& levels, const FreeParameters& free, const UnitCurve& start,
                        const ClimbGoal& goal) noexcept {
    SearchResult result;
    result.curve = start;
    auto sums = scoring::sumsAt<Shape, Ends>(levels, start, free.equal);
    double damping = 0.0;
    for (int step = 0; step < kMostSteps; ++step) {
        const auto [move, decrement] = scoring::stepFrom<Ends>(sums, result.curve, free, damping);
        const bool hopeless = step > 4 && sums.logLikelihood + 20.0 * decrement + 0.5 < goal.beat;
        if (!(decrement > goal.enough) || hopeless) {
            result.converged = decrement >= 0.0 && !hopeless;
            break;
        }
        const UnitCurve tried = scoring::moved(result.curve, move, free);
        const auto there = scoring::sumsAt<Shape, Ends>(levels, tried, free.equal);
        if (there.logLikelihood >= sums.logLikelihood) {
            result.curve = tried;
            sums = there;
            damping = damping < 1e-3 ? 0.0 : 0.1 * damping;
        } else if (decrement < 1e-9) { // rounding error of the sum: no further gain is possible
            result.converged = true;
            break;
        } else {
            damping = damping == 0.0 ? 0.1 : 5.0 * damping;
        }
    }
    result.logLikelihood = sums.logLikelihood;
    result.pearson = sums.pearson;
    return result;
}

/// Fits a line through the logits of the proportions (guess and lapse removed), weighted by the information
/// in each level.
UnitCurve lineStart(Sigmoid sigmoid, const LevelsView& levels, double lapse, double guess) noexcept {
    const double reach = 1.0 - lapse - guess;
    double sw = 0.0, su = 0.0, st = 0.0, suu = 0.0, sut = 0.0;
    for (std::size_t i = 0; i < levels.size; ++i) {
        const double u = levels.unit[i];
        if (!std::isfinite(u)) {
            continue;
        }
        const double s =
            std::clamp(((levels.right[i] + 0.5) / (levels.of[i] + 1.0) - guess) / reach, 0.02, 0.98);
        const double psi = guess + reach * s;
        const double slope = reach * s * (1.0 - s);
        const double w = levels.of[i] * slope * slope / (psi * (1.0 - psi));
        const double t = std::log(s / (1.0 - s));
        sw += w;
        su += w * u;
        st += w * t;
        suu += w * u * u;
        sut += w * u * t;
    }
    const double spread = sw * suu - su * su;
    double slope = spread > 0.0 ? (sw * sut - su * st) / spread : 1.0;
    slope = slope > 0.5 ? slope : 0.5;
    const double level = (st - slope * su) / sw;
    const SigmoidUnits units = unitsOf(sigmoid);
    const double factor = units.spread / kLogisticSpread;
    return {units.middle + factor * level, factor * slope, lapse, guess};
}

UnitCurve stepStart(Sigmoid sigmoid, const LevelsView& levels, const StepCurve& step, double width,
                    const FreeParameters& free) noexcept {
    const SigmoidUnits units = unitsOf(sigmoid);
    const double at = levels.unit[step.level];
    const double before =
        step.level > 0 && std::isfinite(levels.unit[step.level - 1]) ? levels.unit[step.level - 1] : at;
    const double beta = units.spread / width;
    const double lapse =
        free.lapse ? FreeParameters::startOfAsymptote(step.lapse, free.largestLapse) : step.lapse;
    const double guess = free.guess   ? FreeParameters::startOfAsymptote(step.guess, free.largestGuess)
                         : free.equal ? lapse
                                      : step.guess;
    return {units.middle - beta * (step.atLevel ? at : 0.5 * (at + before)), beta, lapse, guess};
}

void keepBetter(SearchResult& best, const SearchResult& other) noexcept {
    if (other.logLikelihood > best.logLikelihood) {
        const StepCurve step = best.step;
        best = other;
        best.step = step;
    }
}

constexpr double kExploring = 1e-4; ///< Newton decrement at which an exploratory climb ends

void explore(Sigmoid sigmoid, const LevelsView& levels, const FreeParameters& free, const UnitCurve& start,
             SearchResult& best) noexcept {
    keepBetter(best, climb(sigmoid, levels, free, start, {kExploring, best.logLikelihood}));
}

/// Climbs from the best few curves of a grid.
void exploreGrid(Sigmoid sigmoid, const LevelsView& levels, const FreeParameters& free,
                 SearchResult& best) noexcept {
    const SigmoidUnits units = unitsOf(sigmoid);
    constexpr std::size_t kKept = 5;
    std::array<std::pair<double, UnitCurve>, kKept> kept;
    kept.fill({-std::numeric_limits<double>::infinity(), {}});
    const bool ends = free.lapse || free.guess;
    for (const double share : {0.02, 0.3}) {
        const double lapse = free.lapse ? std::min(share, free.largestLapse) : best.curve.lapse;
        const double guess = free.equal   ? lapse
                             : free.guess ? std::min(share, free.largestGuess)
                                          : best.curve.guess;
        for (const double width : {0.08, 0.3, 1.2}) {
            for (const double place : {-0.5, -0.25, 0.0, 0.25, 0.5}) {
                const double beta = units.spread / width;
                const UnitCurve curve{units.middle - beta * place, beta, lapse, guess};
                const double height = logLikelihood(sigmoid, levels, curve);
                const auto worst = std::min_element(
                    kept.begin(), kept.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
                if (height > worst->first) {
                    *worst = {height, curve};
                }
            }
        }
        if (!ends) {
            break;
        }
    }
    for (const auto& [height, curve] : kept) {
        if (std::isfinite(height)) {
            explore(sigmoid, levels, free, curve, best);
        }
    }
}

/// Climbs that look for a second maximum.
void exploreElsewhere(Sigmoid sigmoid, const LevelsView& levels, const FreeParameters& free,
                      SearchResult& best, double flat) noexcept {
    const bool freeEnds = free.lapse || free.guess;
    const double freedom = std::max(1.0, static_cast<double>(levels.size) - free.count());
    const bool poor = best.pearson > freedom + std::sqrt(2.0 * freedom);
    const bool atLimit = std::max(flat, best.step.logLikelihood) > best.logLikelihood - 0.05;
    constexpr double kClose = 6.0; // a step that is less likely by more than this has no maximum near it that
                                   // could win
    if (freeEnds || best.step.logLikelihood > best.logLikelihood - kClose) {
        const double gap = 1.0 / static_cast<double>(levels.size);
        for (const double width : {gap, 0.35}) {
            explore(sigmoid, levels, free, stepStart(sigmoid, levels, best.step, width, free), best);
        }
    }
    if (freeEnds) {
        const double lapse = free.lapse ? std::min(0.12, free.largestLapse) : best.curve.lapse;
        const double guess = free.guess   ? std::min(0.12, free.largestGuess)
                             : free.equal ? lapse
                                          : best.curve.guess;
        explore(sigmoid, levels, free, lineStart(sigmoid, levels, lapse, guess), best);
    }
    if (poor || atLimit) {
        exploreGrid(sigmoid, levels, free, best);
    }
}

/// Chooses between the curve found and the two limits.
void chooseKind(Sigmoid sigmoid, const LevelsView& levels, SearchResult& best, double flat) noexcept {
    constexpr double kSame = 1e-7;
    if (flat >= best.logLikelihood - kSame && flat >= best.step.logLikelihood) {
        best.kind = SearchResult::Kind::flat;
        best.logLikelihood = std::max(flat, best.logLikelihood);
    } else if (best.step.logLikelihood >= best.logLikelihood - kSame) {
        best.kind = SearchResult::Kind::step;
        best.curve = curveOf(best.step, levels, sigmoid);
        best.logLikelihood = std::max(best.step.logLikelihood, best.logLikelihood);
    }
}

constexpr double kGained = 1e-9; ///< smallest gain in log-likelihood that counts as another maximum

/// Climbs repeatedly, because a hundred steps do not reach the end of a ridge (a wide curve, a large lapse
/// rate).
void climbToTheEnd(Sigmoid sigmoid, const LevelsView& levels, const FreeParameters& free,
                   SearchResult& best) noexcept {
    constexpr int kMostClimbs = 30;
    for (int again = 0; again < kMostClimbs; ++again) {
        const double before = best.logLikelihood;
        keepBetter(best, climb(sigmoid, levels, free, best.curve));
        if (!(best.logLikelihood > before + kGained)) {
            return;
        }
    }
}

/// Climbs from the most likely positions for each width and each pair of asymptotes.
void exploreWidely(Sigmoid sigmoid, const LevelsView& levels, const FreeParameters& free, double lapse,
                   double guess, SearchResult& best) noexcept {
    const SigmoidUnits units = unitsOf(sigmoid);
    constexpr std::array<double, 4> shares{0.0, 0.03, 0.15, 1.0};
    for (const double lapseShare : shares) {
        for (const double guessShare : shares) {
            const double startLapse = free.lapse ? lapseShare * free.largestLapse : lapse;
            const double startGuess = free.equal   ? startLapse
                                      : free.guess ? guessShare * free.largestGuess
                                                   : guess;
            for (const double width : {0.03, 0.1, 0.3, 1.0, 3.0, 15.0}) {
                const double beta = units.spread / width;
                std::pair<double, UnitCurve> first{-std::numeric_limits<double>::infinity(), {}},
                    second = first;
                for (double place = -1.0; place < 1.01; place += 0.125) {
                    const UnitCurve curve{units.middle - beta * place, beta, startLapse, startGuess};
                    if (const double height = logLikelihood(sigmoid, levels, curve); height > first.first) {
                        second = std::exchange(first, {height, curve});
                    } else if (height > second.first) {
                        second = {height, curve};
                    }
                }
                for (const auto& [height, curve] : {first, second}) {
                    if (std::isfinite(height)) {
                        explore(sigmoid, levels, free, curve, best);
                    }
                }
            }
            if (!free.guess) {
                break;
            }
        }
        if (!free.lapse) {
            break;
        }
    }
}

} // namespace

SearchResult climb(Sigmoid sigmoid, const LevelsView& levels, const FreeParameters& free,
                   const UnitCurve& start, const ClimbGoal& goal) noexcept {
    return shapes::withShape(sigmoid, [&]<class Shape>() noexcept {
        return free.lapse || free.guess ? climbShape<Shape, true>(levels, free, start, goal)
                                        : climbShape<Shape, false>(levels, free, start, goal);
    });
}

SearchResult searchMaximum(Sigmoid sigmoid, const LevelsView& levels, const FreeParameters& free,
                           double lapse, double guess) noexcept {
    const double startLapse = free.lapse ? std::min(0.02, free.largestLapse) : lapse;
    const double startGuess = free.guess   ? std::min(0.02, free.largestGuess)
                              : free.equal ? startLapse
                                           : guess;
    const bool freeEnds = free.lapse || free.guess;
    SearchResult best = climb(sigmoid, levels, free, lineStart(sigmoid, levels, startLapse, startGuess),
                              {freeEnds ? kExploring : kExploring * 1e-8});
    best.step = bestStep(levels, free, lapse, guess);
    const double flat = flatLogLikelihood(levels, free, lapse, guess);
    exploreElsewhere(sigmoid, levels, free, best, flat);
    const double limit = std::max(flat, best.step.logLikelihood);
    if (limit < best.logLikelihood + 1e-3) { // otherwise a limit wins
        keepBetter(best, climb(sigmoid, levels, free, best.curve));
    }
    chooseKind(sigmoid, levels, best, flat);
    return best;
}

SearchResult searchThoroughly(Sigmoid sigmoid, const LevelsView& levels, const FreeParameters& free,
                              double lapse, double guess) noexcept {
    const SearchResult quick = searchMaximum(sigmoid, levels, free, lapse, guess);
    SearchResult best = quick;
    exploreWidely(sigmoid, levels, free, lapse, guess, best);
    climbToTheEnd(sigmoid, levels, free, best);
    if (!(best.logLikelihood > quick.logLikelihood + kGained)) {
        return quick;
    }
    chooseKind(sigmoid, levels, best, flatLogLikelihood(levels, free, lapse, guess));
    return best;
}

double likelihoodRatioOfStep(const PreparedLevels& levels, Sigmoid sigmoid, const FreeParameters& free,
                             double lapse, double guess) noexcept {
    const SearchResult likely = searchMaximum(sigmoid, viewOf(levels), free, lapse, guess);
    return std::max(0.0, 2.0 * (likely.logLikelihood - likely.step.logLikelihood));
}

} // namespace chiron::psychophysics
