// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/procedures/procedure_kind.h"

#include <string>
#include <string_view>
#include <vector>

namespace chiron::psychophysics {

/// Returns all kinds of procedures, in the order of ProcedureSpec (procedure_spec.h). A new kind is added to
/// that list.
const std::vector<const ProcedureKind*>& procedureKinds();
const ProcedureKind& kindFor(const ProcedureSpec& spec);
/// Finds a kind by its id ("staircase") or by the id of a run ("staircase@1", "rank3_quest_plus_ties@1");
/// null if there is none.
const ProcedureKind* findProcedureKind(std::string_view id);
/// Returns "staircase, pest or quest": all ids, with `last` before the last one.
std::string procedureKindIds(std::string_view last = ", ");

/// Returns the ids of the kinds that suit a task, the most recommended first.
std::vector<std::string> kindsFor(Task task);
/// Returns a new procedure of this kind with values that suit a condition; for an unknown id, of the first
/// kind that suits it.
ProcedureSpec usualProcedure(const std::string& kind, const Condition& condition);
/// The same, but with what was asked for in an earlier procedure: its counts, shares and switches if it is of
/// this kind, else only when it stops. Levels, steps, grids and functions are chosen anew, because they
/// depend on the condition.
ProcedureSpec usualProcedureKeeping(const std::string& kind, const Condition& condition,
                                    const ProcedureSpec& earlier);

} // namespace chiron::psychophysics
