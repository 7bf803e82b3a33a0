// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "database/audit/audit_trail.h"
#include "database/integrity/verifier.h"

#include <optional>

namespace chiron::database {

/// Verifies a copy as verifyDatabase does, with this key (null: the chain is not checked) and the head that
/// the copy must contain.
VerifyReport verifySnapshot(const std::string& file, const SiteKey* key, const std::optional<AuditHead>& head,
                            const ScoreCheck& check = {}, const VerifyWatch& watch = {});

} // namespace chiron::database
