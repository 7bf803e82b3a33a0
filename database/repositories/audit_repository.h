// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "database/actor.h"
#include "database/connection.h"

#include <vector>

namespace chiron::database {

/// One entry of the audit chain for readers. It contains ids, tokens, numbers and digests, never names or
/// free text, so that an erasure never has to change the chain.
struct AuditEntry {
    std::int64_t sequence = 0; ///< from 1
    std::string utc;
    std::string actorKind;
    PersonId actor = 0;
    std::string action;
    std::string target; ///< table of the target
    std::int64_t targetId = 0;
    std::string detailJson;
};

/// Reads the audit chain.
class AuditRepository {
public:
    AuditRepository(Connection& connection, Actor actor)
        : m_connection(connection), m_actor(std::move(actor)) {}
    /// Returns the entries, newest first; limit 0 means all.
    core::Result<std::vector<AuditEntry>> listAudit(int limit = 0);

private:
    Connection& m_connection;
    Actor m_actor;
};

} // namespace chiron::database
