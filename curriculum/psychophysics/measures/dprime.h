// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/signal_detection.h"
#include "psychophysics/measures/discrimination.h"

#include <limits>
#include <string>
#include <vector>

namespace chiron::psychophysics {

/// d′ computed from counts, with its standard error (delta method) and interval (the proportion's interval,
/// transformed).
struct DPrimeEstimate {
    double proportion = std::numeric_limits<double>::quiet_NaN();
    double dPrime = std::numeric_limits<double>::quiet_NaN();
    double standardError = std::numeric_limits<double>::quiet_NaN();
    double low = std::numeric_limits<double>::quiet_NaN();
    double high = std::numeric_limits<double>::quiet_NaN(); ///< may be infinite
    /// Exact binomial: this many right answers or more by guessing.
    double pValue = std::numeric_limits<double>::quiet_NaN();
    double scoreChiSquare = std::numeric_limits<double>::quiet_NaN(); ///< (k − n p₀)²/(n p₀ (1 − p₀))
    double scoreP = std::numeric_limits<double>::quiet_NaN();         ///< one-sided p of scoreChiSquare
    /// no_trials, few_trials, chance, all_right, one_answer, rate_at_limit.
    std::vector<std::string> warnings;
};

/// exact: Clopper & Pearson; score: Wilson with continuity correction (as sensR's "score").
enum class ProportionLimits : std::uint8_t { exact, score };

/// Returns d′ from `right` of `of` trials of a task. Yes–no and same–different by differencing need two rates
/// instead.
DPrimeEstimate dPrimeOfCounts(const DiscriminationTask& task, long long right, long long of,
                              ProportionLimits limits = ProportionLimits::exact, double level = 0.95);

/// Returns d′ from hit and false-alarm rates (2AFC, ABX, same–different by independent observation): first
/// the unbiased proportion Φ((z(H) − z(F))/2) (Macmillan & Creelman 2005, eq. 7.9 and ch. 9), then its d′.
/// Not a number for rates outside ]0, 1[.
double dPrimeOfRates(const DiscriminationTask& task, double hitRate, double falseAlarmRate) noexcept;

/// Same–different by differencing (Macmillan & Creelman 2005, eq. 9.5): "different" where |x₁ − x₂| > k.
/// P(different | d′) = Φ((d′ − k)/√2) + Φ((−d′ − k)/√2).
struct SameDifferentRates {
    double hit = 0.0;        ///< "different" to different pairs
    double falseAlarm = 0.0; ///< "different" to equal pairs
};
SameDifferentRates sameDifferentRates(double dPrime, double criterion) noexcept;
/// Returns d′ from rates in ]0, 1[; 0 if H ≤ F.
double sameDifferentDPrime(double hitRate, double falseAlarmRate) noexcept;
/// Returns d′ from counts, with log-linear correction (Hautus 1995) or uncorrected; standard error by the
/// delta method. Without correction the results are not finite at rates of 0 and 1 (warning no_limit). For
/// yes–no see core/signal_detection.h.
DPrimeEstimate sameDifferentOfCounts(long long hits, long long ofDifferent, long long falseAlarms,
                                     long long ofSame, double level = 0.95,
                                     core::RateCorrection correction = core::RateCorrection::logLinear);

/// Returns the warnings that must accompany a d' of counts with the log-linear correction: one_answer if
/// every answer was the same, so that d' comes from the correction alone (a silent observer with 20 trials
/// with and 4 without the stimulus has -0.7); rate_at_limit if one rate is 0 or 1. The counts must be
/// possible ones.
std::vector<std::string> warningsOfRates(long long hits, long long ofSignal, long long falseAlarms,
                                         long long ofNoise);

/// Returns the exact power of a one-sided binomial test against guessing at level α, with n trials and the
/// true d′.
double discriminationPower(const DiscriminationTask& task, double dPrime, int trials,
                           double alpha = 0.05) noexcept;
/// Returns the smallest number of trials with at least that power; 0 if 100,000 are too few.
int trialsForPower(const DiscriminationTask& task, double dPrime, double power, double alpha = 0.05) noexcept;

} // namespace chiron::psychophysics
