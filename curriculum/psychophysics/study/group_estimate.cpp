// SPDX-License-Identifier: GPL-3.0-or-later
#include "psychophysics/study/group_estimate.h"

#include "psychophysics/fits/chi_square.h"
#include "psychophysics/fits/model_comparison.h"
#include "psychophysics/measures/exact_tests.h"
#include "psychophysics/measures/random_effects.h"
#include "psychophysics/measures/run_fit.h"
#include "psychophysics/measures/sample_moments.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace chiron::psychophysics {

namespace {

constexpr int kFewParticipants = 6;
constexpr double kTellsNothing = 100.0; ///< ratio of the ends: even a tenfold difference is within
constexpr double kJndPerSigma = 0.9538725524089398; ///< √2 z(0.75)

/// log10 W of one participant and its variance.
struct LogWeber {
    bool usable = false;
    double value = 0.0;
    double variance = 0.0;
};

bool priorMadeIt(const RunEstimate& run) {
    return hasWarning(run.warnings, WarningKind::priorEdgeLow) ||
           hasWarning(run.warnings, WarningKind::priorEdgeHigh);
}

bool hasWeber(const RunEstimate& run) {
    const double low = std::log10(run.weber95.low);
    const double high = std::log10(run.weber95.high);
    return run.weber > 0.0 && std::isfinite(run.weber) && std::isfinite(low) && std::isfinite(high) &&
           high >= low;
}

LogWeber logWeberOf(const RunEstimate& run) {
    if (!hasWeber(run) || usableInGroup(run) != Usable::yes) // magnitude estimates have none
        return {};
    const double low = std::log10(run.weber95.low);
    const double high = std::log10(run.weber95.high);
    const double error = (high - low) / (2.0 * 1.959963984540054);
    return {true, std::log10(run.weber), error * error};
}

/// Returns the random-effects mean over the drawn participants.
double meanOf(const std::vector<LogWeber>& logs, const std::vector<int>& drawn) {
    std::vector<double> y;
    std::vector<double> v;
    for (const int index : drawn) {
        y.push_back(logs[static_cast<std::size_t>(index)].value);
        v.push_back(logs[static_cast<std::size_t>(index)].variance);
    }
    return randomEffects(y, v).mean;
}

RandomEffects effectsOf(const std::vector<LogWeber>& logs) {
    std::vector<double> y;
    std::vector<double> v;
    for (const LogWeber& log : logs) {
        y.push_back(log.value);
        v.push_back(log.variance);
    }
    return randomEffects(y, v);
}

Interval powerOfTen(double low, double high) {
    return {std::pow(10.0, low), std::pow(10.0, high)};
}

bool isSealed(const RunEstimate& run) {
    return std::any_of(run.warnings.begin(), run.warnings.end(),
                       [](const Warning& warning) { return warning.kind == WarningKind::sealed; });
}

/// Warns about the number of participants. Sealed answers are reported separately, because they are merely
/// not available yet.
void warnOfNumber(std::vector<Warning>& warnings, int used, int leftOut, int sealed = 0) {
    if (sealed > 0)
        warnings.push_back({WarningKind::sealed});
    if (leftOut > 0)
        warnings.push_back({WarningKind::leftOutParticipants, leftOut});
    if (used == 0 && sealed > 0)
        return;
    if (used == 0)
        warnings.push_back({WarningKind::noParticipants});
    else if (used == 1)
        warnings.push_back({WarningKind::oneParticipant});
    else if (used < kFewParticipants)
        warnings.push_back({WarningKind::fewParticipants, used});
}

/// Computes the mean over participants with a t interval, for values such as PSE and exponent.
void takeMean(const std::vector<double>& values, double& mean, Interval& interval) {
    const SampleMoments moments = momentsOf(values);
    mean = moments.mean;
    if (moments.count < 2)
        return;
    const double half = studentQuantile(0.975, moments.count - 1.0) * moments.sd /
                        std::sqrt(static_cast<double>(moments.count));
    interval = {moments.mean - half, moments.mean + half};
}

void takeOtherMeans(GroupEstimate& result, const std::vector<RunEstimate>& runs) {
    std::vector<double> logPse;
    std::vector<double> exponents;
    for (const RunEstimate& run : runs) {
        if (run.pse > 0.0 && std::isfinite(run.pse))
            logPse.push_back(std::log10(run.pse));
        if (std::isfinite(run.exponent))
            exponents.push_back(run.exponent);
    }
    takeMean(logPse, result.pse, result.pse95);
    result.pse = std::pow(10.0, result.pse);
    result.pse95 = powerOfTen(result.pse95.low, result.pse95.high);
    takeMean(exponents, result.exponent, result.exponent95);
}

void takeEffects(GroupEstimate& result, const RandomEffects& effects, double referenceOf) {
    result.weber = std::pow(10.0, effects.mean);
    result.weber95 = powerOfTen(effects.low, effects.high);
    result.prediction95 = powerOfTen(effects.predictionLow, effects.predictionHigh);
    result.sigma_log10 = std::log10(1.0 + result.weber) / kJndPerSigma;
    result.jnd = result.weber * referenceOf;
    result.sdBetweenLog10 = effects.tau;
    result.iSquared = effects.iSquared;
    result.heterogeneityP = effects.qP;
    if (effects.qP < 0.01)
        result.warnings.push_back({WarningKind::heterogeneous});
}

} // namespace

