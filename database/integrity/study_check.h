// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "database/connection.h"
#include "database/integrity/verifier.h"

namespace chiron::database {

/// Checks what belongs together in studies: a frozen design fits its SHA-256 and the one that the audit chain noted when it was frozen,
/// sealed codes are those of then, trials follow on without a gap, and an ended run has just the trials it was sealed with.
void checkStudies(Connection& connection, VerifyReport& report);

} // namespace chiron::database
