// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/integrity/study_check.h"

#include "catalogue/canonical_json.h"
#include "database/query.h"
#include "database/repositories/study_rules.h"

#include <QJsonDocument>
#include <QJsonObject>
#include <map>

namespace chiron::database {
namespace {

void add(VerifyReport& report, const std::string& kind, const std::string& table, const std::string& row,
         const std::string& detail) {
    report.findings.push_back({kind, table, row, detail});
}

// Visits the rows of a query; rows that cannot be read are reported.
template <class Visit>
void each(Connection& connection, const std::string& table, const std::string& sql, VerifyReport& report,
          Visit visit) {
    auto query = Query::run(connection, sql);
    auto row = query ? query->next() : tl::unexpected(query.error());
    for (; row && *row; row = query->next()) {
        visit(*query);
    }
    if (!row) {
        add(report, "unreadable", table, "", row.error().message);
    }
}

/// What the audit chain noted when a study was frozen.
struct Freezing {
    std::string sha256;
    std::string conditions;
};

std::map<std::int64_t, Freezing> freezings(Connection& connection, VerifyReport& report) {
    std::map<std::int64_t, Freezing> all;
    each(connection, "audit",
         "SELECT target_id, detail_json FROM audit WHERE target = 'study' AND action = 'freezeStudy'", report,
         [&](const Query& row) {
             const QJsonObject detail =
                 QJsonDocument::fromJson(QByteArray::fromStdString(row.text(1))).object();
             all[row.integer(0)] = {detail["sha256"].toString().toStdString(),
                                    detail["conditions"].toString().toStdString()};
         });
    return all;
}

void checkFrozen(Connection& connection, VerifyReport& report) {
    const auto known = freezings(connection, report);
    each(connection, "study",
         "SELECT id, design_json, lower(hex(sha256)) FROM study WHERE state <> 'draft' ORDER BY id", report,
         [&](const Query& row) {
             const std::int64_t id = row.integer(0);
             const std::string place = "id=" + std::to_string(id);
             if (catalogue::sha256Hex(row.text(1)) != row.text(2)) {
                 add(report, "study", "study", place, "the frozen design does not fit its SHA-256");
             }
             const auto found = known.find(id);
             if (found == known.end()) {
                 add(report, "audit", "study", place, "was frozen without an entry in the audit chain");
                 return;
             }
             if (found->second.sha256 != row.text(2)) {
                 add(report, "audit", "study", place,
                     "another SHA-256 than the audit chain noted at freezing");
             }
             const auto seal = conditionSeal(connection, id);
             if (!seal || hex(seal->data(), seal->size()) != found->second.conditions) {
                 add(report, "seal", "study", place, "sealed codes are not those of the freezing");
             }
         });
}

void checkRuns(Connection& connection, VerifyReport& report) {
    each(connection, "study_run",
         "SELECT r.id, r.state, r.trials, r.seal, count(t.ordinal), coalesce(max(t.ordinal), -1) FROM "
         "study_run r LEFT JOIN "
         "study_trial t ON t.run_id = r.id GROUP BY r.id ORDER BY r.id",
         report, [&](const Query& row) {
             const std::string place = "id=" + std::to_string(row.integer(0));
             const std::int64_t present = row.integer(4);
             if (present != row.integer(5) + 1) {
                 add(report, "missing", "study_trial", "run_" + place,
                     "the last trial is number " + std::to_string(row.integer(5)) + ", but " +
                         std::to_string(present) + " are there");
             }
             if (row.text(1) == "open") {
                 return;
             }
             if (present != row.integer(2)) {
                 add(report, "missing", "study_trial", "run_" + place,
                     std::to_string(row.integer(2)) + " trials expected, " + std::to_string(present) +
                         " there");
             }
             const auto seal = runSeal(connection, row.integer(0));
             if (!seal || toBlob(*seal) != row.blob(3)) {
                 add(report, "seal", "study_run", place, "the trials are not those of the run's end");
             }
         });
}

} // namespace

void checkStudies(Connection& connection, VerifyReport& report) {
    checkFrozen(connection, report);
    checkRuns(connection, report);
}

} // namespace chiron::database
