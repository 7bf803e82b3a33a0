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

/// Answers to fit: at x[i], k[i] of n[i] answers were right (or yes). Rows may repeat an x, in any order;
/// with n = 1 per row they are a list of trials. Unusable rows (missing, infinite, negative, k > n) are left
/// out with a warning.
struct PsychometricData {
    std::vector<double> x;
    std::vector<double> k;
    std::vector<double> n;
};

/// How one asymptote of the curve is treated. `equal` (guess only): the guess rate equals the lapse rate.
struct Asymptote {
    enum class Rule : std::uint8_t { fixed, free, equal } rule = Rule::fixed;
    double value = 0.0; ///< if fixed
    static constexpr Asymptote fixedAt(double value) noexcept { return {Rule::fixed, value}; }
    static constexpr Asymptote fitted() noexcept { return {Rule::free, 0.0}; }
    static constexpr Asymptote equalToLapse() noexcept { return {Rule::equal, 0.0}; }
};

enum class FitMethod : std::uint8_t { maximumLikelihood, bayesian };
/// Bootstrap of a maximum-likelihood fit: answers are drawn from the fitted curve (parametric) or from each
/// level's own answers (nonparametric).
enum class Bootstrap : std::uint8_t { none, parametric, nonparametric };
/// Prior of the width in a Bayesian fit. psignifit: zero below the smallest spacing of the levels, reduced
/// below twice that and beyond their range, zero beyond three ranges. openBelow: flat down to a hundredth of
/// the spacing (a step). openAbove: flat up to three ranges, falling to zero at nine. wide: both. automatic:
/// psignifit's prior for the estimates; for the intervals, each end is opened at which psignifit's prior, and
/// not the answers, would determine the interval.
enum class WidthPrior : std::uint8_t { automatic, psignifit, openBelow, openAbove, wide };
std::string_view widthPriorToken(WidthPrior prior) noexcept; ///< the token of automatic is "auto"
std::optional<WidthPrior> widthPriorFromToken(std::string_view token) noexcept;
/// percentile: of the marginals; projection: of the joint region of highest density.
enum class CredibleMethod : std::uint8_t { percentile, projection };

struct FitOptions {
    Sigmoid function = Sigmoid::gauss;
    Asymptote guess = Asymptote::fixedAt(0.5);
    Asymptote lapse = Asymptote::fitted();
    std::optional<StimulusScale> scale; ///< none: the function's own scale
    double confidence = 0.95;
    double largestAsymptote = 0.5; ///< largest value of a free lapse or guess
    bool profileIntervals = true;  ///< for maximum likelihood without a bootstrap: take the intervals
                                   ///< from the profile likelihood
    int monteCarlo = 0;            ///< number of simulated data sets for the goodness of fit; 0: p from
                                   ///< chi-square only
    Bootstrap bootstrap = Bootstrap::none; ///< maximum likelihood only
    int bootstrapSamples = 2000;
    std::uint64_t seed = 1;
    // Bayesian only
    bool overdispersion = true; ///< false: η is 0, answers are binomial
    WidthPrior widthPrior = WidthPrior::automatic;
    double betaPrior = 10.0;               ///< lapse, guess and η ~ Beta(1, this)
    std::optional<double> lowest, highest; ///< stimulus range of the priors, given units; none: that of the
                                           ///< data
    CredibleMethod credible = CredibleMethod::percentile;
    /// Number of parameter sets drawn from the posterior, for intervals of derived quantities; the band needs
    /// 1000.
    int draws = 0;
    int curvePoints = 0; ///< > 1: number of x at which the fitted curve and its band are
                         ///< computed
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

/// One level, after rows with equal x were merged.
struct FittedLevel {
    double x = 0.0; ///< given units
    double right = 0.0;
    double of = 0.0;
    double fitted = kNotKnown;   ///< ψ
    double residual = kNotKnown; ///< sign(y − ψ) √d, where d is the level's contribution to the deviance
};

struct CurveSample {
    double x = 0.0; ///< given units
    double fitted = kNotKnown;
    double low = kNotKnown;
    double high = kNotKnown;
};

/// The result of a fit. A value that the data do not determine is not a number, and `warnings` say why:
/// "token: words".
struct FitResult {
    bool fitted = false;
    FitMethod method = FitMethod::maximumLikelihood;
    Sigmoid function = Sigmoid::gauss;
    StimulusScale scale = StimulusScale::linear;
    /// x at which the unscaled curve is 0.5, given units (maximum-likelihood estimate or posterior mode).
    double threshold = kNotKnown;
    double width = kNotKnown; ///< from 5 % to 95 % of the unscaled curve, on the fitted axis
    double lapse = kNotKnown;
    double guess = kNotKnown;
    double eta = 0.0;
    CurveParameters best; ///< the same five, threshold on the fitted axis
    CurveParameters mean; ///< posterior mean; Bayesian only
    /// Standard errors (observed information, or posterior standard deviation); fitted axis.
    CurveParameters error;
    /// Standard errors from the expected information, as Fisher scoring (glm) gives; maximum likelihood only.
    CurveParameters expectedError;
    double thresholdWidthCovariance = kNotKnown;      ///< from the observed information
    ParameterIntervals ci;                            ///< threshold in given units
    WidthPrior intervalPrior = WidthPrior::psignifit; ///< prior of `ci`, `draws` and the band, never
                                                      ///< automatic; Bayesian only
    /// How much the prior determined the result: the posterior's standard deviation divided by the prior's
    /// (for the width: of its logarithm). Near 0 the answers determine it, near 1 the prior does. Not numbers
    /// if a parameter is fixed, nor in maximum likelihood, which has no prior.
    CurveParameters priorInfluence{kNotKnown, kNotKnown, kNotKnown, kNotKnown, kNotKnown};
    double confidence = 0.95;
    double deviance = kNotKnown;
    double pValue = kNotKnown; ///< of the deviance: Monte Carlo if asked for, else chi-square
    double chiSquareP = kNotKnown;
    int freeParameters = 0;
    int degreesOfFreedom = 0;
    /// Binomial log-likelihood at `best`, with the binomial coefficients of the rows as given.
    double logLikelihood = kNotKnown;
    double logPosterior = kNotKnown; ///< at the mode, up to a constant; Bayesian only
    double aic = kNotKnown;
    std::vector<FittedLevel> levels;
    std::vector<CurveSample> curve;
    std::vector<CurveParameters> draws; ///< bootstrap fits or posterior draws, on the fitted axis
    std::vector<std::string> warnings;
};

} // namespace chiron::psychophysics
