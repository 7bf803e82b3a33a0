// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/arguments.h"
#include "database/actor.h"
#include "database/database.h"

#include <memory>
#include <string>
#include <vector>

namespace chiron::cli {

/// --database, or chiron/chiron.db in the user's data folder. Absolute.
QString databasePath(const Arguments& arguments);
/// How this program opens databases.
database::DatabaseOptions databaseOptions();

/// Secrets in the order asked for: with --password-stdin the lines of stdin, otherwise the environment's
/// variables of these names (removed once read). One that is not there stays empty. Failure: wrongUse when
/// the first is missing.
core::Result<std::vector<std::string>> readSecrets(const Arguments& arguments,
                                                   const std::vector<QString>& variables);

enum class Opening { forReading, forWriting };

/// A database opened on somebody's behalf.
struct Site {
    std::unique_ptr<database::Database> database;
    database::Actor actor = database::Actor::anonymous();
    std::vector<std::string>
        secrets; ///< [0]: the actor's password; [1]: the second one, empty where not given
};

/// Opens the database as the person of --as. Failure: wrongUse without --as or password (before anything is
/// opened); notFound, locked, storage; notAllowed for a wrong password.
core::Result<Site> openAsPerson(const Arguments& arguments, Opening opening);
/// As above, or as nobody without --as: for what simulated sessions and files show to anybody.
core::Result<Site> openAsAnybody(const Arguments& arguments, Opening opening);

} // namespace chiron::cli
