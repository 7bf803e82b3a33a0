// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "scoring/trace.h"
#include "scoring/trace_rows.h"

#include <string>
#include <string_view>
#include <vector>

namespace chiron::scoring {

/// The effect of a mark in an exercise.
enum class MarkMeaning { oneOfSeveral, endsTheTrial };

/// Builds a session for scoring from a trace file's rows.
///
/// Trials: from the `trial` column, using only rows whose phase is running. Without that column the file is
/// one trial, which ends at the first mark if marks end trials. Mark: from the mark columns, else the first
/// row of tool 0 whose button bit 0 is newly down. Without a mark the last position is scored and `marked`
/// stays false. Contact at the mark: from the column, else tissue force over 0.02 N at that row, else (no
/// forces in the file) it is not judged and taken as contact. Target: from its columns. The
/// exercise's own part: from its columns in the rows of tool 0. Quantities: from the rows of tool 0; truth:
/// from the trial's rows. Limit: `force_limit_N`, else `defaultForceLimit_N`. Errors: badInput if no row is
/// left to score, or a column that belongs to the trial changes within it.
core::Result<SessionTrace> buildSessionTrace(const TraceRows& rows, std::string_view exercise,
                                             double defaultForceLimit_N = 4.0,
                                             MarkMeaning mark = MarkMeaning::oneOfSeveral);

/// Returns the rows of a session's trials in the order of time, with every column that the session has.
/// buildSessionTrace gives the same scores from them.
TraceRows rowsOf(const SessionTrace& trace);

/// Return the ids of the ground-truth values in any trial, in the order of appearance, for the columns
/// truth_<id>; and a trial's values in that order, NaN if it has none.
std::vector<std::string> truthIdsOf(const std::vector<TrialTrace>& trials);
std::vector<double> truthOf(const TrialTrace& trial, const std::vector<std::string>& ids);
/// Set the columns of the target and of the exercise's own part as rowsOf does, for callers that write their
/// own rows: the values of the trial, which are the same on each of its rows, and those of tool 0's sample
/// `i`, taken at `t_s`, which the exercise's own part has. Nothing for a part that the trial does not have.
void setTrial(TraceRow& row, const TrialTrace& trial, const TraceColumns& columns);
void setSample(TraceRow& row, const TrialTrace& trial, std::size_t i, double t_s);

} // namespace chiron::scoring