Usable usableInGroup(const RunEstimate& run) {
    if (run.method == EstimateMethod::numbersSaid)
        return std::isfinite(run.exponent) ? Usable::yes : Usable::noValue;
    if (!hasWeber(run))
        return Usable::noValue;
    return priorMadeIt(run) ? Usable::priorMadeIt : Usable::yes;
}

bool isUnbounded(const Interval& interval) noexcept {
    return interval.high >= kTellsNothing * interval.low;
}

GroupEstimate estimateGroup(const std::vector<RunEstimate>& runs, std::uint64_t seed) {
    GroupEstimate result;
    result.method =
        "random effects on log10 W (REML, Hartung-Knapp interval), BCa bootstrap over participants";
    std::vector<LogWeber> logs;
    double reference = std::numeric_limits<double>::quiet_NaN();
    for (std::size_t i = 0; i < runs.size(); ++i) {
        const LogWeber log = logWeberOf(runs[i]);
        result.members.push_back(
            {static_cast<int>(i), runs[i].weber, log.usable ? std::sqrt(log.variance) : std::nan(""), 0.0});
        if (!log.usable)
            continue;
        logs.push_back(log);
        reference = runs[i].jnd / runs[i].weber;
        result.unit = runs[i].unit;
    }
    result.participants = static_cast<int>(std::count_if(
        runs.begin(), runs.end(), [](const RunEstimate& run) { return usableInGroup(run) == Usable::yes; }));
    const int sealed = static_cast<int>(std::count_if(runs.begin(), runs.end(), isSealed));
    result.leftOut = static_cast<int>(runs.size()) - result.participants - sealed;
    warnOfNumber(result.warnings, result.participants, result.leftOut, sealed);
    takeOtherMeans(result, runs);
    if (logs.empty())
        return result;
    const RandomEffects effects = effectsOf(logs);
    takeEffects(result, effects, reference);
    std::size_t used = 0;
    for (GroupMember& member : result.members)
        if (std::isfinite(member.errorLog10))
            member.weight = effects.weights[used++];
    const BootstrapInterval bootstrap = bootstrapSubjects(
        static_cast<int>(logs.size()), [&](const std::vector<int>& drawn) { return meanOf(logs, drawn); },
        seed);
    result.bootstrap95 = powerOfTen(bootstrap.low, bootstrap.high);
    return result;
}

