// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "database/audit/site_key.h"
#include "database/upkeep/upkeep.h"

namespace chiron::database {

/// The person with this name and password in a database file of any version, who may restore. Waits after
/// wrong passwords are honoured. Failure: notAllowed; storage where the file cannot be read.
core::Result<Actor> restorerIn(const std::string& file, const std::string& name, const std::string& password,
                               const DatabaseOptions& options);

/// Whether an administrator of the database that stands at the target now is among those who ask
/// (presentName, where it is empty name). Yes where there is no file, or none that can be read, or it has no
/// administrator: then there is nothing to ask. Failure: notAllowed.
core::Result<void> presentAdministratorAgrees(const RestoreRequest& request, const DatabaseOptions& options);

} // namespace chiron::database
