// SPDX-License-Identifier: GPL-3.0-or-later
#include "curriculum/exercises/elastic_tube/scoring/tube_metrics.h"

#include "cues/laparoscopy_cues.h"
#include "curriculum/exercises/elastic_tube/scoring/tube_reasons.h"
#include "curriculum/exercises/elastic_tube/scoring/tube_truth.h"
#include "scoring/metric.h"
#include "scoring/metrics/metric_rows.h"
#include "scoring/metrics/recorded_values.h"
#include "scoring/prepared_trial.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace chiron::scoring {

namespace {

/// Returns the reason why there is nothing to measure if any trial lacks what the metric reads: a session's
/// value must not silently leave trials out. Returns none if nothing is missing.
std::optional<Measurement> withoutTube(std::span<const PreparedTrial> trials, std::string_view quantity,
                                       std::optional<double> TubeTruth::*truth = nullptr) {
    if (trials.empty())
        return Measurement::undefined(reasons::kNoTrials);
    for (const PreparedTrial& trial : trials) {
        if (quantityOf(trial, quantity) == nullptr || quantityOf(trial, "step") == nullptr)
            return Measurement::undefined(reasons::kNoTubeData);
        if (truth != nullptr && !(tubeTruthIn(*trial.trial).*truth))
            return Measurement::undefined(reasons::kNoSuchTarget);
    }
    return std::nullopt;
}

bool isTubeStep(double step, core::LaparoscopyStep wanted) {
    return step == static_cast<double>(wanted);
}

/// Selects among the holds of a trial in which a hold was broken and begun again.
enum class TubeHolds {
    all,  ///< broken ones too: an error that ended a hold still counts as an error
    last, ///< the completed one
};

/// Returns the samples of the selected holds without paused ones; empty if nothing was held. Requires that
/// withoutTube() returns none.
std::vector<std::size_t> tubeHold(const PreparedTrial& trial, TubeHolds meant) {
    const std::vector<double>& step = quantityOf(trial, "step")->values;
    std::vector<std::size_t> hold;
    bool holding = false;
    for (std::size_t i = 0; i < step.size(); ++i) {
        if (trial.tool->paused[i] != 0)
            continue;
        const bool now = isTubeStep(step[i], core::LaparoscopyStep::hold);
        if (now && !holding && meant == TubeHolds::last)
            hold.clear();
        if (now)
            hold.push_back(i);
        holding = now;
    }
    return hold;
}

/// Calls visit(error) with tension − target, N, for each sample of the holds of each trial. Requires that
/// withoutTube() finds tension and target.
template <class Visit> void forEachTensionError(std::span<const PreparedTrial> trials, Visit&& visit) {
    for (const PreparedTrial& trial : trials) {
        const std::vector<double>& tension = quantityOf(trial, "tension_N")->values;
        const double target_N = *tubeTruthIn(*trial.trial).target_N;
        for (const std::size_t i : tubeHold(trial, TubeHolds::all))
            visit(tension[i] - target_N);
    }
}

Measurement neverHeld() {
    return Measurement::undefined(reasons::kTensionNeverHeld);
}

/// Returns the samples of a trial during which the fold has to be kept back: from the moment when it first
/// was, to the trial's end, without paused samples. Empty if it never was. Requires that the trial records
/// `fold_open`.
std::vector<std::size_t> sinceFoldOpened(const PreparedTrial& trial) {
    const std::vector<double>& open = quantityOf(trial, "fold_open")->values;
    std::vector<std::size_t> since;
    for (std::size_t i = 0; i < open.size(); ++i)
        if (trial.tool->paused[i] == 0 && (open[i] > 0.5 || !since.empty()))
            since.push_back(i);
    return since;
}

/// Returns the reason why there is no retraction to measure, if there is none.
std::optional<Measurement> withoutFold(std::span<const PreparedTrial> trials) {
    if (auto why = withoutTube(trials, "tension_N"))
        return why;
    for (const PreparedTrial& trial : trials) {
        const TubeTruth truth = tubeTruthIn(*trial.trial);
        if (!quantityOf(trial, "retraction_N") || !quantityOf(trial, "fold_open") || !truth.retractionLow_N ||
            !truth.retractionHigh_N)
            return Measurement::undefined(reasons::kNoSuchTarget);
    }
    return std::nullopt;
}

Measurement measureTensionErrorRms(std::span<const PreparedTrial> trials) {
    if (auto why = withoutTube(trials, "tension_N", &TubeTruth::target_N))
        return *why;
    double squares = 0.0;
    std::size_t samples = 0;
    forEachTensionError(trials, [&](double error_N) {
        squares += error_N * error_N;
        ++samples;
    });
    return samples == 0 ? neverHeld() : Measurement::of(std::sqrt(squares / static_cast<double>(samples)));
}

Measurement measureTensionErrorSd(std::span<const PreparedTrial> trials) {
    if (auto why = withoutTube(trials, "tension_N", &TubeTruth::target_N))
        return *why;
    double squares = 0.0;
    std::size_t samples = 0;
    for (const PreparedTrial& trial : trials) { // about each trial's own mean: its bias is part of the RMS
        const std::span<const PreparedTrial> one(&trial, 1);
        double sum = 0.0;
        std::size_t count = 0;
        forEachTensionError(one, [&](double error_N) {
            sum += error_N;
            ++count;
        });
        if (count == 0)
            continue;
        const double mean = sum / static_cast<double>(count);
        forEachTensionError(one, [&](double error_N) { squares += (error_N - mean) * (error_N - mean); });
        samples += count;
    }
    return samples == 0 ? neverHeld() : Measurement::of(std::sqrt(squares / static_cast<double>(samples)));
}

/// The quantity that is held in this trial (stretch near a mark, or tension near a target) and how near it
/// has to be.
struct Band {
    const std::vector<double>* held = nullptr;
    double middle = 0.0;
    double half = 0.0;
};

std::optional<Band> bandOf(const PreparedTrial& trial) {
    const TubeTruth truth = tubeTruthIn(*trial.trial);
    const bool mark = truth.mark_m.has_value();
    const auto middle = mark ? truth.mark_m : truth.target_N;
    const auto half = mark ? truth.markTolerance_m : truth.band_N;
    const QuantityTrace* held = quantityOf(trial, mark ? "stretch_m" : "tension_N");
    if (!middle || !half || held == nullptr)
        return std::nullopt;
    return Band{&held->values, *middle, *half};
}

/// Sums in whole µs, so that the sum of ticks is exact.
std::int64_t inBand_us(const PreparedTrial& trial, const Band& band) {
    const std::vector<double>& t_s = trial.tool->t_s;
    std::int64_t sum = 0;
    for (const std::size_t i : tubeHold(trial, TubeHolds::last))
        if (i + 1 < t_s.size() && std::abs((*band.held)[i] - band.middle) <= band.half)
            sum += std::llround(t_s[i + 1] * 1e6) - std::llround(t_s[i] * 1e6);
    return sum;
}

Measurement measureTimeInBand(std::span<const PreparedTrial> trials) {
    if (auto why = withoutTube(trials, "tension_N"))
        return *why;
    std::int64_t sum = 0;
    for (const PreparedTrial& trial : trials) {
        const auto band = bandOf(trial);
        if (!band)
            return Measurement::undefined(reasons::kNoSuchTarget);
        sum += inBand_us(trial, *band);
    }
    return Measurement::of(static_cast<double>(sum) / 1e6 / static_cast<double>(trials.size()));
}

Measurement measureRetractionTimeInBand(std::span<const PreparedTrial> trials) {
    if (auto why = withoutFold(trials))
        return *why;
    double shares = 0.0;
    for (const PreparedTrial& trial : trials) {
        const std::vector<double>& pull = quantityOf(trial, "retraction_N")->values;
        const TubeTruth truth = tubeTruthIn(*trial.trial);
        const double low_N = *truth.retractionLow_N, high_N = *truth.retractionHigh_N;
        const std::vector<std::size_t> since = sinceFoldOpened(trial);
        std::size_t within = 0;
        for (const std::size_t i : since)
            within += pull[i] >= low_N && pull[i] <= high_N ? 1 : 0;
        shares += since.empty() ? 0.0 : static_cast<double>(within) / static_cast<double>(since.size());
    }
    return Measurement::of(100.0 * shares / static_cast<double>(trials.size()));
}

Measurement measureRetractionMax(std::span<const PreparedTrial> trials) {
    if (auto why = withoutFold(trials))
        return *why;
    double most_N = 0.0;
    for (const PreparedTrial& trial : trials) {
        const std::vector<double>& pull = quantityOf(trial, "retraction_N")->values;
        for (std::size_t i = 0; i < pull.size(); ++i)
            if (trial.tool->paused[i] == 0)
                most_N = std::max(most_N, pull[i]);
    }
    return Measurement::of(most_N);
}

constexpr double kRearmShare = 0.8; // models.md §6

std::size_t overStretches(const PreparedTrial& trial) {
    const std::vector<double>& stretch = quantityOf(trial, "stretch_m")->values;
    const double limit_m = *tubeTruthIn(*trial.trial).overStretch_m;
    std::size_t count = 0;
    bool armed = true;
    for (std::size_t i = 0; i < stretch.size(); ++i) {
        if (trial.tool->paused[i] != 0)
            continue;
        if (stretch[i] < kRearmShare * limit_m)
            armed = true;
        if (armed && stretch[i] > limit_m) {
            armed = false;
            ++count;
        }
    }
    return count;
}

Measurement measureOverStretches(std::span<const PreparedTrial> trials) {
    if (auto why = withoutTube(trials, "stretch_m", &TubeTruth::overStretch_m))
        return *why;
    std::size_t count = 0;
    for (const PreparedTrial& trial : trials)
        count += overStretches(trial);
    return Measurement::of(static_cast<double>(count));
}

using Step = core::LaparoscopyStep;

bool isHeldStep(double step) {
    return isTubeStep(step, Step::stretch) || isTubeStep(step, Step::hold) ||
           isTubeStep(step, Step::handOver) || isTubeStep(step, Step::carry);
}

Measurement measureDrops(std::span<const PreparedTrial> trials) {
    if (auto why = withoutTube(trials, "grip_1"))
        return *why;
    std::size_t count = 0;
    for (const PreparedTrial& trial : trials) {
        const std::vector<double>& step = quantityOf(trial, "step")->values;
        bool held = false;
        for (std::size_t i = 0; i < step.size(); ++i) {
            const bool counts = trial.tool->paused[i] == 0;
            if (counts && held && (isTubeStep(step[i], Step::grasp) || isTubeStep(step[i], Step::retract)))
                ++count;
            held = counts && isHeldStep(step[i]);
        }
    }
    return Measurement::of(static_cast<double>(count));
}

} // namespace

