// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/fits/sigmoid.h"

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace chiron::psychophysics {

inline constexpr double kNotKnown = std::numeric_limits<double>::quiet_NaN();

/// At x[i], k[i] of n[i] answers were right (yes). Rows may repeat an x, in any order; n = 1 a row is a list of trials.
/// Rows that cannot be used (missing, infinite, negative, k > n) are left out with a warning.
struct PsychometricData {
    std::vector<double> x;
    std::vector<double> k;
    std::vector<double> n;
};

/// How one end of the curve is treated. `equal` (guess only): the same as the lapse.
struct Asymptote {
    enum class Rule : std::uint8_t { fixed, free, equal } rule = Rule::fixed;
    double value = 0.0; ///< where fixed
    static constexpr Asymptote fixedAt(double value) noexcept { return {Rule::fixed, value}; }
    static constexpr Asymptote fitted() noexcept { return {Rule::free, 0.0}; }
    static constexpr Asymptote equalToLapse() noexcept { return {Rule::equal, 0.0}; }
};

enum class FitMethod : std::uint8_t { maximumLikelihood, bayesian };
/// Bootstrap of a maximum-likelihood fit: from the fitted curve, or from each level's own answers.
enum class Bootstrap : std::uint8_t { none, parametric, nonparametric };
/// What a Bayesian fit expects of the width before it has seen an answer. psignifit: nothing below the smallest spacing of the levels, little
/// below twice that and beyond their range, nothing beyond three ranges. openBelow: all alike down to a hundredth of the spacing (a step).
/// openAbove: all alike up to three ranges, falling to nothing at nine. wide: both. automatic: psignifit's; intervals with each end open at which
/// psignifit's prior and not the answers would decide.
enum class WidthPrior : std::uint8_t { automatic, psignifit, openBelow, openAbove, wide };
std::string_view widthPriorToken(WidthPrior prior) noexcept; ///< automatic: auto
std::optional<WidthPrior> widthPriorFromToken(std::string_view token) noexcept;
enum class CredibleMethod : std::uint8_t { percentile, projection }; ///< of the marginals; of the joint region of highest density

struct FitOptions {
    Sigmoid function = Sigmoid::gauss;
    Asymptote guess = Asymptote::fixedAt(0.5);
    Asymptote lapse = Asymptote::fitted();
    std::optional<StimulusScale> scale; ///< none: the function's own
    double confidence = 0.95;
    double largestAsymptote = 0.5;      ///< of a free lapse or guess
    bool profileIntervals = true;       ///< maximum likelihood without a bootstrap: intervals from the profile of the likelihood
    int monteCarlo = 0;                 ///< simulated data sets for the goodness of fit; 0: p from chi-square only
    Bootstrap bootstrap = Bootstrap::none; ///< maximum likelihood only
    int bootstrapSamples = 2000;
    std::uint64_t seed = 1;
    // Bayesian only
    bool overdispersion = true;         ///< false: η is 0, answers are binomial
    WidthPrior widthPrior = WidthPrior::automatic;
    double betaPrior = 10.0;            ///< lapse, guess and η ~ Beta(1, this)
    std::optional<double> lowest, highest; ///< stimulus range of the priors, given units; none: the data's
    CredibleMethod credible = CredibleMethod::percentile;
    int draws = 0;                      ///< parameter sets drawn from the posterior (for intervals of anything derived); the band needs 1000
    int curvePoints = 0;                ///< > 1: the fitted curve and its band at so many x
};

struct FitInterval {
    double low = kNotKnown;
    double high = kNotKnown;
};

/// Threshold and width on the fitted axis (FitResult::scale).
struct CurveParameters {
    double threshold = kNotKnown;
    double width = kNotKnown;
    double lapse = kNotKnown;
    double guess = kNotKnown;
    double eta = 0.0; ///< overdispersion, 0 in maximum likelihood
};

struct ParameterIntervals {
    FitInterval threshold, width, lapse, guess, eta;
};

/// One level after equal x were put together.
struct FittedLevel {
    double x = 0.0; ///< given units
    double right = 0.0;
    double of = 0.0;
    double fitted = kNotKnown;   ///< ψ
    double residual = kNotKnown; ///< sign(y − ψ) √d, d its share of the deviance
};

struct CurveSample {
    double x = 0.0; ///< given units
    double fitted = kNotKnown;
    double low = kNotKnown;
    double high = kNotKnown;
};

/// What a fit says. What the data do not carry is not a number, and `warnings` say why: "token: words".
struct FitResult {
    bool fitted = false;
    FitMethod method = FitMethod::maximumLikelihood;
    Sigmoid function = Sigmoid::gauss;
    StimulusScale scale = StimulusScale::linear;
    double threshold = kNotKnown; ///< x at which the unscaled curve is 0.5, given units (maximum likelihood, or posterior mode)
    double width = kNotKnown;     ///< 5 to 95 % of the unscaled curve, on the fitted axis
    double lapse = kNotKnown;
    double guess = kNotKnown;
    double eta = 0.0;
    CurveParameters best;         ///< the same five, threshold on the fitted axis
    CurveParameters mean;         ///< posterior mean; Bayesian only
    CurveParameters error;        ///< standard errors (observed information; posterior sd); fitted axis
    CurveParameters expectedError;///< standard errors from expected information, as Fisher scoring (glm) gives; maximum likelihood only
    double thresholdWidthCovariance = kNotKnown; ///< of the observed information
    ParameterIntervals ci;        ///< threshold in given units
    WidthPrior intervalPrior = WidthPrior::psignifit; ///< of `ci`, `draws` and the band, never automatic; Bayesian only
    /// How much the prior decided: the posterior's standard deviation over the prior's (of the width: of its logarithm). Near 0 the answers
    /// decide, near 1 the prior. Not numbers where a parameter is fixed, and in maximum likelihood, which has no prior.
    CurveParameters priorInfluence{kNotKnown, kNotKnown, kNotKnown, kNotKnown, kNotKnown};
    double confidence = 0.95;
    double deviance = kNotKnown;
    double pValue = kNotKnown;    ///< of the deviance: Monte Carlo where asked for, else chi-square
    double chiSquareP = kNotKnown;
    int freeParameters = 0;
    int degreesOfFreedom = 0;
    double logLikelihood = kNotKnown; ///< binomial at `best`, with the coefficients of the rows as given
    double logPosterior = kNotKnown;  ///< at the mode, up to a constant; Bayesian only
    double aic = kNotKnown;
    std::vector<FittedLevel> levels;
    std::vector<CurveSample> curve;
    std::vector<CurveParameters> draws; ///< bootstrap fits or posterior draws, fitted axis
    std::vector<std::string> warnings;
};

} // namespace chiron::psychophysics
