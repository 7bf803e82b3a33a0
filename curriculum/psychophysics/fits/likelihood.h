// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/fits/prepared_levels.h"

#include <algorithm>
#include <array>
#include <vector>

namespace chiron::psychophysics {

/// A curve in the coordinates of the search: z = alpha + beta · unit, ψ = guess + (1 − guess − lapse) S(z).
struct UnitCurve {
    double alpha = 0.0;
    double beta = 1.0;
    double lapse = 0.0;
    double guess = 0.0;
};

/// Says which of alpha, beta, lapse and guess are searched. With `equal` the guess equals the lapse.
struct FreeParameters {
    bool alpha = true;
    bool beta = true;
    bool lapse = false;
    bool guess = false;
    bool equal = false;
    double largestLapse = 0.5;
    double largestGuess = 0.5;
    /// Returns where the search for an asymptote starts: off 0, where the likelihood's slope says nothing,
    /// but never above the largest value, which may be smaller than that.
    static double startOfAsymptote(double value, double largest) noexcept {
        return std::min(std::max(value, 0.005), largest);
    }
    int count() const noexcept {
        return static_cast<int>(alpha) + static_cast<int>(beta) + static_cast<int>(lapse) +
               static_cast<int>(guess);
    }
    /// Returns how many of those that are searched may lie at a bound: lapse and guess, at 0.
    int bounded() const noexcept { return static_cast<int>(lapse) + static_cast<int>(guess); }
};
FreeParameters freeParameters(const FitOptions& options) noexcept;
/// Returns the options with both asymptotes fixed if one is fixed and the other has to equal it.
FitOptions settled(FitOptions options);

using Vector4 = std::array<double, 4>;
using Matrix4 = std::array<Vector4, 4>;

/// The positions and counts over which a likelihood sums. `unit` may be shifted.
struct LevelsView {
    const double* unit = nullptr;
    const double* right = nullptr;
    const double* of = nullptr;
    std::size_t size = 0;
};
LevelsView viewOf(const PreparedLevels& levels) noexcept;

/// Returns k ln ψ + (n − k) ln(1 − ψ), with 0 · ln 0 = 0.
double levelLogLikelihood(double right, double of, double psi, double rest) noexcept;
/// Returns the binomial log-likelihood without coefficients.
double logLikelihood(Sigmoid sigmoid, const LevelsView& levels, const UnitCurve& curve) noexcept;
double saturatedLogLikelihood(const LevelsView& levels) noexcept;
double proportionOf(Sigmoid sigmoid, const UnitCurve& curve, double unit) noexcept;

/// Negative second derivatives of the log-likelihood with respect to (alpha, beta, lapse, guess): observed
/// and expected (Fisher).
struct Information {
    Matrix4 observed{};
    Matrix4 expected{};
};
Information informationAt(Sigmoid sigmoid, const LevelsView& levels, const UnitCurve& curve,
                          bool equal) noexcept;

/// Inverts a symmetric matrix over the rows marked in `used`; the result is zero elsewhere. Returns false if
/// the matrix is not positive definite.
bool invertPositive(const Matrix4& matrix, const std::array<bool, 4>& used, Matrix4& inverse) noexcept;

UnitCurve toUnit(const CurveParameters& at, const PreparedLevels& levels, Sigmoid sigmoid) noexcept;
CurveParameters fromUnit(const UnitCurve& curve, const PreparedLevels& levels, Sigmoid sigmoid) noexcept;

} // namespace chiron::psychophysics
