// SPDX-License-Identifier: GPL-3.0-or-later
#include "psychophysics/fits/likelihood.h"

#include "psychophysics/fits/sigmoid_shapes.h"

#include <algorithm>
#include <cmath>

namespace chiron::psychophysics {
namespace {

constexpr double kTiny = 1e-300;

/// First and second derivatives of ψ with respect to (alpha, beta, lapse, guess) at one level.
struct PsiDerivatives {
    Vector4 first{};
    Matrix4 second{};
};

PsiDerivatives derivativesAt(const SigmoidValue& s, double unit, double reach, bool equal) noexcept {
    const double place = std::isfinite(unit) ? unit : 0.0; // at minus infinity S is flat
    PsiDerivatives d;
    const double byLapse = equal ? s.rest - s.rise : -s.rise;
    d.first = {reach * s.slope, reach * s.slope * place, byLapse, equal ? 0.0 : s.rest};
    d.second[0][0] = reach * s.bend;
    d.second[0][1] = d.second[1][0] = reach * s.bend * place;
    d.second[1][1] = reach * s.bend * place * place;
    const double mixed = equal ? -2.0 : -1.0;
    d.second[0][2] = d.second[2][0] = mixed * s.slope;
    d.second[1][2] = d.second[2][1] = mixed * s.slope * place;
    if (!equal) {
        d.second[0][3] = d.second[3][0] = -s.slope;
        d.second[1][3] = d.second[3][1] = -s.slope * place;
    }
    return d;
}

void addLevel(Information& information, const PsiDerivatives& d, double right, double of, double psi,
              double rest) noexcept {
    const double wrong = of - right;
    const double score = (right > 0.0 ? right / psi : 0.0) - (wrong > 0.0 ? wrong / rest : 0.0);
    const double curvature =
        (right > 0.0 ? right / (psi * psi) : 0.0) + (wrong > 0.0 ? wrong / (rest * rest) : 0.0);
    const double expected = of / (psi * rest);
    for (std::size_t i = 0; i < 4; ++i) {
        for (std::size_t j = 0; j < 4; ++j) {
            const double product = d.first[i] * d.first[j];
            information.observed[i][j] += curvature * product - score * d.second[i][j];
            information.expected[i][j] += expected * product;
        }
    }
}

} // namespace

FreeParameters freeParameters(const FitOptions& options) noexcept {
    FreeParameters free;
    free.lapse = options.lapse.rule != Asymptote::Rule::fixed;
    free.equal = options.guess.rule == Asymptote::Rule::equal || options.lapse.rule == Asymptote::Rule::equal;
    free.guess = options.guess.rule == Asymptote::Rule::free && !free.equal;
    if (free.equal) {
        free.lapse = true;
    }
    const double fixedGuess = free.guess || free.equal ? 0.0 : options.guess.value;
    const double fixedLapse = free.lapse ? 0.0 : options.lapse.value;
    constexpr double kLeastReach = 1e-3;
    const double asked = std::clamp(options.largestAsymptote, 0.0, 1.0);
    free.largestLapse = std::min(asked, (free.equal ? 0.5 : 1.0) * (1.0 - fixedGuess - kLeastReach));
    free.largestGuess = std::min(asked, 1.0 - fixedLapse - kLeastReach);
    if (free.lapse && free.guess) {
        free.largestLapse = std::min(free.largestLapse, 0.5 - kLeastReach);
        free.largestGuess = std::min(free.largestGuess, 0.5); // exactly 0.5: the guess rate of a task with
                                                              // two alternatives
    }
    return free;
}

FitOptions settled(FitOptions options) {
    if (options.guess.rule == Asymptote::Rule::equal && options.lapse.rule == Asymptote::Rule::fixed) {
        options.guess = options.lapse;
    } else if (options.lapse.rule == Asymptote::Rule::equal && options.guess.rule == Asymptote::Rule::fixed) {
        options.lapse = options.guess;
    }
    return options;
}

LevelsView viewOf(const PreparedLevels& levels) noexcept {
    return {levels.unit.data(), levels.right.data(), levels.of.data(), levels.size()};
}

double levelLogLikelihood(double right, double of, double psi, double rest) noexcept {
    return (right > 0.0 ? right * std::log(psi) : 0.0) + (of > right ? (of - right) * std::log(rest) : 0.0);
}

double logLikelihood(Sigmoid sigmoid, const LevelsView& levels, const UnitCurve& curve) noexcept {
    return shapes::withShape(sigmoid, [&]<class Shape>() noexcept {
        const double reach = 1.0 - curve.guess - curve.lapse;
        double sum = 0.0;
        for (std::size_t i = 0; i < levels.size; ++i) {
            const SigmoidValue s = Shape::at(curve.alpha + curve.beta * levels.unit[i]);
            sum += levelLogLikelihood(levels.right[i], levels.of[i], curve.guess + reach * s.rise,
                                      curve.lapse + reach * s.rest);
        }
        return sum;
    });
}

double saturatedLogLikelihood(const LevelsView& levels) noexcept {
    double sum = 0.0;
    for (std::size_t i = 0; i < levels.size; ++i) {
        const double share = levels.right[i] / levels.of[i];
        sum += levelLogLikelihood(levels.right[i], levels.of[i], share,
                                  (levels.of[i] - levels.right[i]) / levels.of[i]);
    }
    return sum;
}

double proportionOf(Sigmoid sigmoid, const UnitCurve& curve, double unit) noexcept {
    return curve.guess +
           (1.0 - curve.guess - curve.lapse) * sigmoidAt(sigmoid, curve.alpha + curve.beta * unit).rise;
}

Information informationAt(Sigmoid sigmoid, const LevelsView& levels, const UnitCurve& curve,
                          bool equal) noexcept {
    Information information;
    const double reach = 1.0 - curve.guess - curve.lapse;
    for (std::size_t i = 0; i < levels.size; ++i) {
        const SigmoidValue s = sigmoidAt(sigmoid, curve.alpha + curve.beta * levels.unit[i]);
        const double psi = std::max(curve.guess + reach * s.rise, kTiny);
        const double rest = std::max(curve.lapse + reach * s.rest, kTiny);
        addLevel(information, derivativesAt(s, levels.unit[i], reach, equal), levels.right[i], levels.of[i],
                 psi, rest);
    }
    return information;
}

bool invertPositive(const Matrix4& matrix, const std::array<bool, 4>& used, Matrix4& inverse) noexcept {
    Matrix4 left{};
    inverse = {};
    for (std::size_t i = 0; i < 4; ++i) {
        for (std::size_t j = 0; j < 4; ++j) {
            left[i][j] = used[i] && used[j] ? matrix[i][j] : (i == j ? 1.0 : 0.0);
            inverse[i][j] = i == j ? 1.0 : 0.0;
        }
    }
    for (std::size_t pivot = 0; pivot < 4;
         ++pivot) { // Gauss–Jordan in place; pivots of a positive definite matrix are positive
        const double at = left[pivot][pivot];
        const double scale = used[pivot] ? std::abs(matrix[pivot][pivot]) : 1.0;
        if (!(at > 1e-13 * scale) || !std::isfinite(at)) {
            return false;
        }
        for (std::size_t j = 0; j < 4; ++j) {
            left[pivot][j] /= at;
            inverse[pivot][j] /= at;
        }
        for (std::size_t i = 0; i < 4; ++i) {
            const double factor = i == pivot ? 0.0 : left[i][pivot];
            for (std::size_t j = 0; j < 4; ++j) {
                left[i][j] -= factor * left[pivot][j];
                inverse[i][j] -= factor * inverse[pivot][j];
            }
        }
    }
    for (std::size_t i = 0; i < 4; ++i) {
        inverse[i][i] = used[i] ? inverse[i][i] : 0.0;
    }
    return true;
}

UnitCurve toUnit(const CurveParameters& at, const PreparedLevels& levels, Sigmoid sigmoid) noexcept {
    const SigmoidUnits units = unitsOf(sigmoid);
    const double beta = units.spread * levels.range / at.width;
    return {units.middle - beta * (at.threshold - levels.centre) / levels.range, beta, at.lapse, at.guess};
}

CurveParameters fromUnit(const UnitCurve& curve, const PreparedLevels& levels, Sigmoid sigmoid) noexcept {
    const SigmoidUnits units = unitsOf(sigmoid);
    return {levels.centre + levels.range * (units.middle - curve.alpha) / curve.beta,
            units.spread * levels.range / curve.beta, curve.lapse, curve.guess, 0.0};
}

} // namespace chiron::psychophysics
