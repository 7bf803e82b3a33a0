// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "database/access/action.h"
#include "database/actor.h"

#include <optional>

namespace chiron::database {

/// The objects that a permission covers.
enum class Scope {
    none,            ///< denied
    own,             ///< objects that belong to the actor
    simulated,       ///< objects that belong to the simulated account
    ownAndSimulated, ///< both
    all,
};

/// One row of the access table: who may call a function. The columns are in the order of the header line in
/// access_table.cpp.
struct AccessRow {
    Action action;
    Scope anonymous, simulated, maintenance, trainee, trainer, researcher, admin;
};

/// Returns the row of an action; none if there is no row (then the action is denied).
std::optional<AccessRow> accessRow(Action action) noexcept;

/// Returns the widest scope of this kind of actor with these roles.
Scope scopeOf(Action action, ActorKind kind, const RoleSet& roles) noexcept;

} // namespace chiron::database
