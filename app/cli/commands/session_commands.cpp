// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/cli_errors.h"
#include "cli/command_groups.h"
#include "cli/session_output.h"
#include "cli/site_access.h"
#include "cli/text_table.h"
#include "database/repositories/session_reader.h"
#include "session/bids_motion.h"
#include "session/session_export.h"

#include <QDir>
#include <QJsonArray>
#include <limits>

namespace chiron::cli {

namespace {

/// A database opened for reading, with this thread's connection.
struct Reading {
    Site site;
    std::unique_ptr<database::Connection> connection;
};

core::Result<Reading> openReading(const Arguments& arguments) {
    auto site = openAsAnybody(arguments, Opening::forReading);
    CHIRON_TRY(site);
    auto connection = site->database->openReader();
    CHIRON_TRY(connection);
    return Reading{std::move(*site), std::move(*connection)};
}

core::Result<CommandOutput> list(const Arguments& arguments) {
    database::SessionFilter filter;
    auto limit = arguments.integer(QStringLiteral("limit"), 1, 1'000'000, 0);
    CHIRON_TRY(limit);
    filter.limit = static_cast<int>(*limit);
    filter.exercise = arguments.value(QStringLiteral("exercise")).toStdString();
    filter.includeArchived = arguments.has(QStringLiteral("archived"));
    auto reading = openReading(arguments);
    CHIRON_TRY(reading);
    auto sessions = database::SessionReader(*reading->connection, reading->site.actor).listSessions(filter);
    CHIRON_TRY(sessions);
    QJsonArray array;
    TextTable table({">id", "person", "exercise", ">level", ">attempt", "operator", "state", "passed",
                     "started (UTC)", ">frames", ">bytes"});
    for (const database::SessionSummary& session : *sessions) {
        const QJsonObject json = summaryJson(session);
        array.append(json);
        table.add({QString::number(session.id), json["person"].toString(), json["exercise"].toString(),
                   QString::number(session.level),
                   session.attempt > 0 ? QString::number(session.attempt) : QString(),
                   json["operator"].toString(), json["state"].toString(),
                   session.passed ? (*session.passed ? "yes" : "no") : "", json["started_utc"].toString(),
                   session.sealed ? QStringLiteral("sealed") : QString::number(session.frames),
                   session.sealed ? QStringLiteral("sealed") : QString::number(session.recordingBytes)});
    }
    return CommandOutput{QJsonDocument(QJsonObject{{"sessions", array}}), table.toText(), 0};
}

core::Result<CommandOutput> show(const Arguments& arguments) {
    auto id = arguments.integerOperand(0, 1, std::numeric_limits<qint64>::max());
    CHIRON_TRY(id);
    auto reading = openReading(arguments);
    CHIRON_TRY(reading);
    auto record = database::SessionReader(*reading->connection, reading->site.actor).session(*id);
    CHIRON_TRY(record);
    auto view = viewOf(*reading->connection, reading->site.actor, *id);
    CHIRON_TRY(view);
    auto events = eventsJson(*reading->connection, reading->site.actor, *record);
    CHIRON_TRY(events);
    const QJsonArray yields = yieldsOf(*events);
    QJsonObject json = sessionJson(*view, *record);
    json.insert("yields", yields);
    return CommandOutput{QJsonDocument(json),
                         scoreText(*view) + yieldsText(yields, record->summary.exercise) +
                             decisionsText(record->decisions),
                         0};
}

core::Result<void> writeFormat(const QString& format, session::SessionView& session,
                               const QJsonObject& summary, const QString& path) {
    if (format == QLatin1String("bids"))
        return session::exportSessionBids(session, path.toStdString());
    return format == QLatin1String("csv") ? session::exportCsv(session, path)
                                          : session::exportJson(session, summary, path);
}

core::Result<CommandOutput> exportSession(const Arguments& arguments) {
    auto id = arguments.integerOperand(0, 1, std::numeric_limits<qint64>::max());
    auto formats = arguments.list(QStringLiteral("format"));
    CHIRON_TRY(id);
    CHIRON_TRY(formats);
    if (formats->isEmpty())
        *formats << QStringLiteral("csv");
    for (const QString& format : *formats) {
        if (format != QLatin1String("csv") && format != QLatin1String("json") &&
            format != QLatin1String("bids"))
            return wrongUse(
                QStringLiteral("--format: %1: unknown; expected csv, json, bids").arg(quoted(format)));
    }
    auto reading = openReading(arguments);
    CHIRON_TRY(reading);
    auto session = session::SessionView::open(*reading->connection, reading->site.actor, *id);
    CHIRON_TRY(session);
    auto view = viewOf(*reading->connection, reading->site.actor, *id);
    CHIRON_TRY(view);
    auto events = eventsJson(*reading->connection, reading->site.actor, (*session)->record());
    CHIRON_TRY(events);
    QJsonObject known = sessionJson(*view, (*session)->record());
    known.insert("events", *events);
    const QDir folder(arguments.has(QStringLiteral("folder")) ? arguments.value(QStringLiteral("folder"))
                                                              : QStringLiteral("."));
    if (!folder.mkpath(QStringLiteral(".")))
        return noFolder(folder.path());
    QJsonArray files;
    QString text;
    for (const QString& format : *formats) {
        const QString path = folder.filePath(QStringLiteral("session_%1.%2").arg(*id).arg(format));
        CHIRON_TRY(writeFormat(format, **session, known, path));
        files.append(path);
        text += path + QLatin1Char('\n');
    }
    return CommandOutput{
        QJsonDocument(QJsonObject{{"session_id", static_cast<double>(*id)}, {"files", files}}), text, 0};
}

} // namespace

std::vector<CommandSpec> sessionCommands() {
    CommandSpec listing;
    listing.group = QStringLiteral("session");
    listing.verb = QStringLiteral("list");
    listing.summary = QStringLiteral("the sessions that you may see; without --as the simulated ones");
    listing.options = {
        {QStringLiteral("exercise"), QStringLiteral("ID"), QStringLiteral("only of this exercise")},
        {QStringLiteral("limit"), QStringLiteral("N"), QStringLiteral("at most this many")},
        {QStringLiteral("archived"), {}, QStringLiteral("archived ones too")}};
    listing.example = QStringLiteral("chiron-cli session list --exercise sphere_apex");
    listing.run = list;
    CommandSpec showing = listing;
    showing.verb = QStringLiteral("show");
    showing.summary = QStringLiteral("one session with its scores");
    showing.operands = {{QStringLiteral("ID"), QStringLiteral("number of the session")}};
    showing.options = {};
    showing.example = QStringLiteral("chiron-cli session show 12 --json");
    showing.run = show;
    CommandSpec exporting = showing;
    exporting.verb = QStringLiteral("export");
    exporting.summary = QStringLiteral("write a session's samples (csv), what is known of it, with its "
                                       "events (json), or its motion and forces as a BIDS dataset (bids)");
    exporting.options = {
        {QStringLiteral("format"), QStringLiteral("csv,json,bids"),
         QStringLiteral("which; bids is a folder session_ID.bids that must not be there yet; default: csv")},
        {QStringLiteral("folder"), QStringLiteral("DIR"), QStringLiteral("where to; default: here")}};
    exporting.example = QStringLiteral("chiron-cli session export 12 --format csv,json --folder out");
    exporting.run = exportSession;
    return {listing, showing, exporting};
}

} // namespace chiron::cli