std::vector<MetricDefinition> tubeMetrics() {
    MetricRows rows;
    rows.add({.id = "tension_error_rms",
              .unit = "N",
              .wrench = MetricWrench::tissue,
              .aggregate = Aggregate::pooled,
              .tools = MetricTools::all,
              .title = QT_TRANSLATE_NOOP("Metrics", "Tension error, root mean square"),
              .meaning =
                  QT_TRANSLATE_NOOP("Metrics", "How far the tension of the tube was from its target while it "
                                               "was held: large differences weigh more than in the mean."),
              .definition = "Root mean square of the tube's tension less its target over the samples of all "
                            "holds of all trials, broken ones too: "
                            "each from when the tension first was in the band to the hold's end, in the band "
                            "or not. A trial that held nothing has "
                            "none.",
              .source = "models.md §6, tube",
              .measure = measureTensionErrorRms});
    rows.add({.id = "tension_error_sd",
              .unit = "N",
              .wrench = MetricWrench::tissue,
              .aggregate = Aggregate::pooled,
              .tools = MetricTools::all,
              .title = QT_TRANSLATE_NOOP("Metrics", "Tension error, standard deviation"),
              .meaning = QT_TRANSLATE_NOOP(
                  "Metrics",
                  "How unsteady the tension of the tube was while it was held, whether on target or not."),
              .definition =
                  "Standard deviation of the tube's tension in all holds of a trial, broken ones too, about "
                  "the trial's own mean, pooled "
                  "over the trials: how unsteady, whatever the target. A trial that held nothing has none.",
              .source = "models.md §6, tube",
              .measure = measureTensionErrorSd});
    rows.add(
        {.id = "time_in_band",
         .unit = "s",
         .direction = Direction::higherIsBetter,
         .wrench = MetricWrench::tissue,
         .tools = MetricTools::all,
         .title = QT_TRANSLATE_NOOP("Metrics", "Time in the band"),
         .meaning = QT_TRANSLATE_NOOP("Metrics", "How long the tension, or the length at the mark, stayed in "
                                                 "its band during the hold; the mean over all trials."),
         .definition = "How long the tension was in its band during the last hold, at most the time it has "
                       "to be held; where the task is a "
                       "mark, how long the stretch was within its tolerance. 0 where nothing was held; the "
                       "mean over the trials.",
         .source = "models.md §6, tube",
         .measure = measureTimeInBand});
    rows.add(
        {.id = "retraction_time_in_band",
         .unit = "%",
         .direction = Direction::higherIsBetter,
         .wrench = MetricWrench::tissue,
         .tools = MetricTools::all,
         .title = QT_TRANSLATE_NOOP("Metrics", "Retraction in the band"),
         .meaning = QT_TRANSLATE_NOOP("Metrics", "How much of the time the pull on the fold of tissue was in "
                                                 "its band, once the fold was held back, in %; the mean over "
                                                 "all trials."),
         .definition = "How much of the time from when the fold was first held back to the trial's end its "
                       "pull was in the level's band, in "
                       "%; 0 where it never was held back; the mean over the trials.",
         .source = "ours: what holds tissue back has to be neither let go of nor torn at",
         .measure = measureRetractionTimeInBand});
    rows.add(
        {.id = "retraction_max",
         .unit = "N",
         .wrench = MetricWrench::tissue,
         .aggregate = Aggregate::pooled,
         .tools = MetricTools::all,
         .title = QT_TRANSLATE_NOOP("Metrics", "Largest retraction"),
         .meaning = QT_TRANSLATE_NOOP("Metrics", "The largest pull on the fold of tissue at any moment."),
         .definition = "The largest pull on the fold that lies over the tube, in all trials.",
         .source = "ours: what is pulled at too hard is bruised or torn",
         .measure = measureRetractionMax});
    rows.add({.id = "over_stretches",
              .unit = "count",
              .aggregate = Aggregate::pooled,
              .tools = MetricTools::all,
              .title = QT_TRANSLATE_NOOP("Metrics", "Over-stretches"),
              .meaning = QT_TRANSLATE_NOOP(
                  "Metrics", "How often the tube was stretched beyond the limit of this level."),
              .definition = "How often the tube was stretched beyond the level's limit, to be counted again "
                            "only from below 80 % of it. A tear is "
                            "one too.",
              .source = "models.md §6, tube",
              .measure = measureOverStretches});
    rows.add({.id = "drops",
              .unit = "count",
              .aggregate = Aggregate::pooled,
              .tools = MetricTools::all,
              .title = QT_TRANSLATE_NOOP("Metrics", "Drops"),
              .meaning = QT_TRANSLATE_NOOP("Metrics",
                                           "How often the tissue was let go of before the task was done."),
              .definition = "How often the tube, once held as the task needs it, was let go of before the "
                            "task was done, so that it had to be "
                            "grasped again. What is let go in a pause does not count.",
              .source = "models.md §2.4, §6",
              .measure = measureDrops});
    return rows.take();
}

} // namespace chiron::scoring
