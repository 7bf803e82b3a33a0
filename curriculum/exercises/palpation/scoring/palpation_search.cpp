// SPDX-License-Identifier: GPL-3.0-or-later
#include "curriculum/exercises/palpation/scoring/palpation_metrics.h"

#include "curriculum/exercises/palpation/scoring/palpation_reasons.h"
#include "curriculum/exercises/palpation/scoring/palpation_samples.h"
#include "scoring/metrics/metric_rows.h"
#include "scoring/metrics/recorded_values.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace chiron::scoring {

namespace {

Measurement measureCoverage(std::span<const PreparedTrial> trials) {
    if (trials.empty())
        return Measurement::undefined(reasons::kNoTrials);
    double sum = 0.0;
    for (const PreparedTrial& trial : trials) {
        const QuantityTrace* coverage = quantityOf(trial, "coverage");
        if (coverage == nullptr || coverage->values.empty())
            return Measurement::undefined(reasons::kNoCoverage);
        sum += coverage->values.back();
    }
    return Measurement::of(100.0 * sum / static_cast<double>(trials.size()));
}

Measurement measureForceBandTime(std::span<const PreparedTrial> trials) {
    if (trials.empty())
        return Measurement::undefined(reasons::kNoTrials);
    double pressing_s = 0.0;
    double inBand_s = 0.0;
    for (const PreparedTrial& trial : trials) {
        const PalpationBand band = palpationBandOf(trial.trial->truth);
        if (!band.low_N || !band.high_N)
            return Measurement::undefined(reasons::kNoForceBand);
        forEachPress(trial, [&](double force_N, double begin_s, double end_s) {
            pressing_s += end_s - begin_s;
            inBand_s += force_N >= *band.low_N && force_N <= *band.high_N ? end_s - begin_s : 0.0;
        });
    }
    return pressing_s > 0.0 ? Measurement::of(100.0 * inBand_s / pressing_s)
                            : Measurement::undefined(reasons::kNothingPressed);
}

/// Length of the union of all fingers' presses: simultaneous presses count once.
double pressed_s(const PreparedTrial& trial) {
    std::vector<std::pair<double, double>> spans;
    forEachPress(trial, [&](double, double begin_s, double end_s) {
        if (!spans.empty() && spans.back().second == begin_s)
            spans.back().second = end_s;
        else
            spans.emplace_back(begin_s, end_s);
    });
    std::sort(spans.begin(), spans.end());
    double sum_s = 0.0;
    double until_s = -std::numeric_limits<double>::infinity();
    for (const auto& [begin_s, end_s] : spans) {
        sum_s += std::max(0.0, end_s - std::max(begin_s, until_s));
        until_s = std::max(until_s, end_s);
    }
    return sum_s;
}

Measurement measurePressingTime(std::span<const PreparedTrial> trials) {
    if (trials.empty())
        return Measurement::undefined(reasons::kNoTrials);
    double time_s = 0.0;
    for (const PreparedTrial& trial : trials) {
        if (trial.tool == nullptr)
            return Measurement::undefined(reasons::kNoSamples);
        time_s += pressed_s(trial);
    }
    return Measurement::of(time_s);
}

double doneAt_s(const std::vector<TimedReport>& reports) {
    for (const TimedReport& report : reports)
        if (report.field == simulation::ReportField::done)
            return report.t_s;
    return std::numeric_limits<double>::infinity();
}

double searched_s(const ToolTrace& tool, double until_s) {
    double sum_s = 0.0;
    for (std::size_t i = 0; i + 1 < tool.t_s.size(); ++i)
        if (tool.paused[i] == 0)
            sum_s += std::max(0.0, std::min(tool.t_s[i + 1], until_s) - tool.t_s[i]);
    return sum_s;
}

Measurement measureSearchingTime(std::span<const PreparedTrial> trials) {
    if (trials.empty())
        return Measurement::undefined(reasons::kNoTrials);
    double time_s = 0.0;
    for (const PreparedTrial& trial : trials) {
        const auto told = reportsOf(*trial.trial);
        if (!told || trial.tool == nullptr)
            return Measurement::undefined(reasons::kNoReports);
        time_s += searched_s(*trial.tool, doneAt_s(told->reports));
    }
    return Measurement::of(time_s);
}

} // namespace

std::vector<MetricDefinition> palpationSearchMetrics() {
    MetricRows rows;
    rows.add({.id = "coverage",
              .unit = "%",
              .direction = Direction::higherIsBetter,
              .wrench = MetricWrench::tissue,
              .aggregate = Aggregate::pooled,
              .tools = MetricTools::all,
              .title = QT_TRANSLATE_NOOP("Metrics", "Area covered"),
              .meaning = QT_TRANSLATE_NOOP("Metrics", "How much of the search area was pressed hard enough "
                                                      "to find something; the mean over the trials."),
              .definition = "Share of the search area that was pressed with at least the level's cover force "
                            "by the trial's end, as recorded; the "
                            "mean over the trials.",
              .source = "models.md §6 (area covered)",
              .measure = measureCoverage});
    rows.add(
        {.id = "force_band_time",
         .unit = "%",
         .direction = Direction::higherIsBetter,
         .wrench = MetricWrench::tissue,
         .aggregate = Aggregate::pooled,
         .tools = MetricTools::all,
         .needsForces = true,
         .title = QT_TRANSLATE_NOOP("Metrics", "Time in the force band"),
         .meaning = QT_TRANSLATE_NOOP(
             "Metrics", "During how much of the pressing time the force was neither too low nor too high."),
         .definition = "Share of the pressing time (over 0.02 N, each finger's own, added up) for which "
                       "|f| of that finger was within the "
                       "level's force band, both ends included, each sample held until the next.",
         .source = "models.md §6; our definition",
         .measure = measureForceBandTime});
    rows.add({.id = "pressing_time",
              .unit = "s",
              .direction = Direction::neutral,
              .wrench = MetricWrench::tissue,
              .aggregate = Aggregate::pooled,
              .tools = MetricTools::all,
              .needsForces = true,
              .title = QT_TRANSLATE_NOOP("Metrics", "Time pressing"),
              .meaning = QT_TRANSLATE_NOOP("Metrics",
                                           "How long a finger pressed the tissue, in all trials together."),
              .definition = "Time for which any finger pressed the tissue with more than 0.02 N, each sample "
                            "held until the next.",
              .source = "models.md §6; our definition",
              .measure = measurePressingTime});
    rows.add({.id = "searching_time",
              .unit = "s",
              .aggregate = Aggregate::pooled,
              .title = QT_TRANSLATE_NOOP("Metrics", "Time searching"),
              .meaning = QT_TRANSLATE_NOOP(
                  "Metrics",
                  "How long the trials took until the search was reported as done; pauses do not count."),
              .definition = "Time of the trials from their start until done was reported, or until they "
                            "ended, without pauses.",
              .source = "models.md §6; our definition",
              .measure = measureSearchingTime});
    return rows.take();
}

} // namespace chiron::scoring
