// SPDX-License-Identifier: GPL-3.0-or-later
#include "scoring/metrics/handling_samples.h"

namespace chiron::scoring {

namespace {

Measurement measureSqueezeTimeOverLimit(std::span<const PreparedTrial> trials) {
    if (trials.empty())
        return Measurement::undefined(UndefinedReason::noTrials);
    double time_s = 0.0;
    for (const PreparedTrial& trial : trials) {
        const QuantityTrace* squeeze = quantityOf(trial, "squeeze_N");
        if (squeeze == nullptr)
            return Measurement::undefined(UndefinedReason::noSqueeze);
        const auto limit_N = truthOf(trial, "squeeze_limit_N");
        if (!limit_N)
            return Measurement::undefined(UndefinedReason::noSqueezeLimit);
        const std::vector<double>& t_s = trial.tool->t_s;
        for (std::size_t i = 0; i + 1 < t_s.size(); ++i)
            if (trial.tool->paused[i] == 0 && squeeze->values[i] > *limit_N)
                time_s += t_s[i + 1] - t_s[i];
    }
    return Measurement::of(time_s);
}

} // namespace

MetricDefinition squeezeTimeOverLimitMetric() {
    return {.id = "squeeze_time_over_limit",
            .version = 1,
            .unit = "s",
            .direction = Direction::lowerIsBetter,
            .wrench = MetricWrench::none,
            .aggregate = Aggregate::pooled,
            .tools = MetricTools::first,
            .definition =
                "Time for which the grip force of a jaw was over the level's squeeze limit, each sample held until the next.",
            .source = "models.md §2.2, §6",
            .measure = measureSqueezeTimeOverLimit};
}

} // namespace chiron::scoring
