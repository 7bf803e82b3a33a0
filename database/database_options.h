// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "database/boot_clock.h"
#include "database/password_cost.h"

#include <memory>
#include <string>

namespace chiron::database {

/// Options for opening a database.
struct DatabaseOptions {
    /// Folder of the site key (0600), the head of the audit chain and the list of erasures; empty:
    /// "<database>.site".
    std::string siteFolder;
    bool demonstration = false; ///< used only by create: marks the database and everything in it
    PasswordCost passwordCost = PasswordCost::production();
    /// Shared, because the throttles of every connection read it; null: SystemBootClock.
    std::shared_ptr<const IBootClock> clock;
};

/// Returns the site folder that belongs to a database file.
std::string siteFolderFor(const std::string& databaseFile, const DatabaseOptions& options);

} // namespace chiron::database
