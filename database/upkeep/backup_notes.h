// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "database/upkeep/upkeep.h"

namespace chiron::database {

/// Notes how the latest attempt of the schedule ended (all of the standing but its plan). In a writer's job.
core::Result<void> noteOutcome(Connection& connection, const BackupStanding& now);

} // namespace chiron::database
