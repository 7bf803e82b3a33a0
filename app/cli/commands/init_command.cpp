// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/cli_errors.h"
#include "cli/command_groups.h"
#include "cli/site_access.h"
#include "cli/text_table.h"
#include "database/accounts/account_rules.h"
#include "database/accounts/account_service.h"

#include <QDir>
#include <QFileInfo>
#include <QJsonObject>

namespace chiron::cli {

namespace {

// An existing database, for instance one that `train` created, gets an administrator if it has none yet.
core::Result<std::unique_ptr<database::Database>> createOrOpen(const QString& path) {
    if (QFileInfo::exists(path))
        return database::Database::openForWriting(path.toStdString(), databaseOptions());
    if (!QDir().mkpath(QFileInfo(path).absolutePath()))
        return noFolder(QFileInfo(path).absolutePath());
    return database::Database::create(path.toStdString(), databaseOptions());
}

core::Result<CommandOutput> init(const Arguments& arguments) {
    const std::string name = arguments.value(QStringLiteral("admin")).toStdString();
    const auto secrets = readSecrets(arguments, {QStringLiteral("CHIRON_PASSWORD")});
    CHIRON_TRY(secrets);
    // These checks come before the file is created, so that a refused password leaves nothing behind.
    CHIRON_TRY(database::checkName(name));
    CHIRON_TRY(database::checkPassword(name, (*secrets)[0]));
    const QString path = databasePath(arguments);
    const auto database = createOrOpen(path);
    CHIRON_TRY(database);
    const auto first =
        database::AccountService(**database)
            .createFirstAdministrator(name, (*secrets)[0],
                                      arguments.value(QStringLiteral("display-name")).toStdString());
    CHIRON_TRY(first);
    const QString code = QString::fromStdString(first->recoveryCode);
    const QJsonObject json{{QStringLiteral("database"), path},
                           {QStringLiteral("schema_version"), (*database)->schemaVersion()},
                           {QStringLiteral("id"), static_cast<qint64>(first->id)},
                           {QStringLiteral("recovery_code"), code}};
    const QString text =
        alignedPairs({{QStringLiteral("database"), path},
                      {QStringLiteral("schema version"), QString::number((*database)->schemaVersion())},
                      {QStringLiteral("administrator"), QString::fromStdString(name)},
                      {QStringLiteral("recovery code"), code}}) +
        QStringLiteral("\nWrite the recovery code down: it is shown this once and sets a new password if "
                       "this one is lost.\n");
    return CommandOutput{QJsonDocument(json), text, 0};
}

} // namespace

std::vector<CommandSpec> initCommands() {
    CommandSpec command;
    command.group = QStringLiteral("init");
    command.summary = QStringLiteral("make a new database with its first administrator");
    command.options = {
        {QStringLiteral("admin"), QStringLiteral("NAME"),
         QStringLiteral("login name of the administrator; password as for --as"), true},
        {QStringLiteral("display-name"), QStringLiteral("TEXT"), QStringLiteral("the name that others see")}};
    command.example = QStringLiteral("CHIRON_PASSWORD=... chiron-cli init --admin alice --database site.db");
    command.run = init;
    return {command};
}

} // namespace chiron::cli
