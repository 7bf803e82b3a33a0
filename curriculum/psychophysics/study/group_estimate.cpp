// SPDX-License-Identifier: GPL-3.0-or-later
#include "psychophysics/study/group_estimate.h"

#include "psychophysics/measures/exact_tests.h"
#include "psychophysics/measures/random_effects.h"
#include "psychophysics/measures/sample_moments.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace chiron::psychophysics {

namespace {

constexpr int kFewParticipants = 6;
constexpr double kJndPerSigma = 0.9538725524089398; ///< √2 z(0.75)

/// log10 W of one participant and its variance.
struct LogWeber {
    bool usable = false;
    double value = 0.0;
    double variance = 0.0;
};

bool priorMadeIt(const RunEstimate& run) {
    return hasWarning(run.warnings, WarningKind::priorEdgeLow) || hasWarning(run.warnings, WarningKind::priorEdgeHigh);
}

LogWeber logWeberOf(const RunEstimate& run) {
    LogWeber result;
    const double low = std::log10(run.weber95.low);
    const double high = std::log10(run.weber95.high);
    if (!(run.weber > 0.0) || !std::isfinite(run.weber) || !std::isfinite(low) || !std::isfinite(high) || high < low || priorMadeIt(run))
        return result;
    const double error = (high - low) / (2.0 * 1.959963984540054);
    return {true, std::log10(run.weber), error * error};
}

/// Mean of a statistic over participants drawn, by random effects.
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

Interval powerOfTen(double low, double high) { return {std::pow(10.0, low), std::pow(10.0, high)}; }

bool isSealed(const RunEstimate& run) {
    return std::any_of(run.warnings.begin(), run.warnings.end(), [](const Warning& warning) { return warning.kind == WarningKind::sealed; });
}

/// Answers that are sealed say nothing yet, which is another thing than answers that give no value.
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

/// Mean over participants with a t interval, of whatever can be had (PSE, exponent).
void takeMean(const std::vector<double>& values, double& mean, Interval& interval) {
    const SampleMoments moments = momentsOf(values);
    mean = moments.mean;
    if (moments.count < 2)
        return;
    const double half = studentQuantile(0.975, moments.count - 1.0) * moments.sd / std::sqrt(static_cast<double>(moments.count));
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

GroupEstimate estimateGroup(const std::vector<RunEstimate>& runs, std::uint64_t seed) {
    GroupEstimate result;
    result.method = "random effects on log10 W (REML, Hartung-Knapp interval), BCa bootstrap over participants";
    std::vector<LogWeber> logs;
    double reference = std::numeric_limits<double>::quiet_NaN();
    for (std::size_t i = 0; i < runs.size(); ++i) {
        const LogWeber log = logWeberOf(runs[i]);
        result.members.push_back({static_cast<int>(i), runs[i].weber, log.usable ? std::sqrt(log.variance) : std::nan(""), 0.0});
        if (!log.usable)
            continue;
        logs.push_back(log);
        reference = runs[i].jnd / runs[i].weber;
        result.unit = runs[i].unit;
    }
    result.participants = static_cast<int>(logs.size());
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
    const BootstrapInterval bootstrap =
        bootstrapSubjects(result.participants, [&](const std::vector<int>& drawn) { return meanOf(logs, drawn); }, seed);
    result.bootstrap95 = powerOfTen(bootstrap.low, bootstrap.high);
    return result;
}

ConditionComparison compareConditions(const std::vector<RunEstimate>& first, const std::vector<RunEstimate>& second, std::uint64_t seed) {
    ConditionComparison result;
    std::vector<LogWeber> differences;
    const std::size_t both = std::min(first.size(), second.size());
    for (std::size_t i = 0; i < both; ++i) {
        const LogWeber a = logWeberOf(first[i]);
        const LogWeber b = logWeberOf(second[i]);
        if (a.usable && b.usable)
            differences.push_back({true, b.value - a.value, a.variance + b.variance});
    }
    result.participants = static_cast<int>(differences.size());
    warnOfNumber(result.warnings, result.participants, static_cast<int>(std::max(first.size(), second.size())) - result.participants);
    if (differences.empty())
        return result;
    const RandomEffects effects = effectsOf(differences);
    result.ratio = std::pow(10.0, effects.mean);
    result.ratio95 = powerOfTen(effects.low, effects.high);
    result.pValue = effects.pZero;
    result.sdBetweenLog10 = effects.tau;
    const BootstrapInterval bootstrap =
        bootstrapSubjects(result.participants, [&](const std::vector<int>& drawn) { return meanOf(differences, drawn); }, seed);
    result.bootstrap95 = powerOfTen(bootstrap.low, bootstrap.high);
    return result;
}

} // namespace chiron::psychophysics
