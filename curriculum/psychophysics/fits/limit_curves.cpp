// SPDX-License-Identifier: GPL-3.0-or-later
#include "psychophysics/fits/limit_curves.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace chiron::psychophysics {
namespace {

struct Counts {
    double right = 0.0;
    double of = 0.0;
    double wrong() const noexcept { return of - right; }
};

double cappedShare(double part, double whole, double most) noexcept {
    return whole > 0.0 ? std::clamp(part / whole, 0.0, most) : 0.0;
}

/// Chooses the most likely lapse and guess for the answers below and above a step.
void chooseEnds(StepCurve& step, const Counts& below, const Counts& above,
                const FreeParameters& free) noexcept {
    if (free.equal) {
        step.lapse = cappedShare(below.right + above.wrong(), below.of + above.of, free.largestLapse);
        step.guess = step.lapse;
        return;
    }
    if (free.lapse) {
        step.lapse = cappedShare(above.wrong(), above.of, free.largestLapse);
    }
    if (free.guess) {
        step.guess = cappedShare(below.right, below.of, free.largestGuess);
    }
}

void weigh(StepCurve& step, const Counts& below, const Counts& above, const Counts& at) noexcept {
    step.logLikelihood = levelLogLikelihood(below.right, below.of, step.guess, 1.0 - step.guess) +
                         levelLogLikelihood(above.right, above.of, 1.0 - step.lapse, step.lapse);
    if (step.atLevel) {
        step.share = std::clamp(at.right / at.of, step.guess, 1.0 - step.lapse);
        step.logLikelihood += levelLogLikelihood(at.right, at.of, step.share, 1.0 - step.share);
    }
}

double saturation(Sigmoid sigmoid) noexcept {
    return sigmoid == Sigmoid::tdist ? 1e9 : 40.0;
}

double closestGap(const LevelsView& levels, std::size_t level) noexcept {
    double gap = std::numeric_limits<double>::infinity();
    if (level > 0 && std::isfinite(levels.unit[level - 1])) {
        gap = levels.unit[level] - levels.unit[level - 1];
    }
    if (level + 1 < levels.size) {
        gap = std::min(gap, levels.unit[level + 1] - levels.unit[level]);
    }
    return std::isfinite(gap) ? gap : 1.0;
}

} // namespace

StepCurve bestStep(const LevelsView& levels, const FreeParameters& free, double lapse,
                   double guess) noexcept {
    Counts all;
    for (std::size_t i = 0; i < levels.size; ++i) {
        all.right += levels.right[i];
        all.of += levels.of[i];
    }
    StepCurve best;
    best.logLikelihood = -std::numeric_limits<double>::infinity();
    Counts below;
    for (std::size_t i = 0; i < levels.size; ++i) {
        const Counts at{levels.right[i], levels.of[i]};
        for (const bool atLevel : {false, true}) {
            const bool belowNothing = !std::isfinite(levels.unit[i]) || (i == 0 && !atLevel);
            if (belowNothing) {
                continue; // a step below the first level has no effect
            }
            const Counts kept = atLevel ? at : Counts{};
            const Counts above{all.right - below.right - kept.right, all.of - below.of - kept.of};
            StepCurve step{i, atLevel, 0.0, lapse, guess, 0.0};
            chooseEnds(step, below, above, free);
            weigh(step, below, above, at);
            const double alike =
                std::isfinite(best.logLikelihood) ? 1e-9 * std::max(1.0, std::abs(best.logLikelihood)) : 0.0;
            // Of two equally likely steps, the one between levels is preferred: halfway, so that mirrored
            // data give the mirrored step.
            const bool freer = best.atLevel && !step.atLevel;
            if (step.logLikelihood > best.logLikelihood + alike ||
                (freer && step.logLikelihood > best.logLikelihood - alike)) {
                best = step;
            }
        }
        below.right += at.right;
        below.of += at.of;
    }
    return best;
}

double flatLogLikelihood(const LevelsView& levels, const FreeParameters& free, double lapse,
                         double guess) noexcept {
    Counts all;
    for (std::size_t i = 0; i < levels.size; ++i) {
        all.right += levels.right[i];
        all.of += levels.of[i];
    }
    const double low = free.guess || free.equal ? 0.0 : guess;
    const double high = free.lapse ? 1.0 : 1.0 - lapse;
    const double level = std::clamp(all.right / all.of, low, high);
    return levelLogLikelihood(all.right, all.of, level, 1.0 - level);
}

UnitCurve curveOf(const StepCurve& step, const LevelsView& levels, Sigmoid sigmoid) noexcept {
    UnitCurve curve{0.0, 1.0, step.lapse, step.guess};
    const double reach = 1.0 - step.lapse - step.guess;
    const double at = levels.unit[step.level];
    const double far = saturation(sigmoid);
    if (step.atLevel) {
        const double s = std::clamp((step.share - step.guess) / reach, 1e-12, 1.0 - 1e-12);
        const double z = sigmoidInverse(sigmoid, s);
        curve.beta = (far + std::abs(z)) / closestGap(levels, step.level);
        curve.alpha = z - curve.beta * at;
        return curve;
    }
    const double before = levels.unit[step.level - 1];
    const double gap = std::isfinite(before) ? at - before : closestGap(levels, step.level);
    curve.beta = 2.0 * far / gap;
    curve.alpha = unitsOf(sigmoid).middle - curve.beta * (at - 0.5 * gap);
    return curve;
}

} // namespace chiron::psychophysics
