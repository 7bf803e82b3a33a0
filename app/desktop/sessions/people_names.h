// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "database/connection.h"
#include "database/repositories/session_types.h"

#include <QCoreApplication>
#include <map>
#include <string>

namespace chiron::desktop {

/// The names of people as screens show them: the full name if they have one. An actor who may not list people
/// knows only their own full name; of others they see what the sessions contain (a code). A value.
class PeopleNames {
    Q_DECLARE_TR_FUNCTIONS(PeopleNames)
public:
    /// Reads the names.
    /// Thread: worker; blocks.
    /// Errors: those of the repository, except notAllowed.
    static core::Result<PeopleNames> read(database::Connection& connection, const database::Actor& actor);

    /// The person of this session, in the program's language if it is nobody but a script.
    std::string of(const database::SessionSummary& session) const;

private:
    std::map<database::PersonId, std::string> m_full;
};

} // namespace chiron::desktop
