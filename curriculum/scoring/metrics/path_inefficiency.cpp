// SPDX-License-Identifier: GPL-3.0-or-later
#include "scoring/metric.h"
#include "scoring/prepared_trial.h"

namespace chiron::scoring {

namespace {

Measurement measurePathInefficiency(std::span<const PreparedTrial> trials) {
    constexpr double kShortest_m = 0.005; // models.md §6: below, the ratio says nothing
    double sum_percent = 0.0;
    int counted = 0;
    for (const PreparedTrial& trial : trials) {
        double length_m = 0.0;
        core::Vec3 displacement_m =
            core::Vec3::Zero(); // run by run: what happens in a pause is no one's path
        for (const MotionRun& run : trial.motion.runs) {
            displacement_m += run.p_WT_m.back() - run.p_WT_m.front();
            for (std::size_t i = 0; i + 1 < run.p_WT_m.size(); ++i)
                length_m += (run.p_WT_m[i + 1] - run.p_WT_m[i]).norm();
        }
        if (displacement_m.norm() < kShortest_m)
            continue;
        sum_percent += 100.0 * (length_m / displacement_m.norm() - 1.0);
        ++counted;
    }
    return counted > 0 ? Measurement::of(sum_percent / counted)
                       : Measurement::undefined("start and end are less than 5 mm apart");
}

} // namespace

MetricDefinition pathInefficiencyMetric() {
    return {.id = "path_inefficiency",
            .version = 1,
            .unit = "%",
            .direction = Direction::lowerIsBetter,
            .wrench = MetricWrench::none,
            .aggregate = Aggregate::mean,
            .tools = MetricTools::first,
            .definition =
                "100 (L/D - 1), D the straight distance between the trial's ends; the mean over the trials "
                "where D is at least 5 mm.",
            .source = "models.md §6",
            .measure = measurePathInefficiency};
}

} // namespace chiron::scoring
