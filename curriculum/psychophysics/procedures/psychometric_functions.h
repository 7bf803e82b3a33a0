// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>
#include <vector>

namespace chiron::psychophysics {

/// A psychometric function as grids use it: ψ = a + b F(x; shape), where F runs from 0 to 1 and asymptotes follow from guess and lapse.
struct PsychometricFunction {
    std::string_view name;
    std::string_view formula;                ///< of F, for documentation
    std::vector<std::string_view> stimuli;   ///< names of its stimulus dimensions
    std::vector<std::string_view> shape;     ///< names of the parameters of F, in order
    /// guessLapse: then come lower_asymptote and lapse_rate, ψ = γ + (1-γ-λ)F. symmetricLapse: then lapse_rate, ψ = λ + (1-2λ)F.
    enum class Asymptotes { guessLapse, symmetricLapse } asymptotes = Asymptotes::guessLapse;
    double (*f)(const double* x, const double* shape) = nullptr;
    bool positiveStimulus = false;           ///< F is defined for x > 0 and threshold > 0 only

    std::vector<std::string_view> parameters() const; ///< all, in order
    double base(const double* asymptotes) const noexcept; ///< a, of the parameters after the shape's
    double scale(const double* asymptotes) const noexcept; ///< b
};

/// All that QUEST+ knows: weibull_db, weibull_log10, weibull, norm_cdf, norm_cdf_2, logistic, gumbel, reverse_gumbel,
/// hyperbolic_secant, csf.
const std::vector<PsychometricFunction>& psychometricFunctions();
const PsychometricFunction* psychometricFunction(std::string_view name);

} // namespace chiron::psychophysics
