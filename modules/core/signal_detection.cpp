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
    const double density = normalDensity(normalQuantile(rate));
    return rate * (1.0 - rate) / (n * density * density);
}

} // namespace

double correctedRate(int yes, int of) noexcept { return (yes + 0.5) / (of + 1.0); }

double dPrime(double hitRate, double falseAlarmRate) noexcept { return normalQuantile(hitRate) - normalQuantile(falseAlarmRate); }

double criterion(double hitRate, double falseAlarmRate) noexcept {
    return -0.5 * (normalQuantile(hitRate) + normalQuantile(falseAlarmRate));
}

double dPrime(const DetectionCounts& n) noexcept {
    return dPrime(correctedRate(n.hits, n.ofSignal), correctedRate(n.falseAlarms, n.ofNoise));
}

double criterion(const DetectionCounts& n) noexcept {
    return criterion(correctedRate(n.hits, n.ofSignal), correctedRate(n.falseAlarms, n.ofNoise));
}

double dPrimeStandardError(const DetectionCounts& n) noexcept {
    return std::sqrt(varianceOfZ(correctedRate(n.hits, n.ofSignal), n.ofSignal) +
                     varianceOfZ(correctedRate(n.falseAlarms, n.ofNoise), n.ofNoise));
}

DetectionInterval dPrimeInterval(const DetectionCounts& counts, double level) noexcept {
    const double middle = dPrime(counts);
    const double reach = normalQuantile(0.5 * (1.0 + level)) * dPrimeStandardError(counts);
    return {middle - reach, middle + reach};
}

} // namespace chiron::core
