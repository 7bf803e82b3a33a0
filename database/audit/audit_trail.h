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

/// What is to be recorded. Ids, tokens, numbers and digests only: never names or free text.
struct AuditNote {
    std::string_view action;
    std::string_view target; ///< table
    std::int64_t targetId = 0;
    std::optional<RowDigest> row; ///< digest of the target's row after the action: verify compares it
    std::string detail = "{}";    ///< further JSON object, without "row"
};

/// One stored entry with its links.
struct AuditLink {
    std::int64_t sequence = 0;
    std::string utc, actorKind, action, target, detailJson;
    PersonId actor = 0;
    std::int64_t targetId = 0;
    Blob previous, mac;
};

/// Head of the chain: how many entries, and the last one's code.
struct AuditHead {
    std::int64_t count = 0;
    std::string hash; ///< 64 hex digits; of the genesis when empty
    bool operator==(const AuditHead&) const = default;
};

/// Appends an entry in the running transaction: mac = keyed BLAKE2b over its fields and the mac before it;
/// the first one follows a genesis made from the database's identity, so chains of two databases cannot be
/// spliced.
core::Result<void> appendAudit(Connection& connection, const Actor& actor, const AuditNote& note);

/// The code that an entry must have.
RowDigest auditMac(const SiteKey& key, const AuditLink& link);
RowDigest auditGenesis(const SiteKey& key, const std::string& identity);
/// What a database is: uuid, creation date, demonstration marker; the genesis covers it.
core::Result<std::string> databaseIdentity(Connection& connection);
core::Result<AuditHead> auditHead(Connection& connection);

/// The head file "<site folder>/audit_head.json", signed with the key: count and hash as of the last commit.
core::Result<void> writeHeadFile(const SiteKey& key, const AuditHead& head);
/// Nothing if there is no such file. Failure: doesNotHold when it is malformed or not signed with this key.
core::Result<std::optional<AuditHead>> readHeadFile(const SiteKey& key);

std::string_view token(ActorKind kind) noexcept;

} // namespace chiron::database
