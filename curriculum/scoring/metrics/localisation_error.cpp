// SPDX-License-Identifier: GPL-3.0-or-later
#include "scoring/metrics/palpation_samples.h"

#include "scoring/detection/finding_errors.h"

namespace chiron::scoring {

namespace {

Measurement measureLocalisationError(std::span<const PreparedTrial> trials) {
    const auto [answers, undefined] = judged(trials);
    if (undefined)
        return *undefined;
    ErrorSum all;
    for (const PalpationAnswer& answer : answers) {
        const ErrorSum errors = localisationErrors(answer.matches);
        all.sum += errors.sum;
        all.count += errors.count;
    }
    return all.count > 0 ? Measurement::of(1e3 * all.sum / all.count) : Measurement::undefined(UndefinedReason::noLumpFound);
}

} // namespace

MetricDefinition localisationErrorMetric() {
    return {.id = "localisation_error",
            .version = 1,
            .unit = "mm",
            .direction = Direction::lowerIsBetter,
            .wrench = MetricWrench::none,
            .aggregate = Aggregate::pooled,
            .tools = MetricTools::first,
            .definition = "Distance of a finding from the place on the surface above the lump that it found, straight; the mean "
                          "over all hits.",
            .source = "models.md §6",
            .measure = measureLocalisationError};
}

} // namespace chiron::scoring
