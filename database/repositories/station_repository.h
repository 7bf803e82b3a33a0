// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "database/actor.h"
#include "database/connection.h"

#include <cstdint>
#include <string>

namespace chiron::database {

/// The result of a check of a station, as tokens and numbers, as in the audit chain.
struct StationCheck {
    std::string what;   ///< "loop", "fingertip_platform"
    std::string driver; ///< driver token of the checked device in the driver catalogue; empty: none
    std::string build;  ///< core::buildId()
    bool passed = false;
    /// Serial number that the device reports; empty: it reports none, or there is no device.
    std::string serial{};
};

/// Records checks of the station. Researchers and administrators may record them; a station technician has
/// one of these roles.
class StationRepository {
public:
    StationRepository(Connection& connection, Actor actor)
        : m_connection(connection), m_actor(std::move(actor)) {}

    /// Adds a check to the audit chain and returns the entry's number, which a printed record shows. Only in
    /// a writer's job.
    /// Errors: notAllowed; wrongUse; badInput (what or build is empty, or a text is not plain); storage.
    core::Result<std::int64_t> recordStationCheck(const StationCheck& check);

private:
    Connection& m_connection;
    Actor m_actor;
};

} // namespace chiron::database
