// SPDX-License-Identifier: GPL-3.0-or-later
#include "scoring/trace_grid.h"

#include "core/units.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace chiron::scoring {

namespace {

constexpr double kLargestCount = 9.0e15; ///< below 2^53: every integer up to here is exact in a double
constexpr double kPerNm = 1e5;           ///< 0.01 mN·m, the recorded resolution

double onGrid(double value, double perUnit) {
    const double count = std::nearbyint(value * perUnit);
    return std::abs(count) <= kLargestCount ? count / perUnit + 0.0 : value; // + 0.0: no minus zero
}

core::Vec3 onGrid(const core::Vec3& v, double perUnit) {
    return {onGrid(v.x(), perUnit), onGrid(v.y(), perUnit), onGrid(v.z(), perUnit)};
}

template <class T> bool sameLength(const std::vector<T>& v, std::size_t n, bool mayBeEmpty) {
    return v.size() == n || (mayBeEmpty && v.empty());
}

bool fits(const ToolTrace& raw) {
    const std::size_t n = raw.t_s.size();
    return sameLength(raw.p_WT_m, n, false) && sameLength(raw.tissue_N, n, false) &&
           sameLength(raw.commanded_N, n, true) && sameLength(raw.measured_N, n, true) &&
           sameLength(raw.paused, n, true) && sameLength(raw.contact, n, true) &&
           sameLength(raw.q_WT, n, true) && sameLength(raw.tissueTorque_Nm, n, true);
}

bool fits(const InsertionSeries& raw, std::size_t n) {
    return raw.s_m.size() == n && raw.offset_m.size() == n && raw.alignment_rad.size() == n &&
           raw.lateral_N.size() == n && raw.axialTorque_Nm.size() == n && raw.stage.size() == n;
}

bool isFinite(const InsertionSeries& raw, std::size_t i) {
    return std::isfinite(raw.s_m[i]) && std::isfinite(raw.offset_m[i]) &&
           std::isfinite(raw.alignment_rad[i]) && std::isfinite(raw.lateral_N[i]) &&
           std::isfinite(raw.axialTorque_Nm[i]);
}

bool isFinite(const std::vector<QuantityTrace>& quantities, std::size_t i) {
    return std::all_of(quantities.begin(), quantities.end(),
                       [i](const auto& q) { return std::isfinite(q.values[i]); });
}

bool fits(const std::vector<QuantityTrace>& quantities, std::size_t n) {
    return std::all_of(quantities.begin(), quantities.end(),
                       [n](const auto& q) { return q.values.size() == n; });
}

/// Returns the indices of the samples that are kept; `series` and `quantities` belong to tool 0.
std::vector<std::size_t> keptSamples(const ToolTrace& raw, const InsertionSeries* series,
                                     const std::vector<QuantityTrace>& quantities) {
    std::vector<std::size_t> kept;
    double last = -std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < raw.t_s.size(); ++i) {
        const double t = onMicroseconds(raw.t_s[i]);
        const bool finite = std::isfinite(t) && raw.p_WT_m[i].allFinite() && raw.tissue_N[i].allFinite() &&
                            (raw.q_WT.empty() || raw.q_WT[i].coeffs().allFinite()) &&
                            (raw.tissueTorque_Nm.empty() || raw.tissueTorque_Nm[i].allFinite()) &&
                            (series == nullptr || isFinite(*series, i)) && isFinite(quantities, i);
        if (!finite || !(t > last))
            continue;
        last = t;
        kept.push_back(i);
    }
    return kept;
}

ToolTrace toolOnGrids(const ToolTrace& raw, const std::vector<std::size_t>& kept) {
    ToolTrace out;
    for (const std::size_t i : kept) {
        out.t_s.push_back(onMicroseconds(raw.t_s[i]));
        out.p_WT_m.push_back(onGrid(raw.p_WT_m[i], 1e9));
        out.tissue_N.push_back(onGrid(raw.tissue_N[i], 1e3));
        if (!raw.commanded_N.empty())
            out.commanded_N.push_back(onGrid(raw.commanded_N[i], 1e3));
        if (!raw.measured_N.empty())
            out.measured_N.push_back(onGrid(raw.measured_N[i], 1e3));
        out.paused.push_back(!raw.paused.empty() && raw.paused[i] != 0 ? 1 : 0);
        if (!raw.contact.empty())
            out.contact.push_back(raw.contact[i]);
        if (!raw.q_WT.empty())
            out.q_WT.push_back(raw.q_WT[i]); // not rounded: a file contains all digits
        if (!raw.tissueTorque_Nm.empty())
            out.tissueTorque_Nm.push_back(onGrid(raw.tissueTorque_Nm[i], kPerNm));
    }
    return out;
}

double seenOnGrid(double seen_s, const std::vector<double>& t_s) {
    const auto first = std::lower_bound(t_s.begin(), t_s.end(), onMicroseconds(seen_s));
    const bool seen = std::isfinite(seen_s) && first != t_s.end();
    return seen ? *first : std::numeric_limits<double>::quiet_NaN();
}

