// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "database/audit/audit_trail.h"
#include "database/integrity/verifier.h"

#include <optional>

namespace chiron::database {

/// As verifyDatabase, for a copy: against this key (null: the chain is left unchecked) and the head that the
/// copy must contain.
VerifyReport verifySnapshot(const std::string& file, const SiteKey* key, const std::optional<AuditHead>& head,
                            const ScoreCheck& check = {}, const VerifyWatch& watch = {});

} // namespace chiron::database
