// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/procedures/procedure_kind.h"

#include <string>
#include <string_view>
#include <vector>

namespace chiron::psychophysics {

/// All kinds of procedures, in the order of ProcedureSpec (procedure_spec.h), which is the list that a new one is added to.
const std::vector<const ProcedureKind*>& procedureKinds();
const ProcedureKind& kindFor(const ProcedureSpec& spec);
/// By its id ("staircase") or by a run's ("staircase@1", "rank3_quest_plus_ties@1"); null where there is none.
const ProcedureKind* findProcedureKind(std::string_view id);
/// "staircase, pest or quest": all ids, `last` before the last one.
std::string procedureKindIds(std::string_view last = ", ");

/// The kinds that suit a task, the best one first.
std::vector<std::string> kindsFor(Task task);
/// A new procedure of a kind that suits a condition; of an id that is not known, the first kind that does.
ProcedureSpec usualProcedure(const std::string& kind, const Condition& condition);

} // namespace chiron::psychophysics
