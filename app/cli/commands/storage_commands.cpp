// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/cli_errors.h"
#include "cli/command_groups.h"
#include "cli/site_access.h"
#include "cli/text_table.h"
#include "database/upkeep/upkeep.h"

#include <QFileInfo>
#include <QJsonObject>

namespace chiron::cli {

namespace {

QString text(const std::string& words) {
    return QString::fromStdString(words);
}

CommandOutput snapshotOutput(const database::SnapshotInfo& info) {
    const QJsonObject json{{QStringLiteral("folder"), text(info.folder)},
                           {QStringLiteral("database"), text(info.databaseFile)},
                           {QStringLiteral("blake2b"), text(info.blake2b)},
                           {QStringLiteral("bytes"), static_cast<qint64>(info.bytes)},
                           {QStringLiteral("audit_count"), static_cast<qint64>(info.auditCount)},
                           {QStringLiteral("audit_hash"), text(info.auditHash)},
                           {QStringLiteral("verified"), true}};
    return {QJsonDocument(json),
            alignedPairs({{QStringLiteral("folder"), text(info.folder)},
                          {QStringLiteral("database"), text(info.databaseFile)},
                          {QStringLiteral("bytes"), QString::number(info.bytes)},
                          {QStringLiteral("BLAKE2b"), text(info.blake2b)},
                          {QStringLiteral("audit entries"), QString::number(info.auditCount)},
                          {QStringLiteral("verified"), QStringLiteral("yes, after writing")}}),
            0};
}

using Snapshot = core::Result<database::SnapshotInfo> (*)(database::Database&, const database::Actor&,
                                                          const std::string&, const std::atomic<bool>*);

core::Result<CommandOutput> snapshot(const Arguments& arguments, Snapshot make) {
    auto site = openAsPerson(arguments, Opening::forWriting);
    CHIRON_TRY(site);
    const auto info = make(*site->database, site->actor,
                           QFileInfo(arguments.operand(0)).absoluteFilePath().toStdString(), nullptr);
    CHIRON_TRY(info);
    return snapshotOutput(*info);
}

core::Result<CommandOutput> backup(const Arguments& arguments) {
    return snapshot(arguments, &database::Upkeep::backup);
}

core::Result<CommandOutput> exportSite(const Arguments& arguments) {
    return snapshot(arguments, &database::Upkeep::exportSite);
}

core::Result<CommandOutput> restore(const Arguments& arguments) {
    database::RestoreRequest request;
    request.name = arguments.value(QStringLiteral("as")).toStdString();
    if (request.name.empty())
        return wrongUse(QStringLiteral(
            "--as is missing; expected --as NAME, an administrator of the backup, with the password in "
            "CHIRON_PASSWORD or by --password-stdin"));
    const auto secrets = readSecrets(
        arguments, {QStringLiteral("CHIRON_PASSWORD"), QStringLiteral("CHIRON_PRESENT_PASSWORD")});
    CHIRON_TRY(secrets);
    if (!QFileInfo(arguments.operand(0)).isDir())
        return core::fail(core::ErrorCode::notFound,
                          QStringLiteral("FOLDER %1: no such folder; expected one that backup made")
                              .arg(quoted(arguments.operand(0)))
                              .toStdString());
    request.password = (*secrets)[0];
    if (!(*secrets)[1].empty()) {
        request.presentName = arguments.value(QStringLiteral("present-as")).toStdString();
        request.presentName = request.presentName.empty() ? request.name : request.presentName;
        request.presentPassword = (*secrets)[1];
    }
    request.backupFolder = QFileInfo(arguments.operand(0)).absoluteFilePath().toStdString();
    request.targetFile = databasePath(arguments).toStdString();
    request.siteKeyFile = arguments.value(QStringLiteral("site-key")).toStdString();
    const auto info = database::Upkeep::restore(request, databaseOptions());
    CHIRON_TRY(info);
    const QJsonObject json{{QStringLiteral("database"), text(request.targetFile)},
                           {QStringLiteral("kept_old_file"), text(info->keptOldFile)},
                           {QStringLiteral("erasures_applied"), info->erasuresApplied},
                           {QStringLiteral("verified"), true}};
    return CommandOutput{
        QJsonDocument(json),
        alignedPairs(
            {{QStringLiteral("database"), text(request.targetFile)},
             {QStringLiteral("old file kept at"),
              info->keptOldFile.empty() ? QStringLiteral("(there was none)") : text(info->keptOldFile)},
             {QStringLiteral("erasures applied"), QString::number(info->erasuresApplied)}}),
        0};
}

core::Result<CommandOutput> migrate(const Arguments& arguments) {
    auto site = openAsPerson(arguments, Opening::forWriting); // opening for writing migrates, after a backup
    CHIRON_TRY(site);
    const QJsonObject json{{QStringLiteral("database"), text(site->database->file())},
                           {QStringLiteral("schema_version"), site->database->schemaVersion()}};
    return CommandOutput{
        QJsonDocument(json),
        alignedPairs({{QStringLiteral("database"), text(site->database->file())},
                      {QStringLiteral("schema version"), QString::number(site->database->schemaVersion())}}),
        0};
}

CommandSpec spec(const char* group, const char* summary, const char* example,
                 core::Result<CommandOutput> (*run)(const Arguments&)) {
    CommandSpec command;
    command.group = QLatin1String(group);
    command.summary = QLatin1String(summary);
    command.example = QLatin1String(example);
    command.run = run;
    return command;
}

} // namespace

std::vector<CommandSpec> storageCommands() {
    CommandSpec backing = spec("backup", "a verified snapshot in a new folder",
                               "chiron-cli backup /media/backup/today --as alice", backup);
    CommandSpec restoring =
        spec("restore", "put a verified backup in the database's place; the old file is kept",
             "chiron-cli restore /media/backup/today --as alice", restore);
    CommandSpec exporting = spec("export-site", "a backup and every table as JSON Lines, in a new folder",
                                 "chiron-cli export-site /media/export --as alice", exportSite);
    backing.operands =
        exporting.operands = {{QStringLiteral("FOLDER"), QStringLiteral("a folder that does not exist yet")}};
    restoring.operands = {{QStringLiteral("FOLDER"), QStringLiteral("a folder that backup made")}};
    restoring.options = {
        {QStringLiteral("site-key"), QStringLiteral("FILE"),
         QStringLiteral("the site key, where this machine has none yet")},
        {QStringLiteral("present-as"), QStringLiteral("NAME"),
         QStringLiteral("an administrator of the database that is replaced, with the password in "
                        "CHIRON_PRESENT_PASSWORD or the second line of stdin; default: --as")}};
    return {backing, restoring,
            spec("migrate", "bring an older database up to this program's version, after a backup",
                 "chiron-cli migrate --database old.db --as alice", migrate),
            exporting};
}

} // namespace chiron::cli
