// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "database/boot_clock.h"
#include "database/password_cost.h"

#include <memory>
#include <string>

namespace chiron::database {

/// How a database is opened.
struct DatabaseOptions {
    /// Folder of the site key (0600), the audit chain's head and the list of erasures; empty:
    /// "<database>.site".
    std::string siteFolder;
    bool demonstration = false; ///< used by create only: marks the database and everything in it
    PasswordCost passwordCost = PasswordCost::production();
    std::shared_ptr<const IBootClock>
        clock; ///< shared: throttles of every connection read it; null: SystemBootClock
};

/// The site folder that belongs to a database file.
std::string siteFolderFor(const std::string& databaseFile, const DatabaseOptions& options);

} // namespace chiron::database
