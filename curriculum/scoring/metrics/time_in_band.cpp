// SPDX-License-Identifier: GPL-3.0-or-later
#include "scoring/metrics/tube_samples.h"

#include <cmath>
#include <cstdint>

namespace chiron::scoring {

namespace {

/// Stretch about a mark, or tension about a target: what is held, and how near it has to be.
struct Band {
    const std::vector<double>* held = nullptr;
    double middle = 0.0;
    double half = 0.0;
};

std::optional<Band> bandOf(const PreparedTrial& trial) {
    const bool mark = tubeTruth(trial, "mark_m").has_value();
    const auto middle = tubeTruth(trial, mark ? "mark_m" : "target_N");
    const auto half = tubeTruth(trial, mark ? "mark_tolerance_m" : "band_N");
    const std::vector<double>* held = tubeQuantity(trial, mark ? "stretch_m" : "tension_N");
    if (!middle || !half || held == nullptr)
        return std::nullopt;
    return Band{held, *middle, *half};
}

/// In whole µs: a sum of ticks is a sum of ticks.
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
            return Measurement::undefined(UndefinedReason::noSuchTarget);
        sum += inBand_us(trial, *band);
    }
    return Measurement::of(static_cast<double>(sum) / 1e6 / static_cast<double>(trials.size()));
}

} // namespace

MetricDefinition timeInBandMetric() {
    return {.id = "time_in_band",
            .version = 1,
            .unit = "s",
            .direction = Direction::higherIsBetter,
            .wrench = MetricWrench::tissue,
            .aggregate = Aggregate::mean,
            .tools = MetricTools::all,
            .definition = "How long the tension was in its band during the last hold, at most the time it has to be held; where the task is a "
                          "mark, how long the stretch was within its tolerance. 0 where nothing was held; the mean over the trials.",
            .source = "models.md §6, tube",
            .measure = measureTimeInBand};
}

} // namespace chiron::scoring
