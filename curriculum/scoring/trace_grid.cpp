// SPDX-License-Identifier: GPL-3.0-or-later
#include "scoring/trace_grid.h"

#include <cmath>
#include <limits>

namespace chiron::scoring {

namespace {

constexpr double kLargestCount = 9.0e15; ///< below 2^53: every count up to here is a double

double onGrid(double value, double perUnit) {
    const double count = std::nearbyint(value * perUnit);
    return std::abs(count) <= kLargestCount ? count / perUnit + 0.0 : value; // + 0.0: no minus zero
}

core::Vec3 onGrid(const core::Vec3& v, double perUnit) {
    return {onGrid(v.x(), perUnit), onGrid(v.y(), perUnit), onGrid(v.z(), perUnit)};
}

bool sameLength(const std::vector<core::Vec3>& v, std::size_t n, bool mayBeEmpty) {
    return v.size() == n || (mayBeEmpty && v.empty());
}

core::Result<ToolTrace> toolOnGrids(const ToolTrace& raw) {
    const std::size_t n = raw.t_s.size();
    if (!sameLength(raw.p_WT_m, n, false) || !sameLength(raw.tissue_N, n, false) ||
        !sameLength(raw.commanded_N, n, true) || !sameLength(raw.measured_N, n, true) ||
        (raw.paused.size() != n && !raw.paused.empty()))
        return core::fail(core::ErrorCode::badInput,
                          "trace: its columns differ in length: expected one value a sample");
    ToolTrace out;
    double last = -std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < n; ++i) {
        const double t = onMicroseconds(raw.t_s[i]);
        if (!(t > last) || !std::isfinite(t) || !raw.p_WT_m[i].allFinite() || !raw.tissue_N[i].allFinite())
            continue;
        last = t;
        out.t_s.push_back(t);
        out.p_WT_m.push_back(onGrid(raw.p_WT_m[i], 1e9));
        out.tissue_N.push_back(onGrid(raw.tissue_N[i], 1e3));
        if (!raw.commanded_N.empty())
            out.commanded_N.push_back(onGrid(raw.commanded_N[i], 1e3));
        if (!raw.measured_N.empty())
            out.measured_N.push_back(onGrid(raw.measured_N[i], 1e3));
        out.paused.push_back(!raw.paused.empty() && raw.paused[i] != 0 ? 1 : 0);
    }
    return out;
}

} // namespace

double onMicroseconds(double t_s) {
    return onGrid(t_s, 1e6);
}
double onNanometres(double x_m) {
    return onGrid(x_m, 1e9);
}
double onMillinewtons(double f_N) {
    return onGrid(f_N, 1e3);
}

core::Result<SessionTrace> onStoredGrids(const SessionTrace& trace) {
    SessionTrace out;
    out.exercise = trace.exercise;
    out.forceLimit_N = onMillinewtons(trace.forceLimit_N);
    for (const TrialTrace& raw : trace.trials) {
        TrialTrace trial;
        trial.trial = raw.trial;
        trial.marked = raw.marked;
        trial.timedOut = raw.timedOut;
        trial.forcesKnown = raw.forcesKnown;
        trial.markInContact = raw.markInContact;
        trial.p_WMark_m = onGrid(raw.p_WMark_m, 1e9);
        if (raw.apex)
            trial.apex = ApexTruth{onNanometres(raw.apex->x_m), onNanometres(raw.apex->y_m),
                                   onNanometres(raw.apex->radius_m)};
        for (const ToolTrace& tool : raw.tools) {
            auto onGrids = toolOnGrids(tool);
            if (!onGrids)
                return tl::unexpected(onGrids.error());
            trial.tools.push_back(std::move(*onGrids));
        }
        out.trials.push_back(std::move(trial));
    }
    return out;
}

} // namespace chiron::scoring
