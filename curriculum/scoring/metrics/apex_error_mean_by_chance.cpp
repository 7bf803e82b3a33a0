// SPDX-License-Identifier: GPL-3.0-or-later
#include "scoring/metrics/apex_answer.h"

#include "scoring/median.h"

#include <cmath>

namespace chiron::scoring {

namespace {

/// The median of the true places is the answer that is best if it is always the same.
Measurement measureApexErrorMeanByChance(std::span<const PreparedTrial> trials) {
    if (trials.empty())
        return Measurement::undefined(UndefinedReason::noTrials);
    std::vector<double> x_m, y_m;
    for (const PreparedTrial& trial : trials) {
        if (!trial.trial->apex || !(trial.trial->apex->radius_m > 0.0))
            return Measurement::undefined(UndefinedReason::apexUnknown);
        x_m.push_back(trial.trial->apex->x_m);
        y_m.push_back(trial.trial->apex->y_m);
    }
    if (trials.size() < 2)
        return Measurement::undefined(UndefinedReason::oneTrialHasNoChance);
    const double bestX_m = median(x_m), bestY_m = median(y_m);
    double sum = 0.0;
    for (const PreparedTrial& trial : trials) {
        const ApexTruth& truth = *trial.trial->apex;
        sum += (std::abs(truth.x_m - bestX_m) + std::abs(truth.y_m - bestY_m)) / truth.radius_m;
    }
    return Measurement::of(100.0 * sum / (2.0 * static_cast<double>(trials.size())));
}

} // namespace

MetricDefinition apexErrorMeanByChanceMetric() {
    return {.id = "apex_error_mean_by_chance",
            .version = 1,
            .unit = "% of R",
            .direction = Direction::neutral,
            .wrench = MetricWrench::none,
            .aggregate = Aggregate::pooled,
            .tools = MetricTools::first,
            .definition = "apex_error_mean of one who always marks the same place, the best for this session (the median of the apexes): what feeling "
                          "nothing gives.",
            .source = "our definition",
            .measure = measureApexErrorMeanByChance};
}

} // namespace chiron::scoring
