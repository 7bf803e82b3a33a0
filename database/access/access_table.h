// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "database/access/action.h"
#include "database/actor.h"

#include <optional>

namespace chiron::database {

/// How far a permission reaches.
enum class Scope {
    none,            ///< denied
    own,             ///< what belongs to the actor
    simulated,       ///< what belongs to the simulated account
    ownAndSimulated, ///< both
    all,
};

/// One row: who may call a function. Columns in the order of the header line in access_table.cpp.
struct AccessRow {
    Action action;
    Scope anonymous, simulated, maintenance, trainee, trainer, researcher, admin;
};

/// The row of an action; nothing if there is none (then it is denied).
std::optional<AccessRow> accessRow(Action action) noexcept;

/// The widest scope that this kind of actor with these roles has.
Scope scopeOf(Action action, ActorKind kind, const RoleSet& roles) noexcept;

} // namespace chiron::database
