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

/// The first administrator as typed.
struct AdministratorRequest {
    std::string name;
    std::string displayName;
    std::string password;
    std::string siteName{}; ///< may be empty
};

/// A site that was just made, or opened for the first time.
struct MadeSite {
    std::unique_ptr<database::Database> database; ///< empty where it was open already
    catalogue::Catalogue catalogue;
    database::Actor actor = database::Actor::anonymous();
    std::string recoveryCode; ///< of the first administrator
};

/// Makes the database where there is none, and its first administrator, who is logged in. `open` is the site's database
/// where it is open already (it has no people yet). Blocking; for a worker. Failure: as openSite and
/// AccountService::createFirstAdministrator.
core::Result<MadeSite> makeSite(const std::string& file, const database::DatabaseOptions& options, database::Database* open,
                                const AdministratorRequest& request);

/// Opens the demonstration site in this file, and makes it first where there is none. Tells the token how far it is and, in `language`, what it makes, and
/// ends early when that is cancelled. Blocking; for a worker. Failure: cancelled; badInput when the file holds another
/// site; as createDemoSite.
core::Result<MadeSite> makeDemonstration(const std::string& file, const database::DatabaseOptions& options, WorkToken& token,
                                         const std::string& language = "en");

} // namespace chiron::desktop
