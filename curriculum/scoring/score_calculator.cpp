// SPDX-License-Identifier: GPL-3.0-or-later
#include "scoring/score_calculator.h"

#include "scoring/median.h"
#include "scoring/metric_catalogue.h"
#include "scoring/prepared_trial.h"
#include "scoring/trace_grid.h"

#include <algorithm>
#include <vector>

namespace chiron::scoring {

namespace {

core::Result<std::vector<const MetricDefinition*>> resolve(std::span<const MetricRequest> requests,
                                                           std::span<const Gate> gates) {
    std::vector<const MetricDefinition*> metrics;
    const auto add = [&](const std::string& id, int version) -> bool {
        const MetricDefinition* metric = findMetric(id, version);
        if (metric != nullptr && std::find(metrics.begin(), metrics.end(), metric) == metrics.end())
            metrics.push_back(metric);
        return metric != nullptr;
    };
    const auto unknown = [](const std::string& id, int version) {
        return core::fail(core::ErrorCode::badInput,
                          "metric \"" + id + "\"" +
                              (version == 0 ? "" : " version " + std::to_string(version)) +
                              ": expected an id and version of the metric catalogue");
    };
    for (const MetricRequest& request : requests)
        if (!add(request.id, request.version))
            return unknown(request.id, request.version);
    for (const Gate& gate : gates) {
        const bool there =
            std::any_of(metrics.begin(), metrics.end(), [&](auto* m) { return m->id == gate.metric; });
        if (!there && !add(gate.metric, 0))
            return unknown(gate.metric, 0);
    }
    return metrics;
}

MetricValue valueOf(const MetricDefinition& metric, const Measurement& measured) {
    return {std::string(metric.id), metric.version,  std::string(metric.unit),
            measured.value,         measured.reason, {}};
}

Measurement measured(const MetricDefinition& metric, std::span<const PreparedTrial> trials) {
    const bool known = std::all_of(trials.begin(), trials.end(),
                                   [](const PreparedTrial& t) { return t.trial->forcesKnown; });
    return metric.needsForces && !known ? Measurement::undefined(reasons::kNoForces) : metric.measure(trials);
}

/// Aggregates over the trials that have a value. If none has, the result has the first reason.
Measurement aggregate(const MetricDefinition& metric, const std::vector<std::vector<MetricValue>>& trials,
                      std::size_t column) {
    std::vector<double> values;
    for (const auto& trial : trials)
        if (trial[column].value)
            values.push_back(*trial[column].value);
    if (values.empty())
        return trials.empty() ? Measurement::undefined(reasons::kNoTrials)
                              : Measurement{std::nullopt, trials.front()[column].reason};
    double sum = 0.0;
    for (const double v : values)
        sum += v;
    switch (metric.aggregate) {
    case Aggregate::sum:
        return Measurement::of(sum);
    case Aggregate::maximum:
        return Measurement::of(*std::max_element(values.begin(), values.end()));
    case Aggregate::median:
        return Measurement::of(median(std::move(values)));
    case Aggregate::mean:
    case Aggregate::pooled:
        break;
    }
    return Measurement::of(sum / static_cast<double>(values.size()));
}

bool holds(const Gate& gate, const std::optional<double>& value) {
    return value && (!gate.minimum || *value >= *gate.minimum) && (!gate.maximum || *value <= *gate.maximum);
}

void applyGates(ScoreCard& card, std::span<const Gate> gates, bool completed) {
    card.passed = completed;
    for (const Gate& gate : gates)
        for (MetricValue& metric : card.metrics)
            if (metric.id == gate.metric) {
                metric.passed = metric.passed.value_or(true) && holds(gate, metric.value);
                card.passed = card.passed && *metric.passed;
            }
}

} // namespace

core::Result<ScoreCard> calculateScore(const SessionTrace& trace, std::span<const MetricRequest> metrics,
                                       std::span<const Gate> gates, bool completed) {
    const auto chosen = resolve(metrics, gates);
    CHIRON_TRY(chosen);
    const auto onGrids = onStoredGrids(trace);
    CHIRON_TRY(onGrids);
    // Only trials that had an end: a trial that was cut off says nothing about the whole.
    std::vector<PreparedTrial> prepared;
    ScoreCard card;
    for (const TrialTrace& trial : onGrids->trials) {
        if (!trial.unfinished)
            prepared.push_back(prepareTrial(trial, onGrids->forceLimit_N));
        auto& row = card.trials.emplace_back();
        for (const MetricDefinition* metric : *chosen)
            row.push_back(valueOf(*metric, trial.unfinished ? Measurement::undefined(reasons::kNotFinished)
                                                            : measured(*metric, {&prepared.back(), 1})));
    }
    for (PreparedTrial& trial : prepared)
        trial.plannedTrials = onGrids->plannedTrials;
    const bool noneFinished = prepared.empty() && !onGrids->trials.empty();
    for (std::size_t i = 0; i < chosen->size(); ++i) {
        const MetricDefinition& metric = *(*chosen)[i];
        card.metrics.push_back(valueOf(metric, noneFinished ? Measurement::undefined(reasons::kNoneFinished)
                                               : metric.aggregate == Aggregate::pooled
                                                   ? measured(metric, prepared)
                                                   : aggregate(metric, card.trials, i)));
    }
    applyGates(card, gates, completed);
    return card;
}

} // namespace chiron::scoring
