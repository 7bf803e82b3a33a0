// SPDX-License-Identifier: GPL-3.0-or-later
#include "scoring/trace_builder.h"

#include <algorithm>

namespace chiron::scoring {

namespace {

TraceColumns columnsOf(const SessionTrace& trace) {
    TraceColumns columns;
    columns.tool = columns.tissue = columns.trial = columns.paused = columns.mark = columns.forceLimit = true;
    columns.target = columns.insertion = !trace.trials.empty();
    for (const TrialTrace& trial : trace.trials) {
        columns.target = columns.target && trial.apex.has_value();
        columns.insertion = columns.insertion && trial.insertion.has_value();
        for (const ToolTrace& tool : trial.tools) {
            columns.commanded = columns.commanded || !tool.commanded_N.empty();
            columns.measured = columns.measured || !tool.measured_N.empty();
            columns.orientation = columns.orientation || !tool.q_WT.empty();
            columns.torque = columns.torque || !tool.tissueTorque_Nm.empty();
        }
    }
    return columns;
}

TraceRow trialRow(const SessionTrace& trace, const TrialTrace& trial) {
    TraceRow row;
    row.trial = trial.trial;
    row.marked = trial.marked;
    row.timedOut = trial.timedOut;
    row.markInContact = trial.markInContact;
    row.p_WMark_m = trial.p_WMark_m;
    if (trial.apex) {
        row.target_m = core::Vec3(trial.apex->x_m, trial.apex->y_m, 0.0);
        row.targetRadius_m = trial.apex->radius_m;
    }
    row.forceLimit_N = trace.forceLimit_N;
    if (trial.insertion)
        setTrialOfCanal(row.insertion, trial);
    return row;
}

TraceRow sampleRow(const TraceRow& ofTrial, const ToolTrace& samples, std::size_t i) {
    TraceRow row = ofTrial;
    row.t_s = samples.t_s[i];
    row.p_WT_m = samples.p_WT_m[i];
    row.tissue_N = samples.tissue_N[i];
    row.commanded_N = samples.commanded_N.empty() ? core::Vec3::Zero().eval() : samples.commanded_N[i];
    row.measured_N = samples.measured_N.empty() ? core::Vec3::Zero().eval() : samples.measured_N[i];
    row.paused = !samples.paused.empty() && samples.paused[i] != 0;
    if (!samples.q_WT.empty())
        row.q_WT = samples.q_WT[i];
    if (!samples.tissueTorque_Nm.empty())
        row.tissueTorque_Nm = samples.tissueTorque_Nm[i];
    return row;
}

} // namespace

TraceRows rowsOf(const SessionTrace& trace) {
    TraceRows out;
    out.columns = columnsOf(trace);
    for (const TrialTrace& trial : trace.trials) {
        const TraceRow ofTrial = trialRow(trace, trial);
        const auto first = static_cast<std::ptrdiff_t>(out.rows.size());
        for (std::size_t tool = 0; tool < trial.tools.size(); ++tool) {
            const ToolTrace& samples = trial.tools[tool];
            for (std::size_t i = 0; i < samples.t_s.size(); ++i) {
                TraceRow row = sampleRow(ofTrial, samples, i);
                row.tool = static_cast<std::uint8_t>(tool);
                if (tool == 0 && trial.insertion)
                    setSampleOfCanal(row.insertion, *trial.insertion, i, row.t_s);
                out.rows.push_back(row);
            }
        }
        std::stable_sort(out.rows.begin() + first, out.rows.end(),
                         [](const TraceRow& a, const TraceRow& b) { return a.t_s < b.t_s; });
    }
    return out;
}

} // namespace chiron::scoring
