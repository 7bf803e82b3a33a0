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

bool isFinite(const std::vector<QuantityTrace>& quantities, std::size_t i) {
    return std::all_of(quantities.begin(), quantities.end(),
                       [i](const auto& q) { return std::isfinite(q.values[i]); });
}

bool fits(const std::vector<QuantityTrace>& quantities, std::size_t n) {
    return std::all_of(quantities.begin(), quantities.end(),
                       [n](const auto& q) { return q.values.size() == n; });
}

/// Returns the indices of the samples that are kept; `own` and `quantities` belong to tool 0.
std::vector<std::size_t> keptSamples(const ToolTrace& raw, const OwnTrace* own,
                                     const std::vector<QuantityTrace>& quantities) {
    std::vector<std::size_t> kept;
    double last = -std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < raw.t_s.size(); ++i) {
        const double t = onMicroseconds(raw.t_s[i]);
        const bool finite = std::isfinite(t) && raw.p_WT_m[i].allFinite() && raw.tissue_N[i].allFinite() &&
                            (raw.q_WT.empty() || raw.q_WT[i].coeffs().allFinite()) &&
                            (raw.tissueTorque_Nm.empty() || raw.tissueTorque_Nm[i].allFinite()) &&
                            (own == nullptr || own->finiteAt(i)) && isFinite(quantities, i);
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
    if (raw.target)
        trial.target = TargetTruth{onNanometres(raw.target->x_m), onNanometres(raw.target->y_m),
                                   onNanometres(raw.target->radius_m)};
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
        const OwnTrace* own = i == 0 ? raw.own.get() : nullptr;
        const auto& quantities = i == 0 ? raw.quantities : kNone;
        if (!fits(tool) || (own != nullptr && !own->fits(tool.t_s.size())) ||
            !fits(quantities, tool.t_s.size()))
            return unequal();
        const std::vector<std::size_t> kept = keptSamples(tool, own, quantities);
        trial.tools.push_back(toolOnGrids(tool, kept));
        if (own != nullptr) {
            auto onGrids = own->onGrids(kept, trial.tools.back().t_s);
            CHIRON_TRY(onGrids);
            trial.own = std::move(*onGrids);
        }
        if (i == 0)
            trial.quantities = keptOf(quantities, kept);
    }
    if ((raw.own || !raw.quantities.empty()) && raw.tools.empty())
        return unequal();
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
