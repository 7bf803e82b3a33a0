// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/access/authorise.h"
#include "database/audit/audit_trail.h"
#include "database/query.h"
#include "database/upkeep/backup_notes.h"
#include "database/upkeep/upkeep.h"

#include <QJsonDocument>
#include <QJsonObject>

namespace chiron::database {
namespace {

// Stored in the table of the site's properties: a separate table would need a new schema for a few words.
constexpr const char* kPlanKey = "backup_plan";
constexpr const char* kOutcomeKey = "backup_outcome";

core::Result<QJsonObject> noteOf(Connection& connection, const char* key) {
    const auto text = selectText(connection, "SELECT value FROM meta WHERE key = ?", {std::string(key)});
    CHIRON_TRY(text);
    return QJsonDocument::fromJson(QByteArray::fromStdString(text->value_or(""))).object();
}

core::Result<void> putNote(Connection& connection, const char* key, const QJsonObject& json) {
    const auto done = Query::run(
        connection,
        "INSERT INTO meta (key, value) VALUES (?, ?) ON CONFLICT (key) DO UPDATE SET value = excluded.value",
        {std::string(key), QJsonDocument(json).toJson(QJsonDocument::Compact).toStdString()});
    CHIRON_TRY(done);
    return {};
}

std::string text(const QJsonObject& json, const char* key) {
    return json.value(QLatin1String(key)).toString().toStdString();
}

QString text(const std::string& words) {
    return QString::fromStdString(words);
}

} // namespace

core::Result<BackupStanding> Upkeep::backupStanding(Connection& connection, const Actor& actor) {
    CHIRON_TRY(authorise(connection, actor, Action::backupStanding));
    const auto plan = noteOf(connection, kPlanKey);
    const auto outcome = plan ? noteOf(connection, kOutcomeKey) : plan;
    const auto demonstration = selectText(connection, "SELECT value FROM meta WHERE key = 'demonstration'");
    CHIRON_TRY(outcome);
    CHIRON_TRY(demonstration);
    BackupStanding standing;
    const BackupPlan usual;
    standing.plan.on = plan->value(QLatin1String("on")).toBool(demonstration->value_or("0") != "1");
    standing.plan.folder = text(*plan, "folder");
    standing.plan.keep = plan->value(QLatin1String("keep")).toInt(usual.keep);
    standing.triedUtc = text(*outcome, "tried_utc");
    standing.problem = text(*outcome, "problem");
    standing.goodUtc = text(*outcome, "good_utc");
    standing.goodFolder = text(*outcome, "good_folder");
    standing.goodBytes = static_cast<std::uint64_t>(outcome->value(QLatin1String("good_bytes")).toInteger());
    return standing;
}

core::Result<void> Upkeep::setBackupPlan(Connection& connection, const Actor& actor, const BackupPlan& plan) {
    CHIRON_TRY(authorise(connection, actor, Action::setBackupPlan));
    if (plan.keep < 1 || plan.keep > kMostBackupsKept) {
        return core::fail(core::ErrorCode::badInput, "backups to keep: " + std::to_string(plan.keep) +
                                                         "; expected 1 to " +
                                                         std::to_string(kMostBackupsKept));
    }
    const auto put = putNote(connection, kPlanKey,
                             {{QStringLiteral("on"), plan.on},
                              {QStringLiteral("folder"), text(plan.folder)},
                              {QStringLiteral("keep"), plan.keep}});
    CHIRON_TRY(put);
    return appendAudit(connection, actor,
                       {"setBackupPlan", "meta", 0, std::nullopt,
                        std::string("{\"keep\":") + std::to_string(plan.keep) +
                            ",\"on\":" + (plan.on ? "true" : "false") + "}"});
}

core::Result<void> noteOutcome(Connection& connection, const BackupStanding& now) {
    return putNote(connection, kOutcomeKey,
                   {{QStringLiteral("tried_utc"), text(now.triedUtc)},
                    {QStringLiteral("problem"), text(now.problem)},
                    {QStringLiteral("good_utc"), text(now.goodUtc)},
                    {QStringLiteral("good_folder"), text(now.goodFolder)},
                    {QStringLiteral("good_bytes"), static_cast<qint64>(now.goodBytes)}});
}

} // namespace chiron::database
