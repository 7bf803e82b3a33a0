// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "database/connection.h"
#include "database/repositories/session_types.h"

#include <map>
#include <string>

namespace chiron::desktop {

/// What people are called on screens: by their full name where they have one. Whoever may not list people knows their own full name alone,
/// and of others what their sessions say (a code). A value.
class PeopleNames {
public:
    /// Blocking: a worker's task. Failure: the repository's, but notAllowed.
    static core::Result<PeopleNames> read(database::Connection& connection, const database::Actor& actor);

    std::string of(const database::SessionSummary& session) const; ///< whose session it is

private:
    std::map<database::PersonId, std::string> m_full;
};

} // namespace chiron::desktop
