// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scoring/metric_catalogue.h"
#include "scoring/score_calculator.h"
#include "scoring/trace.h"
#include "scoring/trace_grid.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

/// Traces made from formulas, for the scoring tests.
namespace traces {

using chiron::core::Vec3;
using chiron::scoring::SessionTrace;
using chiron::scoring::ToolTrace;
using chiron::scoring::TrialTrace;

/// Samples at 0, step, 2 step ... up to and including `duration_s`; position (m) and force (N) as functions
/// of time.
inline ToolTrace sampled(
    double duration_s, double step_s, const std::function<Vec3(double)>& position,
    const std::function<Vec3(double)>& force = [](double) { return Vec3::Zero().eval(); }) {
    ToolTrace tool;
    const int n = static_cast<int>(std::lround(duration_s / step_s));
    for (int i = 0; i <= n; ++i) {
        const double t = i * step_s;
        tool.t_s.push_back(t);
        tool.p_WT_m.push_back(position(t));
        tool.tissue_N.push_back(force(t));
        tool.paused.push_back(0);
    }
    return tool;
}

inline SessionTrace session(std::vector<ToolTrace> trials) {
    SessionTrace trace;
    trace.exercise = "sphere_apex";
    for (ToolTrace& tool : trials) {
        TrialTrace trial;
        trial.trial = static_cast<int>(trace.trials.size());
        trial.tools.push_back(std::move(tool));
        trace.trials.push_back(std::move(trial));
    }
    return trace;
}

inline SessionTrace session(ToolTrace tool) {
    std::vector<ToolTrace> one;
    one.push_back(std::move(tool));
    return session(std::move(one));
}

/// Version 0: the newest.
inline chiron::scoring::MetricValue metricOf(const SessionTrace& trace, const std::string& id,
                                             int version = 0) {
    const chiron::scoring::MetricRequest request{id, version};
    const auto card = chiron::scoring::calculateScore(trace, {&request, 1}, {}, true);
    return card ? card->metrics.front()
                : chiron::scoring::MetricValue{id, 0, {}, {}, card.error().message, {}};
}

inline double valueOf(const SessionTrace& trace, const std::string& id, int version = 0) {
    return metricOf(trace, id, version).value.value_or(std::nan(""));
}

/// 3 s at rest, then a minimum-jerk reach of `distance_m` along `direction` in 1 s, then 1 s at rest
/// (Flash & Hogan 1985: s = 10τ³ − 15τ⁴ + 6τ⁵).
inline Vec3 reach(double t, double distance_m, const Vec3& direction) {
    const double x = std::min(1.0, std::max(0.0, t - 3.0));
    return direction * distance_m * (x * x * x * (10.0 + x * (-15.0 + 6.0 * x)));
}

} // namespace traces