InsertionSeries insertionOnGrids(const InsertionSeries& raw, const std::vector<std::size_t>& kept,
                                 const std::vector<double>& t_s) {
    InsertionSeries out;
    for (const std::size_t i : kept) {
        out.s_m.push_back(onNanometres(raw.s_m[i]));
        out.offset_m.push_back(onNanometres(raw.offset_m[i]));
        out.alignment_rad.push_back(onMicrodegrees(raw.alignment_rad[i]));
        out.lateral_N.push_back(onMillinewtons(raw.lateral_N[i]));
        out.axialTorque_Nm.push_back(onTorqueGrid(raw.axialTorque_Nm[i]));
        out.stage.push_back(raw.stage[i]);
    }
    out.length_m = onNanometres(raw.length_m);
    out.bend_m = onNanometres(raw.bend_m);
    out.goal_m = onNanometres(raw.goal_m);
    out.lateralLimit_N = onMillinewtons(raw.lateralLimit_N);
    for (const double seen_s : raw.landmarkSeen_s)
        out.landmarkSeen_s.push_back(seenOnGrid(seen_s, t_s));
    return out;
}

/// Returns the kept values without rounding: a recording rounds each quantity to its own resolution, and a
/// file contains all digits.
std::vector<QuantityTrace> keptOf(const std::vector<QuantityTrace>& raw,
                                  const std::vector<std::size_t>& kept) {
    std::vector<QuantityTrace> out;
    for (const QuantityTrace& quantity : raw) {
        out.push_back({quantity.id, {}});
        for (const std::size_t i : kept)
            out.back().values.push_back(quantity.values[i] + 0.0); // + 0.0 removes a minus zero, which a file
                                                                   // cannot have
    }
    return out;
}

TrialTrace endingOnGrids(const TrialTrace& raw) {
    TrialTrace trial;
    trial.trial = raw.trial;
    trial.marked = raw.marked;
    trial.timedOut = raw.timedOut;
    trial.completed = raw.completed;
    trial.failed = raw.failed;
    trial.unfinished = raw.unfinished;
    trial.truth = raw.truth;
    trial.forcesKnown = raw.forcesKnown;
    trial.markInContact = raw.markInContact;
    trial.p_WMark_m = onGrid(raw.p_WMark_m, 1e9);
    if (raw.apex)
        trial.apex = ApexTruth{onNanometres(raw.apex->x_m), onNanometres(raw.apex->y_m),
                               onNanometres(raw.apex->radius_m)};
    return trial;
}

core::Result<TrialTrace> trialOnGrids(const TrialTrace& raw) {
    static const std::vector<QuantityTrace> kNone;
    const auto unequal = [] {
        return core::fail(core::ErrorCode::badInput,
                          "trace: its columns differ in length: expected one value a sample");
    };
    TrialTrace trial = endingOnGrids(raw);
    for (std::size_t i = 0; i < raw.tools.size(); ++i) {
        const ToolTrace& tool = raw.tools[i];
        const InsertionSeries* series = i == 0 && raw.insertion ? &*raw.insertion : nullptr;
        const auto& quantities = i == 0 ? raw.quantities : kNone;
        if (!fits(tool) || (series != nullptr && !fits(*series, tool.t_s.size())) ||
            !fits(quantities, tool.t_s.size()))
            return unequal();
        const std::vector<std::size_t> kept = keptSamples(tool, series, quantities);
        trial.tools.push_back(toolOnGrids(tool, kept));
        if (series != nullptr)
            trial.insertion = insertionOnGrids(*series, kept, trial.tools.back().t_s);
        if (i == 0)
            trial.quantities = keptOf(quantities, kept);
    }
    if ((raw.insertion || !raw.quantities.empty()) && raw.tools.empty())
        return unequal();
    if (raw.insertion && raw.insertion->landmarkSeen_s.size() > kMostLandmarks)
        return core::fail(core::ErrorCode::badInput,
                          "trace: more than 32 landmarks: expected what a trace file can hold");
    return trial;
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

double onTorqueGrid(double torque_Nm) {
    return onGrid(torque_Nm, kPerNm);
}
double onMicrodegrees(double angle_rad) {
    return core::radFromDeg(onGrid(core::degFromRad(angle_rad), 1e6));
}

core::Result<SessionTrace> onStoredGrids(const SessionTrace& trace) {
    SessionTrace out;
    out.exercise = trace.exercise;
    out.forceLimit_N = onMillinewtons(trace.forceLimit_N);
    out.plannedTrials = trace.plannedTrials;
    for (const TrialTrace& raw : trace.trials) {
        auto trial = trialOnGrids(raw);
        CHIRON_TRY(trial);
        out.trials.push_back(std::move(*trial));
    }
    return out;
}

} // namespace chiron::scoring
