// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/site_access.h"

#include "cli/cli_errors.h"
#include "cli/input_file.h"
#include "database/accounts/account_service.h"

#include <QDir>
#include <QFileInfo>
#include <QStandardPaths>

namespace chiron::cli {

namespace {

const QString kPassword = QStringLiteral("CHIRON_PASSWORD");
const QString kNewPassword = QStringLiteral("CHIRON_NEW_PASSWORD");

core::Result<std::unique_ptr<database::Database>> open(const Arguments& arguments, Opening opening) {
    const QString path = databasePath(arguments);
    const QFileInfo info(path);
    if (!info.exists())
        return core::fail(
            core::ErrorCode::notFound,
            QStringLiteral(
                "--database %1: no such file; expected a Chiron database (chiron-cli init makes one)")
                .arg(quoted(path))
                .toStdString());
    if (!info.isFile())
        return badInput(
            QStringLiteral("--database %1: is not a file; expected a Chiron database").arg(quoted(path)));
    return opening == Opening::forWriting
               ? database::Database::openForWriting(path.toStdString(), databaseOptions())
               : database::Database::openReadOnly(path.toStdString(), databaseOptions());
}

/// A refused login must be counted for every command; otherwise a reading command would allow a password
/// search. A reader cannot count, so a writer tries the login once more, unless another program holds the
/// writer's lock. The error that is reported is then the writer's.
core::Error counted(const Arguments& arguments, const std::string& name, const std::string& password,
                    const core::Error& refused) {
    if (refused.code != core::ErrorCode::notAllowed)
        return refused;
    const auto database = open(arguments, Opening::forWriting);
    if (!database)
        return refused;
    const auto again = database::AccountService(**database).login(name, password);
    return again ? refused : again.error();
}

} // namespace

QString databasePath(const Arguments& arguments) {
    const QString given = arguments.value(QStringLiteral("database"));
    if (!given.isEmpty())
        return QFileInfo(given).absoluteFilePath();
    return QDir(QStandardPaths::writableLocation(QStandardPaths::GenericDataLocation))
        .filePath(QStringLiteral("chiron/chiron.db"));
}

database::DatabaseOptions databaseOptions() {
    return {};
}

core::Result<std::vector<std::string>> readSecrets(const Arguments& arguments,
                                                   const std::vector<QString>& variables) {
    std::vector<std::string> secrets;
    if (arguments.has(QStringLiteral("password-stdin"))) {
        constexpr qint64 kLargest = 16384;
        const auto bytes = readStandardInput(kLargest);
        CHIRON_TRY(bytes);
        QList<QByteArray> lines = bytes->split('\n');
        for (std::size_t i = 0; i < variables.size(); ++i) {
            QByteArray line = lines.value(static_cast<qsizetype>(i));
            if (line.endsWith('\r'))
                line.chop(1);
            secrets.push_back(line.toStdString());
        }
    } else {
        for (const QString& variable : variables) {
            const QByteArray name = variable.toLatin1();
            secrets.push_back(qgetenv(name.constData()).toStdString());
            qunsetenv(name.constData()); // so that no child process or crash report inherits it
        }
    }
    if (secrets.empty() || secrets[0].empty())
        return wrongUse(QStringLiteral("password: none given; expected it in %1 or, with --password-stdin, "
                                       "as the first line of stdin")
                            .arg(variables.empty() ? kPassword : variables[0]));
    return secrets;
}

core::Result<Site> openAsPerson(const Arguments& arguments, Opening opening) {
    const QString name = arguments.value(QStringLiteral("as"));
    if (name.isEmpty())
        return wrongUse(QStringLiteral(
            "--as is missing: this touches people's data; expected --as NAME with the password in "
            "CHIRON_PASSWORD or by --password-stdin"));
    auto secrets = readSecrets(arguments, {kPassword, kNewPassword});
    CHIRON_TRY(secrets);
    auto database = open(arguments, opening);
    CHIRON_TRY(database);
    const auto actor = database::AccountService(**database).login(name.toStdString(), (*secrets)[0]);
    if (!actor)
        return tl::unexpected(opening == Opening::forReading
                                  ? counted(arguments, name.toStdString(), (*secrets)[0], actor.error())
                                  : actor.error());
    return Site{std::move(*database), *actor, std::move(*secrets)};
}

core::Result<Site> openAsAnybody(const Arguments& arguments, Opening opening) {
    if (arguments.has(QStringLiteral("as")))
        return openAsPerson(arguments, opening);
    auto database = open(arguments, opening);
    CHIRON_TRY(database);
    return Site{std::move(*database), database::Actor::anonymous(), {}};
}

} // namespace chiron::cli
