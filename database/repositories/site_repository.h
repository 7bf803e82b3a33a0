// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "database/actor.h"
#include "database/connection.h"

#include <string>

namespace chiron::database {

inline constexpr int kMaximumSiteNameCharacters = 80;

/// Returns a name as it would be stored, without spaces at the ends.
/// Errors: badInput (too long, or control characters).
core::Result<std::string> checkedSiteName(const std::string& name);

/// The name of the site for people: a hospital, a department, a course. It is shown before anybody logs in.
class SiteRepository {
public:
    SiteRepository(Connection& connection, Actor actor)
        : m_connection(connection), m_actor(std::move(actor)) {}

    /// Returns the name; empty if the site has none.
    /// Errors: storage.
    core::Result<std::string> siteName();
    /// Sets the name, as an administrator; an empty name removes it. Only in a writer's job.
    /// Errors: notAllowed, wrongUse, storage; as checkedSiteName.
    core::Result<void> setSiteName(const std::string& name);

private:
    Connection& m_connection;
    Actor m_actor;
};

} // namespace chiron::database
