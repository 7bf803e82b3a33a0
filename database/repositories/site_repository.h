// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "database/actor.h"
#include "database/connection.h"

#include <string>

namespace chiron::database {

inline constexpr int kMaximumSiteNameCharacters = 80;

/// A name as it would be stored: without spaces at the ends. Failure: badInput (too long, or control characters).
core::Result<std::string> checkedSiteName(const std::string& name);

/// What the site is called, as people know it: a hospital, a department, a course. Shown before anybody is logged in.
class SiteRepository {
public:
    SiteRepository(Connection& connection, Actor actor)
        : m_connection(connection), m_actor(std::move(actor)) {}

    /// Empty: it was never given one. Failure: storage.
    core::Result<std::string> siteName();
    /// By an administrator; empty takes it away. Only in a writer's job. Failure: notAllowed, wrongUse, that of checkedSiteName, storage.
    core::Result<void> setSiteName(const std::string& name);

private:
    Connection& m_connection;
    Actor m_actor;
};

} // namespace chiron::database
