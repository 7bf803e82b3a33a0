// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/random.h"
#include "traces.h"

#include <algorithm>
#include <vector>

namespace traces {

/// Three trials of two tools with unrounded doubles, a pause and packets read twice.
inline SessionTrace busySession() {
    chiron::core::Random random(21);
    SessionTrace trace;
    trace.exercise = "sphere_apex";
    trace.forceLimit_N = 1.5;
    for (int k = 0; k < 3; ++k) {
        TrialTrace trial;
        trial.trial = k;
        for (int toolIndex = 0; toolIndex < 2; ++toolIndex) {
            ToolTrace tool = sampled(
                3.0, 0.001,
                [&](double t) {
                    return Vec3(0.03 * std::sin(3 * t + k), 0.02 * std::cos(2 * t),
                                0.01 + 1e-5 * random.normal());
                },
                [&](double t) {
                    return Vec3(0.1 * random.normal(), 0.0, std::max(0.0, 2.0 * std::sin(4.0 * t)));
                });
            for (double& t : tool.t_s)
                t += 5.0 * k + 1e-8 * random.normal();
            for (std::size_t i = 1500; i < 1700; ++i)
                tool.paused[i] = 1;
            tool.t_s[40] = tool.t_s[39];
            tool.commanded_N = tool.tissue_N;
            trial.tools.push_back(std::move(tool));
        }
        trial.marked = k != 2;
        trial.timedOut = k == 2;
        trial.markInContact = true;
        trial.p_WMark_m = trial.tools[0].p_WT_m.back();
        trial.target = chiron::scoring::TargetTruth{0.03 * random.uniform(), -0.03 * random.uniform(), 0.020};
        trace.trials.push_back(std::move(trial));
    }
    return trace;
}

/// Of every metric of the catalogue, its newest version.
inline std::vector<chiron::scoring::MetricRequest> everyMetric() {
    std::vector<chiron::scoring::MetricRequest> all;
    for (const chiron::scoring::MetricDefinition& metric : chiron::scoring::metricCatalogue())
        all.push_back({std::string(metric.id), metric.version});
    return all;
}

} // namespace traces
