// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string_view>
#include <variant>

#include "core/result.h"
#include "psychophysics/procedures/constant_spec.h"
#include "psychophysics/procedures/descending_spec.h"
#include "psychophysics/procedures/pest_spec.h"
#include "psychophysics/procedures/procedure.h"
#include "psychophysics/procedures/quest_plus_spec.h"
#include "psychophysics/procedures/quest_spec.h"
#include "psychophysics/procedures/rank3_spec.h"
#include "psychophysics/procedures/staircase_spec.h"

namespace chiron::psychophysics {

/// The specification of a procedure. The list of alternatives is the catalogue of procedures, one line each:
/// a specification's kKind is the procedure's id, and its kind() describes it (procedure_kind.h). "x" is the
/// procedure's own unit (in a study, log10 of the difference D, or D).
using ProcedureSpec =
    std::variant<StaircaseSpec, PestSpec, ConstantSpec, DescendingSpec, QuestSpec, QuestPlusSpec, Rank3Spec>;

/// Returns the procedure's id as in content and exports: its specification's kKind.
std::string_view kindOf(const ProcedureSpec& spec) noexcept;
/// Makes one run. `seed` is for anything that the procedure draws at random.
/// Errors: badInput naming the key and what was expected.
core::Result<std::unique_ptr<Procedure>> makeProcedure(const ProcedureSpec& spec, std::uint64_t seed);

/// Makes any number of runs of one specification. Shared parts (the tables of QUEST+) are made once.
using ProcedureFactory = std::function<std::unique_ptr<Procedure>(std::uint64_t seed)>;
core::Result<ProcedureFactory> procedureFactory(const ProcedureSpec& spec); ///< fails as makeProcedure does

} // namespace chiron::psychophysics
