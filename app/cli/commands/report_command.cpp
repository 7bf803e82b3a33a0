// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/cli_errors.h"
#include "cli/command_groups.h"
#include "cli/session_output.h"
#include "cli/site_access.h"
#include "report/report_writer.h"
#include "session_report/session_report.h"

#include <QFileInfo>
#include <QJsonArray>

namespace chiron::cli {

namespace {

core::Result<CommandOutput> report(const Arguments& arguments) {
    bool isNumber = false;
    const qint64 id = arguments.operand(0).toLongLong(&isNumber);
    if (!isNumber || id < 1)
        return wrongUse(
            QStringLiteral("SESSION %1: expected the number of a session").arg(quoted(arguments.operand(0))));
    auto site = openAsAnybody(arguments, Opening::forReading);
    CHIRON_TRY(site);
    auto connection = site->database->openReader();
    CHIRON_TRY(connection);
    auto session = session::SessionView::open(**connection, site->actor, id);
    CHIRON_TRY(session);
    auto data = session_report::reportDataOf(**session, **connection, site->actor, "en");
    CHIRON_TRY(data);
    const report::PlotTheme theme = report::lightTheme(QLocale(QLocale::English, QLocale::UnitedKingdom));
    const QString path = QFileInfo(arguments.value(QStringLiteral("pdf"))).absoluteFilePath();
    CHIRON_TRY(report::writeSessionPdf(path, *data, theme));
    QJsonObject json{{"session_id", static_cast<double>(id)}, {"pdf", path}};
    QString text = path + QLatin1Char('\n');
    if (arguments.has(QStringLiteral("pictures"))) {
        auto pictures = report::writeSessionPngs(arguments.value(QStringLiteral("pictures")), *data, theme);
        CHIRON_TRY(pictures);
        QJsonArray list;
        for (const QString& picture : *pictures) {
            list.append(picture);
            text += picture + QLatin1Char('\n');
        }
        json.insert("pictures", list);
    }
    return CommandOutput{QJsonDocument(json), text, 0};
}

} // namespace

std::vector<CommandSpec> reportCommands() {
    CommandSpec command;
    command.group = QStringLiteral("report");
    command.summary = QStringLiteral("a printable report of one session");
    command.operands = {{QStringLiteral("SESSION"), QStringLiteral("number of the session")}};
    command.options = {
        {QStringLiteral("pdf"), QStringLiteral("FILE"), QStringLiteral("where to write it"), true},
        {QStringLiteral("pictures"), QStringLiteral("DIR"),
         QStringLiteral("also write the plots as PNG files here")}};
    command.example = QStringLiteral("chiron-cli report 12 --pdf session_12.pdf");
    command.draws = true;
    command.run = report;
    return {command};
}

} // namespace chiron::cli
