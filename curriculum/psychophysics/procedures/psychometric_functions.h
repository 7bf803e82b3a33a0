// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>
#include <vector>

namespace chiron::psychophysics {

/// A psychometric function as grids use it: ψ = a + b F(x; shape), where F runs from 0 to 1 and the
/// asymptotes follow from guess and lapse rates.
struct PsychometricFunction {
    std::string_view name;
    std::string_view formula;              ///< of F, for documentation
    std::vector<std::string_view> stimuli; ///< names of its stimulus dimensions
    std::vector<std::string_view> shape;   ///< names of the parameters of F, in order
    /// The parameters after those of the shape. guessLapse: lower_asymptote and lapse_rate, ψ = γ + (1-γ-λ)F.
    /// symmetricLapse: lapse_rate only, ψ = λ + (1-2λ)F.
    enum class Asymptotes { guessLapse, symmetricLapse } asymptotes = Asymptotes::guessLapse;
    double (*f)(const double* x, const double* shape) = nullptr;
    bool positiveStimulus = false; ///< F is defined only for x > 0 and threshold > 0

    std::vector<std::string_view> parameters() const;     ///< all, in order
    double base(const double* asymptotes) const noexcept; ///< a, from the parameters after those of the shape
    double scale(const double* asymptotes) const noexcept; ///< b
};

/// Returns all functions that QUEST+ supports: weibull_db, weibull_log10, weibull, norm_cdf, norm_cdf_2,
/// logistic, gumbel, reverse_gumbel, hyperbolic_secant, csf.
const std::vector<PsychometricFunction>& psychometricFunctions();
const PsychometricFunction* psychometricFunction(std::string_view name);

} // namespace chiron::psychophysics
