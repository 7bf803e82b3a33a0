// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/integrity/verifier.h"

#include "database/integrity/audit_check.h"
#include "database/integrity/row_scan.h"
#include "database/integrity/session_check.h"
#include "database/integrity/snapshot_check.h"
#include "database/integrity/study_check.h"
#include "database/query.h"
#include "database/schema/migration_runner.h"

#include <algorithm>

namespace chiron::database {
namespace {

void add(VerifyReport& report, const std::string& kind, const std::string& table, const std::string& row,
         const std::string& detail) {
    report.findings.push_back({kind, table, row, detail});
}

void checkStructure(Connection& connection, VerifyReport& report) {
    auto query = Query::run(connection, "PRAGMA integrity_check(1000)");
    auto row = query ? query->next() : tl::unexpected(query.error());
    for (; row && *row; row = query->next()) {
        if (query->text(0) != "ok") {
            add(report, "integrity", "", "", query->text(0));
        }
    }
    if (!row) {
        add(report, "integrity", "", "", row.error().message);
    }
    auto keys = Query::run(connection, "PRAGMA foreign_key_check");
    auto key = keys ? keys->next() : tl::unexpected(keys.error());
    for (; key && *key; key = keys->next()) {
        add(report, "foreign_key", keys->text(0), "rowid=" + std::to_string(keys->integer(1)),
            "refers to a missing row of " + keys->text(2));
    }
    if (!key) {
        add(report, "foreign_key", "", "", key.error().message);
    }
}

std::int64_t integerOf(const DigestedTable& table, const std::vector<Value>& values,
                       std::string_view column) {
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
        if (table.columns[i] == column) {
            return values[i].integer();
        }
    }
    return 0;
}

SeenRows checkRows(Connection& connection, VerifyReport& report, VerifySteps& steps) {
    SeenRows seen;
    const int version = schemaVersionOf(connection);
    for (const DigestedTable& table : digestedTables()) {
        if (table.since > version) {
            continue;
        }
        RowScan(connection, table, report, steps).run([&](const std::vector<Value>& values) {
            if (table.name == "chunk") {
                seen.chunks[integerOf(table, values, "session_id")].insert(
                    integerOf(table, values, "sequence"));
            } else if (table.name == "score") {
                ++seen.scores[integerOf(table, values, "score_set_id")];
            } else if (table.name == "session") {
                seen.sessions.insert(integerOf(table, values, "id"));
            }
        });
    }
    return seen;
}

} // namespace

// Returns the version that the file states, but at least the one that its tables imply; otherwise a false
// number could make us skip later tables. If the schema cannot be read, the newest version is assumed, so
// that every table is checked.
int schemaVersionOf(Connection& connection) {
    const auto version = selectInteger(connection, "PRAGMA user_version");
    const auto held = selectInteger(connection,
                                    "SELECT max(CASE name WHEN 'study_trial' THEN ? WHEN 'person_name' THEN "
                                    "? WHEN 'study_sitting' THEN ? WHEN 'session_decision' THEN ? "
                                    "ELSE 0 END) "
                                    "FROM sqlite_schema WHERE type = 'table'",
                                    {std::int64_t{kStudyVersion}, std::int64_t{kNamesVersion},
                                     std::int64_t{kSittingsVersion}, std::int64_t{kDecisionsVersion}});
    if (!version || !held)
        return kDecisionsVersion;
    return static_cast<int>(std::max(version->value_or(0), held->value_or(0)));
}

VerifyReport verifySnapshot(const std::string& file, const SiteKey* key, const std::optional<AuditHead>& head,
                            const ScoreCheck& check, const VerifyWatch& watch) {
    VerifyReport report;
    VerifySteps steps(watch, report);
    if (const auto present = MigrationRunner().inspect(file); !present) {
        add(report, "file", "", "", present.error().message);
    }
    auto connection =
        Connection::open(file, Connection::Mode::readOnly); // a damaged header may still be readable
    if (!connection) {
        if (report.ok()) {
            add(report, "file", "", "", connection.error().message);
        }
        return report;
    }
    (void)(*connection)->execute("BEGIN"); // one snapshot for all checks, whatever is written meanwhile
    steps.plan(**connection, bool(check));
    if (steps.goOn()) {
        checkStructure(**connection, report);
    }
    const SeenRows seen = checkRows(**connection, report, steps);
    if (!steps.goOn()) { // rows that were not scanned must not be reported as missing
        return report;
    }
    if (schemaVersionOf(**connection) >= kStudyVersion) {
        checkStudies(**connection, report);
    }
    checkSessions(**connection, seen, check, report, steps);
    if (key != nullptr && steps.goOn()) {
        checkAudit(**connection, *key, head, report);
    }
    return report;
}

VerifyReport verifyDatabase(const std::string& file, const DatabaseOptions& options, const ScoreCheck& check,
                            const VerifyWatch& watch) {
    const auto key = SiteKey::load(siteFolderFor(file, options));
    if (!key) {
        VerifyReport report = verifySnapshot(file, nullptr, std::nullopt, check, watch);
        add(report, "audit", "audit", "", key.error().message + " (the chain could not be checked)");
        return report;
    }
    const auto head = readHeadFile(**key);
    VerifyReport report = verifySnapshot(file, key->get(), head.value_or(std::nullopt), check, watch);
    if (!head) {
        add(report, "audit", "audit", "", head.error().message);
    } else if (!*head) {
        add(report, "audit", "audit", "",
            "the site's head file is missing: a chain cut short could not be told");
    }
    return report;
}

} // namespace chiron::database
