// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/catalogue.h"
#include "core/result.h"
#include "database/actor.h"
#include "database/database.h"
#include "desktop/frame/background.h"

#include <memory>
#include <optional>
#include <string>

namespace chiron::desktop {

/// The first administrator as entered in the form.
struct AdministratorRequest {
    std::string name;
    std::string displayName;
    std::string password;
    std::string siteName{}; ///< may be empty
};

/// A site that was just created, or opened for the first time.
struct MadeSite {
    std::unique_ptr<database::Database> database; ///< empty if the database was already open
    catalogue::Catalogue catalogue;
    database::Actor actor = database::Actor::anonymous();
    std::string recoveryCode; ///< of the first administrator
};

/// Creates the database if there is none, and its first administrator, who is then logged in. `open` is the
/// site's database if it is already open (it contains no people yet).
/// Thread: worker; blocks.
/// Errors: as for openSite() and AccountService::createFirstAdministrator().
core::Result<MadeSite> makeSite(const std::string& file, const database::DatabaseOptions& options,
                                database::Database* open, const AdministratorRequest& request);

/// Opens the demonstration site in this file, and creates it first if the file does not exist. It reports its
/// progress and, in `language`, the current step to the token, and ends early when the token is cancelled.
/// Thread: worker; blocks.
/// Errors: cancelled; badInput if the file holds another site; as for createDemoSite().
core::Result<MadeSite> makeDemonstration(const std::string& file, const database::DatabaseOptions& options,
                                         WorkToken& token, const std::string& language = "en");

} // namespace chiron::desktop
