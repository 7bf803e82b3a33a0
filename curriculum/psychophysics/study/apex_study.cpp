// SPDX-License-Identifier: GPL-3.0-or-later
#include "psychophysics/study/apex_study.h"

#include "core/random.h"
#include "psychophysics/measures/exact_tests.h"
#include "psychophysics/measures/random_effects.h"
#include "psychophysics/measures/sample_moments.h"
#include "psychophysics/measures/variance_components.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace chiron::psychophysics {

namespace {

constexpr double kMm = 1000.0;
constexpr int kFewParticipants = 5; ///< P2 had 5
constexpr int kFewTrials = 10;      ///< P2 had 10 per participant

/// Errors of one participant, per cent of the radius.
struct Own {
    std::array<std::vector<double>, 2> axis;
};
using ByParticipant = std::map<int, Own>;

Interval overMeans(const std::vector<double>& means) {
    const SampleMoments m = momentsOf(means);
    if (m.count < 2)
        return {};
    const double half =
        studentQuantile(0.975, m.count - 1.0) * m.sd / std::sqrt(static_cast<double>(m.count));
    return {m.mean - half, m.mean + half};
}

/// The bias is the mean of the participants' own biases, equally weighted; the spread is split by restricted
/// maximum likelihood.
ApexAxis axisOf(const ByParticipant& people, std::size_t axis, double radius_mm) {
    std::vector<double> means;
    std::vector<std::vector<double>> groups;
    for (const auto& [participant, own] : people) {
        means.push_back(momentsOf(own.axis[axis]).mean);
        groups.push_back(own.axis[axis]);
    }
    const double perPercent = radius_mm / 100.0;
    ApexAxis result;
    result.biasPercent = momentsOf(means).mean;
    result.bias_mm = result.biasPercent * perPercent;
    const Interval interval = overMeans(means);
    result.bias95_mm = {interval.low * perPercent, interval.high * perPercent};
    const VarianceComponents spread = varianceComponents(groups);
    result.sdWithin_mm = std::sqrt(spread.within) * perPercent;
    result.sdBetween_mm = std::sqrt(spread.between) * perPercent;
    result.sdPercent = std::sqrt(spread.within + (std::isfinite(spread.between) ? spread.between : 0.0));
    result.sd_mm = result.sdPercent * perPercent;
    return result;
}

double meanOfAbsolutes(const Own& own) {
    double sum = 0.0;
    for (const auto& axis : own.axis)
        for (const double error : axis)
            sum += std::abs(error);
    return sum / static_cast<double>(own.axis[0].size() + own.axis[1].size());
}

ByParticipant sortTrials(ApexSummary& result, const std::vector<ApexTrial>& trials, double radius_m) {
    ByParticipant people;
    for (const ApexTrial& trial : trials) {
        if (!std::isfinite(trial.errorX_m) || !std::isfinite(trial.errorY_m)) {
            ++result.leftOut;
            continue;
        }
        const double x = 100.0 * trial.errorX_m / radius_m;
        const double y = 100.0 * trial.errorY_m / radius_m;
        people[trial.participant].axis[0].push_back(x);
        people[trial.participant].axis[1].push_back(y);
        result.points.push_back({trial.participant, x, y});
    }
    result.participants = static_cast<int>(people.size());
    result.trials = static_cast<int>(result.points.size());
    return people;
}

void takeAbsolutes(ApexSummary& result, const ByParticipant& people, double radius_mm, std::uint64_t seed) {
    std::vector<double> all;
    std::vector<double> distances;
    for (const ApexPoint& point : result.points) {
        all.push_back(std::abs(point.xPercent));
        all.push_back(std::abs(point.yPercent));
        distances.push_back(std::hypot(point.xPercent, point.yPercent));
    }
    const SampleMoments m = momentsOf(all);
    result.meanAbsolutePercent = m.mean;
    result.sdAbsolutePercent = m.sd;
    result.meanAbsolute_mm = m.mean * radius_mm / 100.0;
    result.sdOverMean = m.sd / m.mean;
    result.meanDistance_mm = momentsOf(distances).mean * radius_mm / 100.0;
    result.impliedSdPercent = m.mean * std::sqrt(std::numbers::pi / 2.0);
    result.impliedSd_mm = result.impliedSdPercent * radius_mm / 100.0;
    std::vector<double> means;
    for (const auto& [participant, own] : people)
        means.push_back(meanOfAbsolutes(own));
    result.meanAbsolute95 = overMeans(means);
    const auto meanOfDrawn = [&](const std::vector<int>& drawn) {
        double sum = 0.0;
        for (const int index : drawn)
            sum += means[static_cast<std::size_t>(index)];
        return sum / static_cast<double>(drawn.size());
    };
    const BootstrapInterval bootstrap = bootstrapSubjects(result.participants, meanOfDrawn, seed);
    result.meanAbsoluteBootstrap95 = {bootstrap.low, bootstrap.high};
}

void takeBars(ApexSummary& result, const ByParticipant& people) {
    for (const auto& [participant, own] : people) {
        std::vector<double> absolutes;
        for (const auto& axis : own.axis)
            for (const double error : axis)
                absolutes.push_back(std::abs(error));
        const SampleMoments m = momentsOf(absolutes);
        result.bars.push_back({participant, static_cast<int>(own.axis[0].size()), m.mean, m.sd,
                               momentsOf(own.axis[0]).mean, momentsOf(own.axis[1]).mean});
    }
}

void warn(ApexSummary& result) {
    const auto leavesZeroOut = [](const Interval& interval) {
        return interval.low > 0.0 || interval.high < 0.0;
    };
    if (result.participants < kFewParticipants)
        result.warnings.push_back({WarningKind::fewMarkers, result.participants});
    if (std::any_of(result.bars.begin(), result.bars.end(),
                    [](const ApexBar& bar) { return bar.trials < kFewTrials; }))
        result.warnings.push_back({WarningKind::fewMarks});
    if (leavesZeroOut(result.axes[0].bias95_mm))
        result.warnings.push_back({WarningKind::biasX});
    if (leavesZeroOut(result.axes[1].bias95_mm))
        result.warnings.push_back({WarningKind::biasY});
    const auto beyond = std::count_if(result.points.begin(), result.points.end(), [](const ApexPoint& point) {
        return std::hypot(point.xPercent, point.yPercent) > 100.0;
    });
    if (beyond > 0)
        result.warnings.push_back({WarningKind::beyondRadius, static_cast<int>(beyond)});
}

} // namespace

