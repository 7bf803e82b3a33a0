// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/cli_errors.h"
#include "cli/command_groups.h"
#include "cli/site_access.h"
#include "cli/text_table.h"
#include "session/integrity_check.h"

#include <QFileInfo>
#include <QJsonArray>
#include <QJsonObject>

namespace chiron::cli {

namespace {

core::Result<CommandOutput> verify(const Arguments& arguments) {
    const QString path = databasePath(arguments);
    if (!QFileInfo(path).isFile())
        return core::fail(core::ErrorCode::notFound,
                          QStringLiteral("--database %1: no such file; expected a Chiron database")
                              .arg(quoted(path))
                              .toStdString());
    const database::VerifyReport report = session::verifyEverything(path.toStdString(), databaseOptions());
    QJsonArray findings;
    TextTable table(
        {QStringLiteral("kind"), QStringLiteral("table"), QStringLiteral("row"), QStringLiteral("detail")});
    for (const database::Finding& finding : report.findings) {
        const QString kind = QString::fromStdString(finding.kind);
        const QString where = QString::fromStdString(finding.table);
        const QString row = QString::fromStdString(finding.row);
        const QString detail = QString::fromStdString(finding.detail);
        findings.append(QJsonObject{{QStringLiteral("kind"), kind},
                                    {QStringLiteral("table"), where},
                                    {QStringLiteral("row"), row},
                                    {QStringLiteral("detail"), detail}});
        table.add({kind, where, row, detail});
    }
    const QJsonObject json{{QStringLiteral("database"), path},
                           {QStringLiteral("ok"), report.ok()},
                           {QStringLiteral("rows_checked"), static_cast<qint64>(report.rowsChecked)},
                           {QStringLiteral("findings"), findings}};
    const QString text = QStringLiteral("%1: %2 rows checked, %3\n")
                             .arg(path)
                             .arg(report.rowsChecked)
                             .arg(report.ok() ? QStringLiteral("nothing wrong found")
                                              : QStringLiteral("%1 findings").arg(report.findings.size())) +
                         (report.ok() ? QString() : QLatin1Char('\n') + table.toText());
    return CommandOutput{QJsonDocument(json), text, report.ok() ? 0 : 1};
}

} // namespace

std::vector<CommandSpec> verifyCommands() {
    CommandSpec command;
    command.group = QStringLiteral("verify");
    command.summary = QStringLiteral("check integrity, digests, the audit chain and every score");
    command.example = QStringLiteral("chiron-cli verify --database site.db --json");
    command.run = verify;
    return {command};
}

} // namespace chiron::cli
