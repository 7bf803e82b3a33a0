// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace chiron::psychophysics {

/// The family of a psychometric function. On a logarithmic axis (StimulusScale) the Gumbel is the Weibull and
/// the Gauss the log-normal.
enum class Sigmoid : std::uint8_t { logistic, gauss, weibull, gumbel, rgumbel, logn, hyperbolic, tdist };
inline constexpr int kSigmoids = 8;
std::string_view token(Sigmoid sigmoid) noexcept; ///< "logistic", "gauss", ...: as in files and commands
std::optional<Sigmoid> sigmoidFromToken(std::string_view word) noexcept;

/// The axis on which a sigmoid is fitted: x itself, ln x, log10 x, or 20 log10 x.
enum class StimulusScale : std::uint8_t { linear, ln, log10, db };
inline constexpr int kStimulusScales = 4;
std::string_view token(StimulusScale scale) noexcept; ///< "linear", "ln", "log10", "db"
std::optional<StimulusScale> stimulusScaleFromToken(std::string_view word) noexcept;
/// Returns ln for Weibull and log-normal, else linear.
StimulusScale ownScale(Sigmoid sigmoid) noexcept;
/// Converts from given units to the fitted axis. On a logarithmic axis 0 becomes minus infinity, and a
/// negative x is not a number.
double toScale(double x, StimulusScale scale) noexcept;
double fromScale(double value, StimulusScale scale) noexcept;

/// The unscaled sigmoid in its standard form at z: S, 1 − S (kept separately, so that neither loses digits),
/// S′ and S″.
struct SigmoidValue {
    double rise = 0.0;
    double rest = 1.0;
    double slope = 0.0;
    double bend = 0.0;
};
/// Standard forms: logistic 1/(1+e^−z); Gauss Φ(z); Gumbel (Weibull) 1−exp(−e^z); reversed Gumbel exp(−e^−z);
/// hyperbolic secant (2/π)atan(e^(πz/2)); t with one degree of freedom (Cauchy) 1/2+atan(z)/π. z may be
/// infinite.
SigmoidValue sigmoidAt(Sigmoid sigmoid, double z) noexcept;
/// Z at which S equals the proportion, 0 < proportion < 1.
double sigmoidInverse(Sigmoid sigmoid, double proportion) noexcept;

/// Converts threshold and width to z = middle + spread (x − m)/w. At the threshold m, S = 0.5; the width w
/// reaches from S = 0.05 to S = 0.95 (Schütt et al. 2016).
struct SigmoidUnits {
    double middle = 0.0; ///< z at S = 0.5
    double spread = 0.0; ///< z(0.95) − z(0.05)
};
SigmoidUnits unitsOf(Sigmoid sigmoid) noexcept;

} // namespace chiron::psychophysics
