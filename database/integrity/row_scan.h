// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "database/connection.h"
#include "database/integrity/row_digest.h"
#include "database/integrity/verifier.h"
#include "database/integrity/verify_steps.h"

#include <functional>
#include <set>
#include <utility>

namespace chiron::database {

/// Reads every row of a digested table and compares its digest and the hash of its payload or text. Damage
/// does not stop the scan: rows that cannot be read are reported by their numbers, and reading continues
/// after them.
class RowScan {
public:
    using Visitor = std::function<void(const std::vector<Value>& values)>;

    RowScan(Connection& connection, const DigestedTable& table, VerifyReport& report, VerifySteps& steps);
    /// Scans the table. `visit` receives the covered values of each row that could be read, damaged or not.
    void run(const Visitor& visit = {});

private:
    enum class Pass { finished, broken };
    Pass readFrom(std::int64_t after, std::int64_t& last, const Visitor& visit);
    void checkRow(const class Query& query, const Visitor& visit);
    void report(const std::string& kind, const std::string& row, const std::string& detail);
    std::string sql() const;
    std::string keyOf(const std::vector<Value>& values) const;

    Connection& m_connection;
    DigestedTable m_table; ///< as in this file: an earlier version lacks the later columns
    VerifyReport& m_report;
    VerifySteps& m_steps;
    std::string m_words; ///< SQLite's message for the last failure
};

/// Returns a value for people, as in "session_id=3".
std::string printable(const Value& value);

} // namespace chiron::database
