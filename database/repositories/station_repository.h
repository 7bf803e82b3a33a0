// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "database/actor.h"
#include "database/connection.h"

#include <cstdint>
#include <string>

namespace chiron::database {

/// That a station was checked, and whether it passed: tokens and numbers, as the audit chain keeps them.
struct StationCheck {
    std::string what;   ///< "loop", "fingertip_platform"
    std::string driver; ///< of the device that was checked: a token of the driver catalogue; empty: none
    std::string build;  ///< core::buildId()
    bool passed = false;
    std::string serial{}; ///< of the device, as it tells it; empty: it tells none, or there is none
};

/// Records checks of the station. Researchers and administrators (technicians hold that role) check stations.
class StationRepository {
public:
    StationRepository(Connection& connection, Actor actor)
        : m_connection(connection), m_actor(std::move(actor)) {}

    /// Adds it to the audit chain and returns the entry's number, which a printed record bears. Only in a writer's job.
    /// Failure: notAllowed, wrongUse, badInput (what or build is empty, or anything not plain), storage.
    core::Result<std::int64_t> recordStationCheck(const StationCheck& check);

private:
    Connection& m_connection;
    Actor m_actor;
};

} // namespace chiron::database
