// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "database/actor.h"
#include "database/audit/site_key.h"
#include "database/connection.h"
#include "database/integrity/row_digest.h"

#include <optional>
#include <string>
#include <string_view>

namespace chiron::database {

/// An entry to be recorded. It contains only ids, tokens, numbers and digests, never names or free text.
struct AuditNote {
    std::string_view action;
    std::string_view target; ///< table of the target
    std::int64_t targetId = 0;
    /// Digest of the target's row after the action, with which verify compares the row.
    std::optional<RowDigest> row;
    std::string detail = "{}"; ///< additional JSON object, without "row"
};

/// One stored entry with its links in the chain.
struct AuditLink {
    std::int64_t sequence = 0;
    std::string utc, actorKind, action, target, detailJson;
    PersonId actor = 0;
    std::int64_t targetId = 0;
    Blob previous, mac;
};

/// Head of the chain: the number of entries and the code of the last one.
struct AuditHead {
    std::int64_t count = 0;
    std::string hash; ///< 64 hex digits; the code of the genesis if the chain is empty
    bool operator==(const AuditHead&) const = default;
};

/// Appends an entry in the running transaction: mac = keyed BLAKE2b over its fields and the previous mac. The
/// first entry follows a genesis made from the database's identity, so that the chains of two databases
/// cannot be spliced.
core::Result<void> appendAudit(Connection& connection, const Actor& actor, const AuditNote& note);

/// Returns the code that an entry must have.
RowDigest auditMac(const SiteKey& key, const AuditLink& link);
RowDigest auditGenesis(const SiteKey& key, const std::string& identity);
/// Returns the identity of a database, which the genesis covers: uuid, creation date, demonstration marker.
core::Result<std::string> databaseIdentity(Connection& connection);
core::Result<AuditHead> auditHead(Connection& connection);

/// Writes the head file "<site folder>/audit_head.json", signed with the key: count and hash as of the last
/// commit.
core::Result<void> writeHeadFile(const SiteKey& key, const AuditHead& head);
/// Reads the head file; none if there is no such file.
/// Errors: doesNotHold if it is malformed or not signed with this key.
core::Result<std::optional<AuditHead>> readHeadFile(const SiteKey& key);

std::string_view token(ActorKind kind) noexcept;

} // namespace chiron::database
