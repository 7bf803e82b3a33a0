// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "database/audit/audit_trail.h"
#include "database/upkeep/upkeep.h"

namespace chiron::database {

/// Makes the copy of a backup fit to be put in place: newest schema, verified against the head its manifest
/// names, an administrator's password checked in it, erased again what was erased since, and the restore
/// noted in its audit chain. Returns how many erasures were applied. The file to be replaced is read, never
/// changed.
core::Result<int> makeRestorable(const std::string& copy, const RestoreRequest& request,
                                 const DatabaseOptions& options, const SiteKey& key, const AuditHead& head);

} // namespace chiron::database
