// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "database/accounts/person.h"
#include "database/audit/site_key.h"
#include "database/upkeep/upkeep.h"

#include <optional>
#include <tl/expected.hpp>

namespace chiron::database {

/// The person with this name and password in a database file of any version, who may restore. Waits after
/// wrong passwords are honoured. Failure: notAllowed; storage where the file cannot be read.
core::Result<Actor> restorerIn(const std::string& file, const std::string& name, const std::string& password,
                               const DatabaseOptions& options);

/// Whether an administrator of the database that stands at the target now is among those who ask
/// (presentName, where it is empty name). Yes where there is no file, or none that can be read, or it has no
/// administrator: then there is nothing to ask. Failure: notAllowed.
core::Result<void> presentAdministratorAgrees(const RestoreRequest& request, const DatabaseOptions& options);

/// Who does not agree to a restore, and why not.
struct RestoreRefusal {
    enum class By {
        backup,
        present ///< the database that stands at the target now
    };
    By by = By::backup;
    Refusal refusal;
};

/// Whether the names and passwords of a request would be accepted, before anything is closed, copied or changed; needs no lock. Nothing:
/// they would, or one of the files cannot be read, which the restore itself tells. Blocking (Argon2id).
std::optional<RestoreRefusal> restoreRefusal(const RestoreRequest& request, const DatabaseOptions& options);

} // namespace chiron::database