ApexSummary summariseApex(const std::vector<ApexTrial>& trials, double radius_m, std::uint64_t seed) {
    ApexSummary result;
    if (!(radius_m > 0.0) || !std::isfinite(radius_m)) {
        result.warnings.push_back({WarningKind::noRadius});
        return result;
    }
    const double radius_mm = radius_m * kMm;
    const ByParticipant people = sortTrials(result, trials, radius_m);
    if (result.leftOut > 0)
        result.warnings.push_back({WarningKind::leftOutMarks, result.leftOut});
    if (people.empty()) {
        result.warnings.push_back({WarningKind::noMarks});
        return result;
    }
    for (std::size_t axis = 0; axis < result.axes.size(); ++axis)
        result.axes[axis] = axisOf(people, axis, radius_mm);
    takeAbsolutes(result, people, radius_mm, seed);
    takeBars(result, people);
    warn(result);
    return result;
}

std::vector<ApexTrial> simulateApex(const ApexObserver& observer, int participants, int trialsEach,
                                    double radius_m, std::uint64_t seed) {
    auto random = core::Random::stream(seed, "apex observer");
    const double within = observer.sdPercent / 100.0 * radius_m;
    const double between = observer.sdBetweenPercent / 100.0 * radius_m;
    std::vector<ApexTrial> trials;
    for (int participant = 0; participant < participants; ++participant) {
        const double biasX = between * random.normal();
        const double biasY = between * random.normal();
        for (int trial = 0; trial < trialsEach; ++trial) {
            const double x = biasX + within * random.normal();
            trials.push_back({participant, x, biasY + within * random.normal()});
        }
    }
    return trials;
}

ApexPlan planApex(const ApexObserver& observer, int participants, int trialsEach, double otherMeanPercent,
                  int studies, std::uint64_t seed) {
    ApexPlan plan;
    if (participants < 2 || trialsEach < 1 || studies < 1)
        return plan;
    std::vector<double> ofMeans, halves;
    int found = 0;
    for (int study = 0; study < studies; ++study) {
        ByParticipant people;
        for (const ApexTrial& trial : simulateApex(observer, participants, trialsEach, 1.0,
                                                   seed + static_cast<std::uint64_t>(study))) {
            people[trial.participant].axis[0].push_back(100.0 * trial.errorX_m);
            people[trial.participant].axis[1].push_back(100.0 * trial.errorY_m);
        }
        std::vector<double> means;
        for (const auto& [participant, own] : people)
            means.push_back(meanOfAbsolutes(own));
        const Interval interval = overMeans(means);
        ofMeans.push_back(momentsOf(means).mean);
        halves.push_back(0.5 * (interval.high - interval.low));
        found += interval.low > otherMeanPercent || interval.high < otherMeanPercent ? 1 : 0;
    }
    const SampleMoments mean = momentsOf(ofMeans), half = momentsOf(halves);
    plan.meanAbsolutePercent = mean.mean;
    plan.halfWidthPercent = half.mean;
    plan.power = static_cast<double>(found) / studies;
    plan.meanError = mean.sd / std::sqrt(static_cast<double>(studies));
    plan.halfWidthError = half.sd / std::sqrt(static_cast<double>(studies));
    const double share = (found + 2.0) / (studies + 4.0);
    plan.powerError = std::sqrt(share * (1.0 - share) / (studies + 4.0));
    return plan;
}

} // namespace chiron::psychophysics
