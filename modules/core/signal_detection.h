// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace chiron::core {

/// Counts of answers in a yes–no task. `hits` of the `ofSignal` positions with a signal (trials, regions)
/// were answered yes, and `falseAlarms` of the `ofNoise` positions without one.
struct DetectionCounts {
    int hits = 0;
    int ofSignal = 0;
    int falseAlarms = 0;
    int ofNoise = 0;

    DetectionCounts& operator+=(const DetectionCounts& other) noexcept {
        hits += other.hits;
        ofSignal += other.ofSignal;
        falseAlarms += other.falseAlarms;
        ofNoise += other.ofNoise;
        return *this;
    }
    friend bool operator==(const DetectionCounts&, const DetectionCounts&) = default;
};

/// Fewest positions with a signal, and fewest without, for a usable d′ (models.md §6).
inline constexpr int kUsableCounts = 20;
inline bool isUsable(const DetectionCounts& n) noexcept {
    return n.ofSignal >= kUsableCounts && n.ofNoise >= kUsableCounts;
}

/// Returns the rate with the log-linear correction, (yes + ½)/(of + 1): never 0 or 1, and ½ if nothing was
/// asked (Hautus 1995, Behavior Research Methods 27:46–51; models.md §6).
double correctedRate(int yes, int of) noexcept;

/// Hit and false-alarm rate with a log-linear correction weighted by the base rate. With p the share of
/// positions with a signal, H = (hits + p)/(n₁ + 2p) and F = (false alarms + 1 − p)/(n₀ + 2(1 − p)), so that
/// somebody who never answers yes, or always does, has H = F and d′ = 0 whatever the base rate. This is our
/// extension of Hautus (1995), with which it agrees when there are as many positions with a signal as
/// without. ½ if nothing was asked.
struct DetectionRates {
    double hit = 0.5;
    double falseAlarm = 0.5;
};
DetectionRates weightedRates(const DetectionCounts& counts) noexcept;

enum class RateCorrection { logLinear, none };
/// Returns the rate of the counts; without correction it is not a number if nothing was asked.
double rateOf(int yes, int of, RateCorrection correction) noexcept;

/// d′ = z(H) − z(F) and c = −½(z(H) + z(F)) of the equal-variance Gaussian model; c > 0 means a bias towards
/// "no". Macmillan & Creelman, Detection Theory (2nd ed. 2005), eq. 1.5 and 2.1. The rates are used without
/// correction, so the results are infinite at 0 and 1.
double dPrime(double hitRate, double falseAlarmRate) noexcept;
double criterion(double hitRate, double falseAlarmRate) noexcept;
/// The same for counts, with corrected rates: always finite; 0 if there are no answers at all.
double dPrime(const DetectionCounts& counts) noexcept;
double criterion(const DetectionCounts& counts) noexcept;

/// Standard error of the d′ of counts (Gourevitch & Galanter 1967, Psychometrika 32:25–33; Macmillan &
/// Creelman 2005, eq. 13.4): var = H(1−H)/(n₁ φ(z(H))²) + F(1−F)/(n₀ φ(z(F))²), with the rates corrected as
/// `correction` says and n₁ and n₀ the true numbers of positions with and without a signal. Infinite if
/// either is 0; not a number for uncorrected rates of 0 or 1.
double dPrimeStandardError(const DetectionCounts& counts,
                           RateCorrection correction = RateCorrection::logLinear) noexcept;

struct DetectionInterval {
    double low = 0.0;
    double high = 0.0;
};

/// Returns d′ ± z((1 + level)/2) standard errors; 0 < level < 1. The approximation holds for large samples
/// and is unusable below kUsableCounts.
DetectionInterval dPrimeInterval(const DetectionCounts& counts, double level = 0.95,
                                 RateCorrection correction = RateCorrection::logLinear) noexcept;

/// d′ and c of the weighted rates, and the interval of that d′ by the delta method.
double weightedDPrime(const DetectionCounts& counts) noexcept;
double weightedCriterion(const DetectionCounts& counts) noexcept;
DetectionInterval weightedDPrimeInterval(const DetectionCounts& counts, double level = 0.95) noexcept;

} // namespace chiron::core
