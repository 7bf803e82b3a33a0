// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/units.h"
#include "scoring/metric.h"
#include "scoring/prepared_trial.h"

namespace chiron::scoring {

namespace {

Measurement measurePathLength(std::span<const PreparedTrial> trials) {
    double length_m = 0.0;
    bool any = false;
    for (const PreparedTrial& trial : trials)
        for (const MotionRun& run : trial.motion.runs)
            for (std::size_t i = 0; i + 1 < run.p_WT_m.size(); ++i) {
                length_m += (run.p_WT_m[i + 1] - run.p_WT_m[i]).norm();
                any = true;
            }
    return any ? Measurement::of(core::mmFromM(length_m))
               : Measurement::undefined(UndefinedReason::tooFewPositions);
}

} // namespace

MetricDefinition pathLengthMetric() {
    return {.id = "path_length",
            .version = 1,
            .unit = "mm",
            .direction = Direction::lowerIsBetter,
            .wrench = MetricWrench::none,
            .aggregate = Aggregate::sum,
            .tools = MetricTools::first,
            .definition = "Sum of |dp| of the tool tip, low-passed at 20 Hz and at 100 Hz.",
            .source = "models.md §6",
            .measure = measurePathLength};
}

} // namespace chiron::scoring
