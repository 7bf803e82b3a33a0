// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/repositories/session_seal.h"

#include "database/query.h"

namespace chiron::database {
namespace {

// Appends the digests of one group, in order, preceded by their count, so that rows cannot move between
// groups.
core::Result<void> appendGroup(Connection& connection, Blob& bytes, const std::string& sql, std::int64_t id) {
    auto query = Query::run(connection, sql, {id});
    CHIRON_TRY(query);
    Blob digests;
    std::uint64_t count = 0;
    auto row = query->next();
    for (; row && *row; row = query->next()) {
        const Blob digest = query->blob(0);
        digests.insert(digests.end(), digest.begin(), digest.end());
        ++count;
    }
    CHIRON_TRY(row);
    for (int shift = 0; shift < 64; shift += 8) {
        bytes.push_back(static_cast<std::uint8_t>(count >> shift));
    }
    bytes.insert(bytes.end(), digests.begin(), digests.end());
    return {};
}

} // namespace

core::Result<RowDigest> sessionSeal(Connection& connection, SessionId session) {
    Blob bytes;
    for (const char* sql : {"SELECT digest FROM chunk WHERE session_id = ? ORDER BY sequence",
                            "SELECT digest FROM trial WHERE session_id = ? ORDER BY ordinal",
                            "SELECT digest FROM event WHERE session_id = ? ORDER BY ordinal",
                            "SELECT digest FROM second_summary WHERE session_id = ? ORDER BY second, tool"}) {
        CHIRON_TRY(appendGroup(connection, bytes, sql, session));
    }
    return bytesDigest(bytes);
}

core::Result<RowDigest> scoreSeal(Connection& connection, std::int64_t scoreSetId) {
    Blob bytes;
    auto added =
        appendGroup(connection, bytes,
                    "SELECT digest FROM score WHERE score_set_id = ? ORDER BY trial, ordinal", scoreSetId);
    CHIRON_TRY(added);
    return bytesDigest(bytes);
}

} // namespace chiron::database
