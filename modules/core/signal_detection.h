// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace chiron::core {

/// Answers of a yes–no task: of `ofSignal` places (trials, regions) with a signal `hits` were answered yes, of `ofNoise` without one
/// `falseAlarms`.
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

inline constexpr int kUsableCounts = 20; ///< places with and without a signal each, for a usable d′ (models.md §6)
inline bool isUsable(const DetectionCounts& n) noexcept { return n.ofSignal >= kUsableCounts && n.ofNoise >= kUsableCounts; }

/// A rate with the log-linear correction, (yes + ½)/(of + 1): never 0 or 1, ½ where nothing was asked (Hautus 1995, Behavior
/// Research Methods 27:46–51; models.md §6).
double correctedRate(int yes, int of) noexcept;

/// Hit and false-alarm rate with the log-linear correction weighted by what was asked: with p the share of places with a signal,
/// H = (hits + p)/(n₁ + 2p), F = (false alarms + 1 − p)/(n₀ + 2(1 − p)), so that somebody who says nothing, or yes to everything, has
/// H = F and d′ = 0 whatever the base rate. Our extension of Hautus (1995), which it is where both kinds are as many; ½ where nothing
/// was asked.
struct DetectionRates {
    double hit = 0.5;
    double falseAlarm = 0.5;
};
DetectionRates weightedRates(const DetectionCounts& counts) noexcept;

enum class RateCorrection { logLinear, none };
/// The rate of counts; without correction not a number where nothing was asked.
double rateOf(int yes, int of, RateCorrection correction) noexcept;

/// d′ = z(H) − z(F) and c = −½(z(H) + z(F)) of the equal-variance Gaussian model; c > 0: rather no. Macmillan & Creelman, Detection
/// Theory (2nd ed. 2005), eq. 1.5 and 2.1. Of rates as they are: infinite at 0 and 1.
double dPrime(double hitRate, double falseAlarmRate) noexcept;
double criterion(double hitRate, double falseAlarmRate) noexcept;
/// The same of counts, with corrected rates: always finite; 0 for no answers at all.
double dPrime(const DetectionCounts& counts) noexcept;
double criterion(const DetectionCounts& counts) noexcept;

/// Standard error of d′ of counts (Gourevitch & Galanter 1967, Psychometrika 32:25–33; Macmillan & Creelman 2005, eq. 13.4):
/// var = H(1−H)/(n₁ φ(z(H))²) + F(1−F)/(n₀ φ(z(F))²), with rates so corrected and the true n₁ and n₀ places with and without a signal. Infinite where
/// either is none; not a number for uncorrected rates of 0 or 1.
double dPrimeStandardError(const DetectionCounts& counts, RateCorrection correction = RateCorrection::logLinear) noexcept;

struct DetectionInterval {
    double low = 0.0;
    double high = 0.0;
};

/// d′ ± z((1 + level)/2) standard errors; 0 < level < 1. An approximation for large samples: unusable below kUsableCounts.
DetectionInterval dPrimeInterval(const DetectionCounts& counts, double level = 0.95,
                                 RateCorrection correction = RateCorrection::logLinear) noexcept;

/// d′ and c of weighted rates, and the interval of d′ by the delta method with them.
double weightedDPrime(const DetectionCounts& counts) noexcept;
double weightedCriterion(const DetectionCounts& counts) noexcept;
DetectionInterval weightedDPrimeInterval(const DetectionCounts& counts, double level = 0.95) noexcept;

} // namespace chiron::core
