// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

namespace chiron::psychophysics {

/// A discrimination task together with the decision rule that turns d′ into a proportion correct (unbiased
/// observer, equal variances).
enum class Discrimination : std::uint8_t {
    mAfc,               ///< which of m is the strongest (Green & Dai 1991); m = 2: 2AFC
    oddityDifferencing, ///< triangle: the one farthest from the others (Ennis 1990); 0.418 at d′ = 1
    /// Triangle: the most likely of the six arrangements (Versfeld, Dai & Green 1996); 0.447 at d′ = 1.
    oddityIndependent,
    /// Each is classified by itself, then the two are compared (Macmillan & Creelman 2005, ch. 9).
    sameDifferentIndependent,
    /// X is compared with A and B (Macmillan & Creelman 2005, eq. 9.11); duo–trio has the same function.
    abxDifferencing,
    abxIndependent, ///< A, B as 2AFC, X classified by itself (the same, eq. 9.9)
    tetrad,         ///< sorting into two groups of two (Ennis & Christensen 2014)
};

struct DiscriminationTask {
    Discrimination rule = Discrimination::mAfc;
    int alternatives = 2; ///< mAfc only, 2..1000
};

double chanceOf(const DiscriminationTask& task) noexcept; ///< proportion correct at d′ = 0
/// Returns the proportion correct at d′ (in units of the noise of one observation). mAfc accepts any sign;
/// the others use |d′|. Not a number if d′ is not a number.
double proportionCorrect(const DiscriminationTask& task, double dPrime) noexcept;
/// Returns d′ at a proportion correct, by bisection to 1e-12: 0 at chance or below (mAfc: negative below), +∞
/// at 1; not a number outside [0, 1].
double dPrimeAt(const DiscriminationTask& task, double proportion) noexcept;
double slopeOf(const DiscriminationTask& task, double dPrime) noexcept; ///< d(proportion correct)/d(d′)

/// Returns rankProbabilities (observers/thurstone.h) from a table by cubic interpolation; within 1e-7 for |d|
/// ≤ 12, and the limit beyond.
std::array<double, 6> tabulatedOrderProbabilities(double d) noexcept;

} // namespace chiron::psychophysics
