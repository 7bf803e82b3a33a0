// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "scoring/trace.h"
#include "scoring/trace_rows.h"

#include <string>
#include <string_view>
#include <vector>

namespace chiron::scoring {

/// What the button of a mark does in an exercise.
enum class MarkMeaning { oneOfSeveral, endsTheTrial };

/// A session as metrics see it, from a trace file's rows.
///
/// Trials: the `trial` column, rows whose phase is running only; without it the file is one trial, which ends at
/// the first mark where that is what a mark does. Mark: the mark columns, else the first row of tool 0 whose button
/// bit 0 is newly down; without one the last position is scored and `marked` stays false. Contact at the
/// mark: the column, else tissue force over 0.02 N at that row, else (no forces in the file) not judged and
/// taken as contact. Apex truth: the target columns. Canal: the insertion columns, from the rows of tool 0; a
/// landmark was seen at the first row that has its bit. Quantities: from the rows of tool 0; truth: from the trial's. Limit: `force_limit_N`, else `defaultForceLimit_N`.
/// Failure (badInput): no row left to score; a column of the trial that changes inside it.
core::Result<SessionTrace> buildSessionTrace(const TraceRows& rows, std::string_view exercise,
                                             double defaultForceLimit_N = 4.0, MarkMeaning mark = MarkMeaning::oneOfSeveral);

/// The rows of a session's trials in time order, with every column it has; buildSessionTrace gives the same
/// scores.
TraceRows rowsOf(const SessionTrace& trace);

/// The ids of truth in any trial, in order of appearance: the columns truth_<id>; and a trial's values in that order, NaN where
/// it has none.
std::vector<std::string> truthIdsOf(const std::vector<TrialTrace>& trials);
std::vector<double> truthOf(const TrialTrace& trial, const std::vector<std::string>& ids);
/// What rowsOf writes of a canal, for who writes rows of his own: of the trial on each of its rows; of tool 0's
/// sample `i`, taken at `t_s`, on that one's. The trial must have an insertion series.
void setTrialOfCanal(InsertionRow& row, const TrialTrace& trial);
void setSampleOfCanal(InsertionRow& row, const InsertionSeries& series, std::size_t i, double t_s);

} // namespace chiron::scoring
