// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "database/actor.h"
#include "database/connection.h"
#include "database/database_options.h"

#include <functional>
#include <string>
#include <vector>

namespace chiron::database {

/// A fault that verification found.
struct Finding {
    std::string kind; ///< file, integrity, foreign_key, digest, payload, missing, unreadable, seal, audit,
                      ///< score, database
    std::string table;
    std::string row; ///< the row's key, e.g. "session_id=3 sequence=7"
    std::string detail;
};

struct VerifyReport {
    std::vector<Finding> findings;
    std::uint64_t rowsChecked = 0;
    bool cancelled = false; ///< ended early: the findings are valid, but the rest was not checked
    bool ok() const noexcept { return findings.empty() && !cancelled; }
};

/// Receives the progress of a verification, in steps of about equal length, on its thread; returning false
/// ends it early.
using VerifyWatch = std::function<bool(std::uint64_t done, std::uint64_t of)>;

/// Recomputes the scores of one session and compares them with the stored ones. The session layer provides
/// it. It is called with a read-only connection, once for each ended session whose recording is present.
using ScoreCheck = std::function<std::vector<Finding>(Connection&, SessionId)>;

/// Checks a database file: header, SQLite's integrity check, foreign keys, the digest of every row, payloads,
/// session seals, the audit chain against key and head file, and scores. It needs no login and changes
/// nothing. Every fault of the file becomes a finding, never an error or a crash.
/// Thread: a worker; blocks, and takes long.
VerifyReport verifyDatabase(const std::string& file, const DatabaseOptions& options = {},
                            const ScoreCheck& check = {}, const VerifyWatch& watch = {});

} // namespace chiron::database
