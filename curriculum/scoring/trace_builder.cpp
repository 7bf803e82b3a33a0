// SPDX-License-Identifier: GPL-3.0-or-later
#include "scoring/trace_builder.h"

#include "scoring/prepared_trial.h"
#include "scoring/trace_columns.h"
#include "scoring/trace_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace chiron::scoring {

namespace {

constexpr std::uint32_t kMarkButton = 1u;

using RowList = std::vector<const TraceRow*>;

void append(ToolTrace& tool, const TraceColumns& columns, const TraceRow& row) {
    tool.t_s.push_back(row.t_s);
    tool.p_WT_m.push_back(row.p_WT_m);
    tool.tissue_N.push_back(row.tissue_N);
    if (columns.commanded)
        tool.commanded_N.push_back(row.commanded_N);
    if (columns.measured)
        tool.measured_N.push_back(row.measured_N);
    tool.paused.push_back(row.paused ? 1 : 0);
    if (columns.contact)
        tool.contact.push_back(row.contact);
    if (columns.orientation)
        tool.q_WT.push_back(row.q_WT);
    if (columns.torque)
        tool.tissueTorque_Nm.push_back(row.tissueTorque_Nm);
}

/// Returns the index of the first row of tool 0 whose mark button is newly down, or rows.size().
std::size_t firstMark(const RowList& rows) {
    bool down = true; // a button that was already down before the trial is not a mark
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (rows[i]->tool != 0)
            continue;
        const bool now = (rows[i]->buttons & kMarkButton) != 0;
        if (now && !down)
            return i;
        down = now;
    }
    return rows.size();
}

void setMark(TrialTrace& trial, const TraceColumns& columns, const RowList& rows) {
    const TraceRow* last = nullptr;
    for (const TraceRow* row : rows)
        if (row->tool == 0)
            last = row;
    if (columns.mark && last != nullptr) {
        trial.marked = last->marked;
        trial.timedOut = last->timedOut;
        trial.markInContact = last->markInContact;
        trial.p_WMark_m = last->p_WMark_m;
        return;
    }
    const std::size_t mark = columns.buttons ? firstMark(rows) : rows.size();
    trial.marked = mark < rows.size();
    const TraceRow* at = trial.marked ? rows[mark] : last;
    if (at == nullptr)
        return;
    trial.p_WMark_m = at->p_WT_m;
    trial.markInContact = !columns.tissue || at->tissue_N.norm() > kContactForce_N;
}

core::Result<void> setTruth(TrialTrace& trial, const RowList& rows, const std::string& source) {
    const TraceRow& first = *rows.front();
    for (const TraceRow* row : rows)
        if (row->target_m != first.target_m || row->targetRadius_m != first.targetRadius_m)
            return core::fail(core::ErrorCode::badInput,
                              source + ": trial " + std::to_string(first.trial + 1) +
                                  ": target_x_mm, target_y_mm or target_radius_mm changes at t_s " +
                                  std::to_string(row->t_s) + ": expected the same on each row of a trial");
    trial.target = TargetTruth{first.target_m.x(), first.target_m.y(), first.targetRadius_m};
    return {};
}

/// Returns the name of the first column of the trial that differs between two rows; empty if none does.
std::string_view differing(const OwnColumns& own, const TraceRow& a, const TraceRow& b) {
    for (std::size_t place = 0; place < own.columns.size(); ++place)
        if (own.columns[place].ofTrial && a.own[place] != b.own[place])
            return own.columns[place].name;
    return {};
}

/// Sets the exercise's own part from its columns in tool 0's rows.
core::Result<void> setOwn(TrialTrace& trial, const OwnColumns& own, const RowList& rows,
                          const std::string& source) {
    RowList ofTool0;
    for (const TraceRow* row : rows) {
        if (const std::string_view column = differing(own, *rows.front(), *row); !column.empty())
            return core::fail(core::ErrorCode::badInput,
                              source + ": trial " + std::to_string(trial.trial + 1) + ": " +
                                  std::string(column) + " changes at t_s " + std::to_string(row->t_s) +
                                  ": expected the same on each row of a trial");
        if (row->tool == 0)
            ofTool0.push_back(row);
    }
    trial.own = own.make(*rows.front(), ofTool0);
    return {};
}

