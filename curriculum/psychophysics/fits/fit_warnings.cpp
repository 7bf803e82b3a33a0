// SPDX-License-Identifier: GPL-3.0-or-later
#include "psychophysics/fits/chi_square.h"
#include "psychophysics/fits/fit_summary.h"
#include "psychophysics/fits/likelihood_search.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace chiron::psychophysics {
namespace {

std::string percent(double share) {
    return std::to_string(static_cast<int>(std::lround(100.0 * share))) + " %";
}

void warnOfOneSidedAnswers(FitResult& result, const PreparedLevels& levels) {
    if (levels.totalRight == levels.total) {
        result.warnings.push_back("all_right: every answer was right, so the threshold lies below what was "
                                  "presented and is not known");
    } else if (levels.totalRight == 0.0) {
        result.warnings.push_back("all_wrong: every answer was wrong, so the threshold lies above what was "
                                  "presented and is not known");
    }
}

void warnOfBounds(FitResult& result, const FitOptions& options) {
    const FreeParameters free = freeParameters(options);
    const bool posterior = result.method == FitMethod::bayesian;
    const auto near = [](double value, double bound) { return std::abs(value - bound) < 1e-6; };
    if (free.lapse && near(result.lapse, free.largestLapse)) {
        result.warnings.push_back("lapse_at_bound: the share of lapses is the largest allowed (" +
                                  percent(free.largestLapse) +
                                  "); the participant may not have done the task");
    } else if (free.lapse && !posterior && near(result.lapse, 0.0)) {
        result.warnings.push_back(
            "lapse_at_bound: the share of lapses is 0, the smallest possible; its interval is one-sided");
    }
    if (free.guess && near(result.guess, free.largestGuess)) {
        result.warnings.push_back("guess_at_bound: the share of guesses is the largest allowed (" +
                                  percent(free.largestGuess) + ")");
    }
}

/// Warns of a threshold outside the levels, and of too few trials whose expected proportion lies between 10
/// and 90 % of the way from guess to 1 − lapse.
void warnOfThreshold(FitResult& result, const PreparedLevels& levels) {
    const double low = levels.centre - 0.5 * levels.range, high = levels.centre + 0.5 * levels.range;
    const double threshold = result.best.threshold;
    if (!(threshold >= low && threshold <= high)) {
        result.warnings.push_back("threshold_outside: the threshold lies outside the intensities presented; "
                                  "it is a guess beyond the data");
    }
    const double reach = 1.0 - result.guess - result.lapse;
    double near = 0.0;
    for (const FittedLevel& level : result.levels) {
        const double rise = (level.fitted - result.guess) / reach;
        near += rise > 0.1 && rise < 0.9 ? level.of : 0.0;
    }
    constexpr double kFewTrials = 15.0;
    if (near < kFewTrials) {
        result.warnings.push_back(
            "few_trials_near_threshold: only " + std::to_string(static_cast<long long>(near)) +
            " trials were where the curve rises (10 to 90 %); threshold and width are uncertain");
    }
}

/// Returns whether a step explains the answers as well as any curve, within chance: whether the profile
/// interval of the width at 95 % begins at 0 (profile_interval.h). A step has one parameter less than a
/// curve, the width, and lapse and guess may be searched in both, so the quantile is that of one parameter
/// (chi_square.h). Like those of the other warnings, the level does not depend on the confidence of the
/// intervals.
bool mayBeStep(const FitResult& result, const PreparedLevels& levels, const FitOptions& options) {
    constexpr double kWithinChance = 0.95;
    const FreeParameters free = freeParameters(options);
    const double lapse = free.lapse ? 0.0 : options.lapse.value,
                 guess = free.guess || free.equal ? 0.0 : options.guess.value;
    return likelihoodRatioOfStep(levels, result.function, free, lapse, guess) <
           chiBarSquareQuantile(kWithinChance, free.bounded());
}

void warnOfWidth(FitResult& result, const PreparedLevels& levels, const FitOptions& options) {
    if (result.best.width < 0.5 * levels.spacing || result.ci.width.low == 0.0 ||
        mayBeStep(result, levels, options)) {
        result.warnings.push_back("step_function: answers may jump from guessing to right between two "
                                  "neighbouring intensities, or at one; "
                                  "the width is only known to be small (present intensities in between)");
    } else if (result.best.width > 3.0 * levels.range) {
        result.warnings.push_back("wide: the curve rises over more than three times the range presented; the "
                                  "width is hardly known");
    }
}

/// Warns of close levels. The priors of a posterior reach down to widths of the smallest spacing, and beyond
/// this ratio the posterior is integrated coarsely.
void warnOfSpacing(FitResult& result, const PreparedLevels& levels) {
    constexpr double kMostSpacings = 1000.0;
    if (result.method == FitMethod::bayesian && levels.range > kMostSpacings * levels.spacing) {
        result.warnings.push_back("uneven_levels: two intensities lie closer together than a thousandth of "
                                  "the range presented, so the ends of the "
                                  "intervals may be off by a twentieth of their length; intensities over "
                                  "decades belong on a logarithmic axis");
    }
}

/// Warns of a fall that chance hardly explains: the proportion at higher intensities is below that at lower
/// ones by more than 2.58 standard errors (p = 0.01).
void warnOfFall(FitResult& result, const PreparedLevels& levels) {
    double rightBelow = 0.0, below = 0.0;
    for (std::size_t i = 0; i + 1 < levels.size(); ++i) {
        rightBelow += levels.right[i];
        below += levels.of[i];
        const double above = levels.total - below, rightAbove = levels.totalRight - rightBelow;
        const double pooled = levels.totalRight / levels.total;
        const double error = std::sqrt(pooled * (1.0 - pooled) * (1.0 / below + 1.0 / above));
        if (error > 0.0 && rightBelow / below - rightAbove / above > 2.58 * error) {
            result.warnings.push_back("not_monotone: answers get worse as the intensity grows; check that "
                                      "intensity and answers belong together");
            return;
        }
    }
}

void warnOfScatter(FitResult& result, const FitOptions& options) {
    constexpr double kUnlikely = 0.01;
    if (result.pValue < kUnlikely) {
        const bool allowedFor = result.method == FitMethod::bayesian && options.overdispersion;
        result.warnings.push_back(
            std::string("overdispersion: answers scatter more around the curve than chance allows (p < "
                        "0.01); the participant "
                        "changed during the run, or another curve is needed; ") +
            (allowedFor ? "the intervals allow for the scatter" : "use the Bayesian interval"));
    } else if (result.method == FitMethod::bayesian && result.mean.eta > 0.25) {
        result.warnings.push_back(
            "overdispersion: answers scatter much more around the curve than chance allows");
    }
}

} // namespace

void addWarnings(FitResult& result, const PreparedLevels& levels, const FitOptions& options) {
    warnOfOneSidedAnswers(result, levels);
    warnOfFall(result, levels);
    if (!result.fitted) {
        return;
    }
    warnOfBounds(result, options);
    warnOfWidth(result, levels, options);
    warnOfThreshold(result, levels);
    warnOfScatter(result, options);
    warnOfSpacing(result, levels);
}

} // namespace chiron::psychophysics
