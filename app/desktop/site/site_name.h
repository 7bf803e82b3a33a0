// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "database/actor.h"
#include "database/database.h"

#include <QString>

namespace chiron::desktop {

/// What the site is called; empty where it has no name. Blocking; for a worker. Failure: storage.
core::Result<QString> readSiteName(database::Database& database, const database::Actor& actor);

} // namespace chiron::desktop