ConditionComparison compareConditions(const std::vector<RunEstimate>& first,
                                      const std::vector<RunEstimate>& second, std::uint64_t seed) {
    ConditionComparison result;
    std::vector<LogWeber> differences;
    const std::size_t both = std::min(first.size(), second.size());
    for (std::size_t i = 0; i < both; ++i) {
        const LogWeber a = logWeberOf(first[i]);
        const LogWeber b = logWeberOf(second[i]);
        if (a.usable && b.usable)
            differences.push_back({true, b.value - a.value, a.variance + b.variance});
    }
    result.participants = result.first = result.second = static_cast<int>(differences.size());
    warnOfNumber(result.warnings, result.participants,
                 static_cast<int>(std::max(first.size(), second.size())) - result.participants);
    if (differences.empty())
        return result;
    const RandomEffects effects = effectsOf(differences);
    result.ratio = std::pow(10.0, effects.mean);
    result.ratio95 = powerOfTen(effects.low, effects.high);
    result.pValue = effects.pZero;
    result.sdBetweenLog10 = effects.tau;
    const BootstrapInterval bootstrap = bootstrapSubjects(
        result.participants, [&](const std::vector<int>& drawn) { return meanOf(differences, drawn); }, seed);
    result.bootstrap95 = powerOfTen(bootstrap.low, bootstrap.high);
    return result;
}

ConditionComparison compareGroups(const std::vector<RunEstimate>& first,
                                  const std::vector<RunEstimate>& second) {
    ConditionComparison result;
    result.paired = false;
    const auto usable = [](const std::vector<RunEstimate>& runs) {
        std::vector<LogWeber> logs;
        for (const RunEstimate& run : runs)
            if (const LogWeber log = logWeberOf(run); log.usable)
                logs.push_back(log);
        return logs;
    };
    const std::vector<LogWeber> a = usable(first), b = usable(second);
    result.first = static_cast<int>(a.size());
    result.second = static_cast<int>(b.size());
    result.participants = result.first + result.second;
    warnOfNumber(result.warnings, std::min(result.first, result.second),
                 static_cast<int>(first.size() + second.size()) - result.participants);
    if (a.empty() || b.empty())
        return result;
    const RandomEffects x = effectsOf(a), y = effectsOf(b);
    const double difference = y.mean - x.mean;
    result.ratio = std::pow(10.0, difference);
    if (result.first < 2 || result.second < 2)
        return result;
    const double vx = x.standardError * x.standardError, vy = y.standardError * y.standardError;
    const double error = std::sqrt(vx + vy);
    const double freedom =
        (vx + vy) * (vx + vy) / (vx * vx / (result.first - 1) + vy * vy / (result.second - 1));
    const double half = studentQuantile(0.975, freedom) * error;
    result.ratio95 = powerOfTen(difference - half, difference + half);
    result.pValue = 2.0 * studentUpperTail(std::abs(difference) / error, freedom);
    return result;
}

void adjustHolm(const std::vector<ConditionComparison*>& comparisons) {
    std::vector<ConditionComparison*> tested;
    for (ConditionComparison* each : comparisons)
        if (std::isfinite(each->pValue))
            tested.push_back(each);
    std::stable_sort(tested.begin(), tested.end(),
                     [](const auto* a, const auto* b) { return a->pValue < b->pValue; });
    double largest = 0.0;
    for (std::size_t i = 0; i < tested.size(); ++i) {
        largest =
            std::max(largest, std::min(1.0, tested[i]->pValue * static_cast<double>(tested.size() - i)));
        tested[i]->pHolm = largest;
    }
}

ThresholdModels compareThresholdModels(Task first, const std::vector<RunEstimate>& firstRuns, Task second,
                                       const std::vector<RunEstimate>& secondRuns) {
    ThresholdModels result;
    if (first != second || first == Task::adjustment || first == Task::magnitude)
        return result;
    double ratio = 0.0;
    for (std::size_t i = 0; i < std::min(firstRuns.size(), secondRuns.size()); ++i) {
        const std::vector<CurvePoint>&a = firstRuns[i].points, &b = secondRuns[i].points;
        const bool positive = isPositive(first, a) && isPositive(first, b);
        const ModelComparison models = compareConditions(
            {curveData(a, positive), curveData(b, positive)}, freeCurveOptions(first, positive),
            SharedParameters{.width = true, .lapse = true, .guess = true},
            SharedParameters{.threshold = true});
        if (!std::isfinite(models.likelihoodRatio))
            continue;
        ratio += models.likelihoodRatio;
        result.freedom += models.freedom;
        ++result.participants;
    }
    if (result.participants == 0)
        return result;
    result.likelihoodRatio = ratio;
    result.pValue = chiSquareTail(ratio, result.freedom);
    result.aicDifference = ratio - 2.0 * result.freedom;
    return result;
}

} // namespace chiron::psychophysics
