// SPDX-License-Identifier: GPL-3.0-or-later
#include "scoring/metrics/retraction_samples.h"

namespace chiron::scoring {

namespace {

Measurement measureRetractionTimeInBand(std::span<const PreparedTrial> trials) {
    if (auto why = withoutFold(trials))
        return *why;
    double shares = 0.0;
    for (const PreparedTrial& trial : trials) {
        const std::vector<double>& pull = *tubeQuantity(trial, "retraction_N");
        const double low_N = *tubeTruth(trial, "retraction_low_N"), high_N = *tubeTruth(trial, "retraction_high_N");
        const std::vector<std::size_t> since = sinceFoldOpened(trial);
        std::size_t within = 0;
        for (const std::size_t i : since)
            within += pull[i] >= low_N && pull[i] <= high_N ? 1 : 0;
        shares += since.empty() ? 0.0 : static_cast<double>(within) / static_cast<double>(since.size());
    }
    return Measurement::of(100.0 * shares / static_cast<double>(trials.size()));
}

} // namespace

MetricDefinition retractionTimeInBandMetric() {
    return {.id = "retraction_time_in_band",
            .version = 1,
            .unit = "%",
            .direction = Direction::higherIsBetter,
            .wrench = MetricWrench::tissue,
            .aggregate = Aggregate::mean,
            .tools = MetricTools::all,
            .definition = "How much of the time from when the fold was first held back to the trial's end its pull was in the level's band, in %; 0 where "
                          "it never was held back; the mean over the trials.",
            .source = "ours: what holds tissue back has to be neither let go of nor torn at",
            .measure = measureRetractionTimeInBand};
}

} // namespace chiron::scoring
