// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "database/connection.h"
#include "database/integrity/verifier.h"

namespace chiron::database {

/// Checks rows of studies that belong together: a frozen design matches its SHA-256 and the one that the
/// audit chain noted when it was frozen, the sealed codes are still the same, trials follow one another
/// without a gap, and an ended run has exactly the trials with which it was sealed.
void checkStudies(Connection& connection, VerifyReport& report);

} // namespace chiron::database
