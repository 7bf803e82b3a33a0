// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

namespace chiron::psychophysics {

/// A discrimination task with the decision rule that turns d′ into a proportion correct (unbiased observer, equal variances).
enum class Discrimination : std::uint8_t {
    mAfc,                     ///< which of m is the strongest (Green & Dai 1991); m = 2: 2AFC
    oddityDifferencing,       ///< triangle: the one farthest from the others (Ennis 1990): 0.418 at d′ = 1
    oddityIndependent,        ///< triangle: likeliest of the six arrangements (Versfeld, Dai & Green 1996): 0.447 at d′ = 1
    sameDifferentIndependent, ///< each classed by itself, then compared (Macmillan & Creelman 2005, ch. 9)
    abxDifferencing,          ///< X compared with A and B (Macmillan & Creelman 2005, eq. 9.11); duo–trio has the same function
    abxIndependent,           ///< A, B as 2AFC, X classed by itself (the same, eq. 9.9)
    tetrad,                   ///< two groups of two (Ennis & Christensen 2014)
};

struct DiscriminationTask {
    Discrimination rule = Discrimination::mAfc;
    int alternatives = 2; ///< mAfc only, 2..1000
};

double chanceOf(const DiscriminationTask& task) noexcept; ///< proportion correct at d′ = 0
/// Proportion correct at d′ (units of the noise of one observation). mAfc: any sign; the others by |d′|. Not a number for not a number.
double proportionCorrect(const DiscriminationTask& task, double dPrime) noexcept;
/// d′ at a proportion correct, by bisection to 1e-12: 0 at chance or below (mAfc: negative below), +∞ at 1; not a number outside [0, 1].
double dPrimeAt(const DiscriminationTask& task, double proportion) noexcept;
double slopeOf(const DiscriminationTask& task, double dPrime) noexcept; ///< d(proportion correct)/d(d′)

/// rankProbabilities (observers/thurstone.h) from a table by cubic interpolation; within 1e-7 for |d| ≤ 12, the limit beyond.
std::array<double, 6> tabulatedOrderProbabilities(double d) noexcept;

} // namespace chiron::psychophysics
