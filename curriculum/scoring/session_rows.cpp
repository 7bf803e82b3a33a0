// SPDX-License-Identifier: GPL-3.0-or-later
#include "scoring/trace_builder.h"

#include <algorithm>
#include <limits>

namespace chiron::scoring {

namespace {

TraceColumns columnsOf(const SessionTrace& trace) {
    TraceColumns columns;
    columns.tool = columns.tissue = columns.trial = columns.paused = columns.mark = columns.forceLimit = true;
    columns.target = !trace.trials.empty();
    columns.own =
        trace.trials.empty() || !trace.trials.front().own ? nullptr : &trace.trials.front().own->columns();
    for (const TrialTrace& trial : trace.trials) {
        columns.target = columns.target && trial.target.has_value();
        if (columns.own != nullptr && (!trial.own || &trial.own->columns() != columns.own))
            columns.own = nullptr;
        for (const ToolTrace& tool : trial.tools) {
            columns.commanded = columns.commanded || !tool.commanded_N.empty();
            columns.measured = columns.measured || !tool.measured_N.empty();
            columns.orientation = columns.orientation || !tool.q_WT.empty();
            columns.contact = columns.contact || !tool.contact.empty();
            columns.torque = columns.torque || !tool.tissueTorque_Nm.empty();
        }
        columns.failed = columns.failed || trial.failed;
        columns.unfinished = columns.unfinished || trial.unfinished;
        columns.completed = columns.completed || trial.completed;
    }
    if (columns.own != nullptr && columns.own->required != nullptr)
        columns.*columns.own->required = true;
    columns.planned = trace.plannedTrials > 0;
    columns.truth = truthIdsOf(trace.trials);
    if (!trace.trials.empty())
        for (const QuantityTrace& quantity : trace.trials.front().quantities)
            columns.quantities.push_back(quantity.id);
    return columns;
}

TraceRow trialRow(const SessionTrace& trace, const TrialTrace& trial, const TraceColumns& columns) {
    TraceRow row;
    row.trial = trial.trial;
    row.completed = trial.completed;
    row.failed = trial.failed;
    row.unfinished = trial.unfinished;
    row.plannedTrials = trace.plannedTrials;
    row.truth = truthOf(trial, columns.truth);
    row.marked = trial.marked;
    row.timedOut = trial.timedOut;
    row.markInContact = trial.markInContact;
    row.p_WMark_m = trial.p_WMark_m;
    row.forceLimit_N = trace.forceLimit_N;
    setTrial(row, trial, columns);
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
    row.contact = samples.contact.empty() ? std::uint8_t{0} : samples.contact[i];
    if (!samples.q_WT.empty())
        row.q_WT = samples.q_WT[i];
    if (!samples.tissueTorque_Nm.empty())
        row.tissueTorque_Nm = samples.tissueTorque_Nm[i];
    return row;
}

} // namespace

std::vector<std::string> truthIdsOf(const std::vector<TrialTrace>& trials) {
    std::vector<std::string> ids;
    for (const TrialTrace& trial : trials)
        for (const NamedValue& value : trial.truth)
            if (std::find(ids.begin(), ids.end(), value.id) == ids.end())
                ids.push_back(value.id);
    return ids;
}

std::vector<double> truthOf(const TrialTrace& trial, const std::vector<std::string>& ids) {
    std::vector<double> values;
    for (const std::string& id : ids) {
        const auto found =
            std::find_if(trial.truth.begin(), trial.truth.end(), [&id](const auto& v) { return v.id == id; });
        values.push_back(found == trial.truth.end() ? std::numeric_limits<double>::quiet_NaN()
                                                    : found->value);
    }
    return values;
}

void setTrial(TraceRow& row, const TrialTrace& trial, const TraceColumns& columns) {
    if (trial.target) {
        row.target_m = core::Vec3(trial.target->x_m, trial.target->y_m, 0.0);
        row.targetRadius_m = trial.target->radius_m;
    }
    if (columns.own == nullptr)
        return;
    row.own.assign(columns.own->columns.size(), 0.0);
    if (trial.own && &trial.own->columns() == columns.own)
        trial.own->fillTrial(row.own);
}

void setSample(TraceRow& row, const TrialTrace& trial, std::size_t i, double t_s) {
    if (trial.own && row.own.size() == trial.own->columns().columns.size())
        trial.own->fillSample(row.own, i, t_s);
}

TraceRows rowsOf(const SessionTrace& trace) {
    TraceRows out;
    out.columns = columnsOf(trace);
    for (const TrialTrace& trial : trace.trials) {
        const TraceRow ofTrial = trialRow(trace, trial, out.columns);
        const auto first = static_cast<std::ptrdiff_t>(out.rows.size());
        for (std::size_t tool = 0; tool < trial.tools.size(); ++tool) {
            const ToolTrace& samples = trial.tools[tool];
            for (std::size_t i = 0; i < samples.t_s.size(); ++i) {
                TraceRow row = sampleRow(ofTrial, samples, i);
                row.tool = static_cast<std::uint8_t>(tool);
                if (tool == 0)
                    setSample(row, trial, i, row.t_s);
                for (const QuantityTrace& quantity : trial.quantities)
                    if (tool == 0)
                        row.quantities.push_back(quantity.values[i]);
                out.rows.push_back(row);
            }
        }
        std::stable_sort(out.rows.begin() + first, out.rows.end(),
                         [](const TraceRow& a, const TraceRow& b) { return a.t_s < b.t_s; });
    }
    return out;
}

} // namespace chiron::scoring
