// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "database/accounts/person.h"
#include "database/audit/site_key.h"
#include "database/upkeep/upkeep.h"

#include <optional>
#include <tl/expected.hpp>

namespace chiron::database {

/// Returns the person with this name and password in a database file of any version, if that person may
/// restore. Waits after wrong passwords apply.
/// Errors: notAllowed; storage if the file cannot be read.
core::Result<Actor> restorerIn(const std::string& file, const std::string& name, const std::string& password,
                               const DatabaseOptions& options);

/// Checks that an administrator of the database that is now at the target agrees (presentName or, if it is
/// empty, name). It succeeds if there is no file, it cannot be read, or it has no administrator, because then
/// there is nobody to ask.
/// Errors: notAllowed.
core::Result<void> presentAdministratorAgrees(const RestoreRequest& request, const DatabaseOptions& options);

/// Which database refuses a restore, and why.
struct RestoreRefusal {
    enum class By {
        backup,
        present ///< the database that is now at the target
    };
    By by = By::backup;
    Refusal refusal;
};

/// Checks whether the names and passwords of a request would be accepted, before anything is closed, copied
/// or changed; needs no lock. Returns none if they would, or if one of the files cannot be read, which the
/// restore itself reports.
/// Thread: any; blocks (Argon2id).
std::optional<RestoreRefusal> restoreRefusal(const RestoreRequest& request, const DatabaseOptions& options);

} // namespace chiron::database
