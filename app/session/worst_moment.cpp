// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/worst_moment.h"

#include "scoring/metric_catalogue.h"
#include "scoring/prepared_trial.h"
#include "session/exercise_kind.h"
#include "session/moment_rule.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>
#include <vector>

namespace chiron::session {

namespace {

/// Assumption: where nothing else went wrong, a force is worth a look from this share of the limit on.
constexpr double kNearLimit = 0.8;

std::optional<WorstMoment> largestForce(const PlaybackTrack& track) {
    std::optional<WorstMoment> worst;
    for (std::size_t i = 0; i < track.moments.size(); ++i) {
        const PlaybackMoment& moment = track.moments[i];
        const PlaybackTrial* trial = track.trialAt(moment.t_s);
        if (!trial || moment.t_s > trial->end_s || moment.paused)
            continue;
        for (int k = 0; k < track.toolCount; ++k) {
            const double force_N = track.tool(i, k).tissue_N.norm();
            if (force_N <= (worst ? worst->value : scoring::kContactForce_N))
                continue;
            worst.emplace();
            worst->t_s = moment.t_s;
            worst->trial = moment.trial;
            worst->value = force_N;
            worst->unit = "N";
            worst->reason = "force_max";
        }
    }
    return worst;
}

WorstMoment endOf(const PlaybackTrial& trial, double value) {
    WorstMoment worst;
    worst.t_s = trial.end_s;
    worst.trial = trial.index;
    worst.value = value;
    return worst;
}

const scoring::MetricValue* metricIn(const std::vector<scoring::MetricValue>& metrics,
                                     const std::string& id) {
    const auto found = std::find_if(metrics.begin(), metrics.end(),
                                    [&id](const scoring::MetricValue& m) { return m.id == id; });
    return found == metrics.end() ? nullptr : &*found;
}

/// The end of the trial whose own value is worst for the gate: the largest under a maximum, the smallest over
/// a minimum.
std::optional<WorstMoment> worstTrial(const PlaybackTrack& track, const scoring::ScoreCard& card,
                                      const scoring::Gate& gate) {
    std::optional<WorstMoment> worst;
    for (std::size_t i = 0; i < std::min(card.trials.size(), track.trials.size()); ++i) {
        const scoring::MetricValue* own = metricIn(card.trials[i], gate.metric);
        if (!own || !own->value)
            continue;
        const bool worse = !worst || (gate.maximum ? *own->value > worst->value : *own->value < worst->value);
        if (!worse)
            continue;
        worst = endOf(track.trials[i], *own->value);
        worst->unit = own->unit;
        worst->wholeTrial = true;
    }
    return worst;
}

/// The mark of this type and detail with the largest value.
std::optional<WorstMoment> largestMark(const PlaybackTrack& track, const PlaybackMarkKind& kind,
                                       double factor, std::string_view unit, bool onlyCritical = false,
                                       const char* detail = "") {
    const PlaybackMark* found = nullptr;
    for (const PlaybackMark& mark : track.marks)
        if (mark.kind == kind && mark.value && mark.detail == detail && (mark.critical || !onlyCritical) &&
            (found == nullptr || *mark.value > *found->value))
            found = &mark;
    if (found == nullptr)
        return std::nullopt;
    WorstMoment worst;
    worst.t_s = found->t_s;
    worst.trial = found->trial;
    worst.value = factor * *found->value;
    worst.unit = unit;
    worst.event = *found;
    return worst;
}

/// The first event of the types that the metric counts; the value is the session's count.
std::optional<WorstMoment> firstOf(const PlaybackTrack& track, const std::vector<PlaybackMarkKind>& kinds,
                                   const scoring::MetricValue& metric) {
    const PlaybackMark* first = nullptr;
    for (const PlaybackMark& mark : track.marks)
        if (std::find(kinds.begin(), kinds.end(), mark.kind) != kinds.end() &&
            (first == nullptr || mark.t_s < first->t_s))
            first = &mark;
    if (first == nullptr || !metric.value)
        return std::nullopt;
    WorstMoment worst;
    worst.t_s = first->t_s;
    worst.trial = first->trial;
    worst.value = *metric.value;
    worst.unit = metric.unit;
    worst.event = *first;
    return worst;
}

/// The moment at which one of the scene's quantities was largest within a trial.
std::optional<WorstMoment> largestQuantity(const PlaybackTrack& track, std::string_view id,
                                           std::string_view unit) {
    const PlaybackQuantity* quantity = track.quantity(id);
    std::optional<WorstMoment> worst;
    for (std::size_t i = 0;
         quantity != nullptr && i < std::min(quantity->values.size(), track.moments.size()); ++i) {
        const PlaybackMoment& moment = track.moments[i];
        if (moment.paused || moment.phase != core::TrialPhase::running ||
            (worst && quantity->values[i] <= worst->value))
            continue;
        worst.emplace();
        worst->t_s = moment.t_s;
        worst->trial = moment.trial;
        worst->value = quantity->values[i];
        worst->unit = unit;
    }
    return worst;
}

/// The largest peak of the metric in any trial, if the exercise provides peaks.
std::optional<WorstMoment> largestPeak(const PlaybackTrack& track, const std::string& metric) {
    const PlaybackPeak* found = nullptr;
    for (const PlaybackPeak& peak : track.peaks)
        if (std::find(peak.metrics.begin(), peak.metrics.end(), metric) != peak.metrics.end() &&
            (found == nullptr || peak.value > found->value))
            found = &peak;
    if (found == nullptr)
        return std::nullopt;
    WorstMoment worst;
    worst.t_s = found->t_s;
    worst.trial = found->trial;
    worst.value = found->value;
    worst.unit = found->unit;
    return worst;
}

std::optional<WorstMoment> byRule(const PlaybackTrack& track, const MomentRule& rule,
                                  const scoring::MetricValue& metric) {
    switch (rule.by) {
    case MomentRule::By::largestMark:
        return rule.marks.empty()
                   ? std::nullopt
                   : largestMark(track, rule.marks.front(), rule.factor, rule.unit, rule.onlyCritical);
    case MomentRule::By::firstMark:
        return firstOf(track, rule.marks, metric);
    case MomentRule::By::largestQuantity:
        return largestQuantity(track, rule.quantity, rule.unit);
    case MomentRule::By::own:
        return rule.own != nullptr ? rule.own(track) : std::nullopt;
    }
    return std::nullopt;
}

/// The moment of the first rule of the exercise that names the metric, among the rules for metrics that are
/// spread over a trial or among the others.
std::optional<WorstMoment> byRules(const PlaybackTrack& track, const scoring::MetricValue& metric,
                                   bool spread) {
    if (const auto kind = exerciseKind(track.exercise))
        for (const MomentRule& rule : (*kind)->momentRules())
            if (rule.spread == spread && rule.isOf(metric.id)) {
                auto worst = byRule(track, rule, metric);
                if (worst)
                    worst->wholeTrial = rule.ofWholeTrial;
                return worst;
            }
    return std::nullopt;
}

/// Where tissue broke, whatever the exercise.
std::optional<WorstMoment> broken(const PlaybackTrack& track, const scoring::MetricValue& metric) {
    using namespace mark_kinds;
    if (auto byForce = largestMark(track, kYielded, 1.0, "N"))
        return byForce;
    if (auto byTorque = largestMark(track, kYielded, 1e3, "mN·m", false, kByTorque))
        return byTorque;
    for (const PlaybackMarkKind& kind : {kFailed, kDamaged}) // torn is worse than over-stretched
        if (auto spoiled = firstOf(track, {kind}, metric))
            return spoiled;
    return std::nullopt;
}

/// The moment at which a gate on a metric was missed, if it has one: a force, an event, a largest value.
/// Empty for metrics that are spread over a trial.
std::optional<WorstMoment> located(const PlaybackTrack& track, const scoring::MetricValue& metric) {
    if (metric.id.starts_with("force_"))
        return largestForce(track);
    if (metric.id == "critical_errors")
        if (auto worst = broken(track, metric))
            return worst;
    if (auto worst = byRules(track, metric, false))
        return worst;
    return largestPeak(track, metric.id);
}

/// The moment for a failed gate on a metric that is spread over a trial: by the exercise's rules, or the end
/// of the worst trial.
std::optional<WorstMoment> spread(const PlaybackTrack& track, const scoring::ScoreCard& card,
                                  const scoring::Gate& gate, const scoring::MetricValue& metric) {
    if (auto worst = byRules(track, metric, true))
        return worst;
    return worstTrial(track, card, gate);
}

std::vector<const scoring::Gate*> missedGates(const scoring::ScoreCard& card,
                                              std::span<const scoring::Gate> gates) {
    std::vector<const scoring::Gate*> missed;
    for (const scoring::Gate& gate : gates)
        if (const scoring::MetricValue* metric = metricIn(card.metrics, gate.metric);
            metric && metric->passed == std::optional<bool>(false))
            missed.push_back(&gate);
    return missed;
}

bool meets(const scoring::Gate& gate, double value) {
    return (!gate.minimum || value >= *gate.minimum) && (!gate.maximum || value <= *gate.maximum);
}

/// Whether a pass mark on the session's value can be applied to a single trial. A sum or a count grows with
/// each trial.
bool isPerTrial(const std::string& metric) {
    const scoring::MetricDefinition* definition = scoring::findMetric(metric);
    return definition && definition->aggregate != scoring::Aggregate::sum && definition->unit != "count";
}

/// Of the trials whose own value would have missed a gate, the worst for the first such gate, although the
/// session as a whole met it.
std::optional<WorstMoment> missedInOneTrial(const PlaybackTrack& track, const scoring::ScoreCard& card,
                                            std::span<const scoring::Gate> gates) {
    for (const scoring::Gate& gate : gates) {
        const scoring::MetricValue* metric = metricIn(card.metrics, gate.metric);
        if (!metric || !isPerTrial(gate.metric))
            continue;
        auto worst = worstTrial(track, card, gate);
        if (!worst || meets(gate, worst->value))
            continue;
        if (auto there = located(track, *metric); there && there->trial == worst->trial)
            worst = std::move(there);
        worst->reason = gate.metric;
        return worst;
    }
    return std::nullopt;
}

/// Without a failed gate: what is nevertheless worth a look.
std::optional<WorstMoment> notable(const PlaybackTrack& track, const scoring::ScoreCard& card,
                                   std::span<const scoring::Gate> gates) {
    auto force = largestForce(track);
    if (force && force->value >= kNearLimit * track.forceLimit_N)
        return force;
    return missedInOneTrial(track, card, gates);
}

WorstMoment ledBy(WorstMoment worst, const scoring::Gate& gate) {
    worst.reason = gate.metric;
    worst.gateFailed = true;
    return worst;
}

std::optional<WorstMoment> worstOf(const PlaybackTrack& track, const scoring::ScoreCard& card,
                                   std::span<const scoring::Gate> gates) {
    std::vector<const scoring::Gate*> missed = missedGates(card, gates);
    // Broken tissue is worse than any other failure.
    std::stable_partition(missed.begin(), missed.end(),
                          [](const scoring::Gate* gate) { return gate->metric == "critical_errors"; });
    for (const scoring::Gate* gate : missed)
        if (auto worst = located(track, *metricIn(card.metrics, gate->metric)))
            return ledBy(std::move(*worst), *gate);
    for (const scoring::Gate* gate : missed)
        if (auto worst = spread(track, card, *gate, *metricIn(card.metrics, gate->metric)))
            return ledBy(std::move(*worst), *gate);
    return notable(track, card, gates);
}

/// Adds what follows from the moment's time: the time within its trial, and the depth.
WorstMoment placed(WorstMoment worst, const PlaybackTrack& track) {
    if (const PlaybackTrial* trial = track.trial(worst.trial))
        worst.intoTrial_s = std::max(0.0, worst.t_s - trial->start_s);
    if (const auto kind = exerciseKind(track.exercise); kind && !worst.wholeTrial)
        worst.depth_m = (*kind)->depthAt_m(track, worst.t_s);
    return worst;
}

} // namespace

std::optional<WorstMoment> worstMoment(const PlaybackTrack& track, const scoring::ScoreCard& card,
                                       std::span<const scoring::Gate> gates) {
    if (track.trials.empty())
        return std::nullopt;
    auto worst = worstOf(track, card, gates);
    if (!worst)
        return std::nullopt;
    return placed(std::move(*worst), track);
}

std::vector<WorstMoment> momentsOfFailedGates(const PlaybackTrack& track, const scoring::ScoreCard& card,
                                              std::span<const scoring::Gate> gates) {
    std::vector<WorstMoment> moments;
    if (track.trials.empty())
        return moments;
    for (const scoring::Gate* gate : missedGates(card, gates)) {
        const scoring::MetricValue& metric = *metricIn(card.metrics, gate->metric);
        auto worst = located(track, metric);
        if (!worst)
            worst = spread(track, card, *gate, metric);
        if (worst)
            moments.push_back(placed(ledBy(std::move(*worst), *gate), track));
    }
    return moments;
}

} // namespace chiron::session
