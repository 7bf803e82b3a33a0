// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "database/upkeep/upkeep.h"

namespace chiron::database {

/// Records how the latest attempt of the schedule ended (the whole standing except its plan). In a writer's
/// job.
core::Result<void> noteOutcome(Connection& connection, const BackupStanding& now);

} // namespace chiron::database
