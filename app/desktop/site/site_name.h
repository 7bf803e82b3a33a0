// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "database/actor.h"
#include "database/database.h"

#include <QString>

namespace chiron::desktop {

/// Reads the name of the site; empty if it has none.
/// Thread: worker; blocks.
/// Errors: storage.
core::Result<QString> readSiteName(database::Database& database, const database::Actor& actor);

} // namespace chiron::desktop
