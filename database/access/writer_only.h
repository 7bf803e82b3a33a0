// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "database/connection.h"

namespace chiron::database {

/// Checks that this is the writer's connection inside a transaction, so that a failing function leaves
/// nothing half done.
/// Errors: wrongUse otherwise.
inline core::Result<void> requireWriter(Connection& connection) {
    if (!connection.isWritable() || !connection.inTransaction()) {
        return core::fail(core::ErrorCode::wrongUse,
                          connection.file() + ": only a writer job may change the database");
    }
    return {};
}

} // namespace chiron::database
