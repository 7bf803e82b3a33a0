// SPDX-License-Identifier: GPL-3.0-or-later
#include "psychophysics/measures/dprime.h"

#include "core/normal_distribution.h"
#include "core/signal_detection.h"
#include "psychophysics/measures/exact_tests.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace chiron::psychophysics {

namespace {

using core::normalCumulative;
using core::normalQuantile;

constexpr long long kFewCounts = 20;

bool isRate(double rate) {
    return rate > 0.0 && rate < 1.0;
}

void warn(DPrimeEstimate& result, long long right, long long of, double chance) {
    if (of < kFewCounts)
        result.warnings.push_back("few_trials: only " + std::to_string(of) + " trials");
    if (right == of)
        result.warnings.emplace_back(
            "all_right: every answer was right; only a lower limit of d' can be given");
    else if (static_cast<double>(right) <= chance * static_cast<double>(of))
        result.warnings.emplace_back("chance: no better than guessing");
}

} // namespace

std::vector<std::string> warningsOfRates(long long hits, long long ofSignal, long long falseAlarms,
                                         long long ofNoise) {
    const long long yes = hits + falseAlarms;
    if (yes == 0 || yes == ofSignal + ofNoise)
        return {
            "one_answer: every answer was the same; d' is what the correction makes of it, and says nothing"};
    if (hits == 0 || hits == ofSignal || falseAlarms == 0 || falseAlarms == ofNoise)
        return {"rate_at_limit: a rate is 0 or 1; how large d' is depends on the correction, and its true "
                "value has no bound on one side"};
    return {};
}

DPrimeEstimate dPrimeOfCounts(const DiscriminationTask& task, long long right, long long of,
                              ProportionLimits limits, double level) {
    DPrimeEstimate result;
    if (of <= 0 || right < 0 || right > of) {
        result.warnings.emplace_back("no_trials: there are no usable counts");
        return result;
    }
    const double chance = chanceOf(task);
    const double n = static_cast<double>(of);
    const ProportionInterval interval = limits == ProportionLimits::exact
                                            ? exactInterval(right, of, level)
                                            : wilsonInterval(right, of, level, true);
    result.proportion = static_cast<double>(right) / n;
    result.low = dPrimeAt(task, interval.low);
    result.high = dPrimeAt(task, interval.high);
    result.pValue = binomialUpperTail(right, of, chance);
    const double z = (static_cast<double>(right) - n * chance) / std::sqrt(n * chance * (1.0 - chance));
    result.scoreChiSquare = z * z;
    result.scoreP = normalCumulative(-z);
    warn(result, right, of, chance);
    if (right == of || right == 0)
        return result;
    result.dPrime = dPrimeAt(task, result.proportion);
    const double slope = slopeOf(task, result.dPrime);
    if (result.dPrime != 0.0 && slope > 0.0)
        result.standardError = std::sqrt(result.proportion * (1.0 - result.proportion) / n) / slope;
    return result;
}

double dPrimeOfRates(const DiscriminationTask& task, double hitRate, double falseAlarmRate) noexcept {
    if (!isRate(hitRate) || !isRate(falseAlarmRate))
        return std::numeric_limits<double>::quiet_NaN();
    return dPrimeAt(task, normalCumulative(0.5 * (normalQuantile(hitRate) - normalQuantile(falseAlarmRate))));
}

SameDifferentRates sameDifferentRates(double dPrime, double criterion) noexcept {
    const double root = std::numbers::sqrt2;
    return {normalCumulative((dPrime - criterion) / root) + normalCumulative((-dPrime - criterion) / root),
            2.0 * normalCumulative(-criterion / root)};
}

double sameDifferentDPrime(double hitRate, double falseAlarmRate) noexcept {
    if (!isRate(hitRate) || !isRate(falseAlarmRate))
        return std::numeric_limits<double>::quiet_NaN();
    if (hitRate <= falseAlarmRate)
        return 0.0;
    const double criterion = -std::numbers::sqrt2 * normalQuantile(0.5 * falseAlarmRate);
    double low = 0.0;
    double high = 60.0;
    while (high - low > 1e-12) {
        const double middle = 0.5 * (low + high);
        if (middle <= low || middle >= high)
            break;
        (sameDifferentRates(middle, criterion).hit < hitRate ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

DPrimeEstimate sameDifferentOfCounts(long long hits, long long ofDifferent, long long falseAlarms,
                                     long long ofSame, double level, core::RateCorrection correction) {
    DPrimeEstimate result;
    if (ofDifferent <= 0 || ofSame <= 0 || hits < 0 || hits > ofDifferent || falseAlarms < 0 ||
        falseAlarms > ofSame) {
        result.warnings.emplace_back("no_trials: both equal and different pairs are needed");
        return result;
    }
    const double more = correction == core::RateCorrection::logLinear ? 0.5 : 0.0;
    const auto rate = [more](long long yes, long long of) {
        return (static_cast<double>(yes) + more) / (static_cast<double>(of) + 2.0 * more);
    };
    const double h = rate(hits, ofDifferent);
    const double f = rate(falseAlarms, ofSame);
    result.proportion = 0.5 * (h + 1.0 - f);
    if (!(h > 0.0 && h < 1.0 && f > 0.0 && f < 1.0)) {
        result.warnings.emplace_back(
            "no_limit: a rate is 0 or 1, so d' has no finite value without a correction");
        return result;
    }
    result.dPrime = sameDifferentDPrime(h, f);
    if (correction != core::RateCorrection::none)
        result.warnings = warningsOfRates(hits, ofDifferent, falseAlarms, ofSame);
    if (ofDifferent < kFewCounts || ofSame < kFewCounts)
        result.warnings.emplace_back("few_trials: fewer than 20 equal or different pairs");
    if (result.dPrime <= 0.0) {
        result.warnings.emplace_back("chance: no better than guessing");
        return result;
    }
    const double step = 1e-5 * std::min({h, f, 1.0 - h, 1.0 - f});
    const double byHit = (sameDifferentDPrime(h + step, f) - sameDifferentDPrime(h - step, f)) / (2.0 * step);
    const double byAlarm =
        (sameDifferentDPrime(h, f + step) - sameDifferentDPrime(h, f - step)) / (2.0 * step);
    result.standardError = std::sqrt(byHit * byHit * h * (1.0 - h) / static_cast<double>(ofDifferent) +
                                     byAlarm * byAlarm * f * (1.0 - f) / static_cast<double>(ofSame));
    const double z = normalQuantile(0.5 * (1.0 + level));
    result.low = std::max(0.0, result.dPrime - z * result.standardError);
    result.high = result.dPrime + z * result.standardError;
    return result;
}

double discriminationPower(const DiscriminationTask& task, double dPrime, int trials, double alpha) noexcept {
    if (trials <= 0 || std::isnan(dPrime))
        return std::numeric_limits<double>::quiet_NaN();
    const double chance = chanceOf(task);
    int least = 0; // the smallest significant number of right answers
    int most = trials + 1;
    while (least < most) {
        const int middle = (least + most) / 2;
        if (binomialUpperTail(middle, trials, chance) <= alpha)
            most = middle;
        else
            least = middle + 1;
    }
    return binomialUpperTail(least, trials, proportionCorrect(task, dPrime));
}

int trialsForPower(const DiscriminationTask& task, double dPrime, double power, double alpha) noexcept {
    for (int trials = 1; trials <= 100000; ++trials)
        if (discriminationPower(task, dPrime, trials, alpha) >= power)
            return trials;
    return 0;
}

} // namespace chiron::psychophysics
