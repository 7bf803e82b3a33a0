// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "database/audit/audit_trail.h"
#include "database/upkeep/upkeep.h"

namespace chiron::database {

/// Prepares the copy of a backup to be put in place: migrates it to the newest schema, verifies it against
/// the head in its manifest, checks an administrator's password in it, applies all erasures made since, and
/// notes the restore in its audit chain. Returns how many erasures were applied. The file to be replaced is
/// read, never changed.
core::Result<int> makeRestorable(const std::string& copy, const RestoreRequest& request,
                                 const DatabaseOptions& options, const SiteKey& key, const AuditHead& head);

} // namespace chiron::database
