// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/signal_detection.h"

#include "core/normal_distribution.h"

#include <cmath>
#include <limits>

namespace chiron::core {

namespace {

/// Variance of z of a corrected rate over n answers, by the delta method.
double varianceOfZ(double rate, int n) noexcept {
    if (n <= 0)
        return std::numeric_limits<double>::infinity();
    if (!(rate > 0.0 && rate < 1.0))
        return std::numeric_limits<double>::quiet_NaN();
    const double density = normalDensity(normalQuantile(rate));
    return rate * (1.0 - rate) / (n * density * density);
}

} // namespace

double correctedRate(int yes, int of) noexcept {
    return (yes + 0.5) / (of + 1.0);
}

double rateOf(int yes, int of, RateCorrection correction) noexcept {
    if (correction == RateCorrection::logLinear)
        return correctedRate(yes, of);
    return static_cast<double>(yes) / of;
}

double dPrime(double hitRate, double falseAlarmRate) noexcept {
    return normalQuantile(hitRate) - normalQuantile(falseAlarmRate);
}

double criterion(double hitRate, double falseAlarmRate) noexcept {
    return -0.5 * (normalQuantile(hitRate) + normalQuantile(falseAlarmRate));
}

double dPrime(const DetectionCounts& n) noexcept {
    return dPrime(correctedRate(n.hits, n.ofSignal), correctedRate(n.falseAlarms, n.ofNoise));
}

double criterion(const DetectionCounts& n) noexcept {
    return criterion(correctedRate(n.hits, n.ofSignal), correctedRate(n.falseAlarms, n.ofNoise));
}

double dPrimeStandardError(const DetectionCounts& n, RateCorrection correction) noexcept {
    return std::sqrt(varianceOfZ(rateOf(n.hits, n.ofSignal, correction), n.ofSignal) +
                     varianceOfZ(rateOf(n.falseAlarms, n.ofNoise, correction), n.ofNoise));
}

DetectionInterval dPrimeInterval(const DetectionCounts& counts, double level,
                                 RateCorrection correction) noexcept {
    const double middle = dPrime(rateOf(counts.hits, counts.ofSignal, correction),
                                 rateOf(counts.falseAlarms, counts.ofNoise, correction));
    const double reach = normalQuantile(0.5 * (1.0 + level)) * dPrimeStandardError(counts, correction);
    return {middle - reach, middle + reach};
}

DetectionRates weightedRates(const DetectionCounts& n) noexcept {
    const double p = static_cast<double>(n.ofSignal) / (n.ofSignal + n.ofNoise), q = 1.0 - p;
    DetectionRates rates;
    if (n.ofSignal > 0)
        rates.hit = (n.hits + p) / (n.ofSignal + 2.0 * p);
    if (n.ofNoise > 0)
        rates.falseAlarm = (n.falseAlarms + q) / (n.ofNoise + 2.0 * q);
    return rates;
}

double weightedDPrime(const DetectionCounts& counts) noexcept {
    const DetectionRates rates = weightedRates(counts);
    return dPrime(rates.hit, rates.falseAlarm);
}

double weightedCriterion(const DetectionCounts& counts) noexcept {
    const DetectionRates rates = weightedRates(counts);
    return criterion(rates.hit, rates.falseAlarm);
}

DetectionInterval weightedDPrimeInterval(const DetectionCounts& n, double level) noexcept {
    const DetectionRates rates = weightedRates(n);
    const double error =
        std::sqrt(varianceOfZ(rates.hit, n.ofSignal) + varianceOfZ(rates.falseAlarm, n.ofNoise));
    const double middle = dPrime(rates.hit, rates.falseAlarm),
                 reach = normalQuantile(0.5 * (1.0 + level)) * error;
    return {middle - reach, middle + reach};
}

} // namespace chiron::core
