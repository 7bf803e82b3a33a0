// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "database/audit/audit_trail.h"
#include "database/integrity/verifier.h"

#include <optional>

namespace chiron::database {

/// Checks the audit chain: codes (edits), numbers (gaps, reordering), links (splices), the head that it must
/// contain (truncation), and that the rows covered by it still are as in their last entry.
void checkAudit(Connection& connection, const SiteKey& key, const std::optional<AuditHead>& head,
                VerifyReport& report);

} // namespace chiron::database