bool sameValue(double a, double b) {
    return a == b || (std::isnan(a) && std::isnan(b)); // NaN: an empty field
}

/// Sets the remaining values that are the same on each row of a trial, apart from mark, target and
/// the exercise's own part.
core::Result<void> setNamed(TrialTrace& trial, const TraceColumns& columns, const RowList& rows,
                            const std::string& source) {
    const TraceRow& first = *rows.front();
    const auto changes = [&](const std::string& column, const TraceRow& row) {
        return core::fail(core::ErrorCode::badInput, source + ": trial " + std::to_string(trial.trial + 1) +
                                                         ": " + column + " changes at t_s " +
                                                         std::to_string(row.t_s) +
                                                         ": expected the same on each row of a trial");
    };
    for (const std::string& id : columns.quantities)
        trial.quantities.push_back({id, {}});
    for (const TraceRow* row : rows) {
        if (row->completed != first.completed || row->failed != first.failed ||
            row->unfinished != first.unfinished)
            return changes(row->completed != first.completed ? "completed"
                           : row->failed != first.failed     ? "failed"
                                                             : "unfinished",
                           *row);
        for (std::size_t i = 0; i < columns.truth.size(); ++i)
            if (!sameValue(row->truth[i], first.truth[i]))
                return changes(std::string(kTruthPrefix) + columns.truth[i], *row);
        for (std::size_t i = 0; row->tool == 0 && i < columns.quantities.size(); ++i)
            trial.quantities[i].values.push_back(row->quantities[i]);
    }
    trial.completed = first.completed;
    trial.failed = first.failed;
    trial.unfinished = first.unfinished;
    for (std::size_t i = 0; i < columns.truth.size(); ++i)
        if (!std::isnan(first.truth[i]))
            trial.truth.push_back({columns.truth[i], first.truth[i]});
    return {};
}

std::map<std::int32_t, RowList> rowsByTrial(const TraceRows& rows, bool endsAtMark) {
    std::map<std::int32_t, RowList> trials;
    for (const TraceRow& row : rows.rows)
        if (!rows.columns.phase || row.phase == core::TrialPhase::running)
            trials[row.trial].push_back(&row);
    if (!rows.columns.trial && rows.columns.buttons && endsAtMark && !trials.empty()) {
        RowList& only = trials.begin()->second;
        only.resize(std::min(firstMark(only) + 1, only.size()));
    }
    return trials;
}

} // namespace

core::Result<SessionTrace> buildSessionTrace(const TraceRows& rows, std::string_view exercise,
                                             double defaultForceLimit_N, MarkMeaning mark) {
    const auto byTrial = rowsByTrial(rows, mark == MarkMeaning::endsTheTrial);
    if (byTrial.empty())
        return core::fail(core::ErrorCode::badInput,
                          rows.source + ": no row of a running trial: expected at least one to score");
    SessionTrace trace;
    trace.exercise = exercise;
    trace.forceLimit_N = rows.columns.forceLimit ? rows.rows.front().forceLimit_N : defaultForceLimit_N;
    trace.plannedTrials = rows.rows.front().plannedTrials;
    for (const auto& [number, list] : byTrial) {
        TrialTrace trial;
        trial.trial = number;
        trial.forcesKnown = rows.columns.tissue;
        for (const TraceRow* row : list) {
            if (trial.tools.size() <= row->tool)
                trial.tools.resize(row->tool + std::size_t{1});
            append(trial.tools[row->tool], rows.columns, *row);
        }
        setMark(trial, rows.columns, list);
        if (rows.columns.target)
            CHIRON_TRY(setTruth(trial, list, rows.source));
        CHIRON_TRY(setNamed(trial, rows.columns, list, rows.source));
        if (rows.columns.own != nullptr)
            CHIRON_TRY(setOwn(trial, *rows.columns.own, list, rows.source));
        trace.trials.push_back(std::move(trial));
    }
    return trace;
}

} // namespace chiron::scoring
