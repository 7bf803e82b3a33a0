// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/arguments.h"
#include "database/actor.h"
#include "database/database.h"

#include <memory>
#include <string>
#include <vector>

namespace chiron::cli {

/// The absolute path of --database, or of chiron/chiron.db in the user's data folder.
QString databasePath(const Arguments& arguments);
/// The options with which this program opens databases.
database::DatabaseOptions databaseOptions();

/// Reads secrets in the order in which they are requested: from the lines of stdin with --password-stdin,
/// otherwise from the environment variables of these names, which are removed after reading. A missing secret
/// stays empty.
/// Errors: wrongUse if the first one is missing.
core::Result<std::vector<std::string>> readSecrets(const Arguments& arguments,
                                                   const std::vector<QString>& variables);

enum class Opening { forReading, forWriting };

/// A database opened on behalf of an actor.
struct Site {
    std::unique_ptr<database::Database> database;
    database::Actor actor = database::Actor::anonymous();
    /// [0]: the actor's password; [1]: the second secret, empty if not given.
    std::vector<std::string> secrets;
};

/// Opens the database as the person of --as.
/// Errors: wrongUse without --as or password (before anything is opened); notFound, locked, storage;
///   notAllowed for a wrong password.
core::Result<Site> openAsPerson(const Arguments& arguments, Opening opening);
/// Does the same, but opens it anonymously without --as, for simulated sessions and files that everybody may
/// read.
core::Result<Site> openAsAnybody(const Arguments& arguments, Opening opening);

} // namespace chiron::cli
