// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/command_groups.h"
#include "cli/demo_pictures.h"
#include "cli/messages.h"
#include "cli/session_output.h"
#include "cli/site_access.h"
#include "cli/text_table.h"
#include "session/integrity_check.h"

#include <QDir>
#include <QFileInfo>
#include <QJsonArray>

namespace chiron::cli {

namespace {

QString valueOf(const scoring::ScoreCard& card, const char* id, int decimals) {
    for (const scoring::MetricValue& metric : card.metrics) {
        if (metric.id == id && metric.value)
            return QString::number(*metric.value, 'f', decimals);
    }
    return QStringLiteral("-");
}

const QString kLegend = QStringLiteral(
    "apex error: mean distance between mark and true highest point, in % of the sphere's radius; SD: its spread over the\n"
    "trials; misses: marked off the sphere, without touching, or not in time; max N: the largest force; passed: every pass\n"
    "mark of the level met; replay: forces simulated again from the recording; rescored: scores computed again from it\n");

QString resultsTable(const std::vector<session::DemoResult>& results) {
    TextTable table({">session", "person", "exercise", ">level", "operator", ">apex error %", ">SD %", ">misses",
                     ">time s", ">max N", "passed", "replay", "rescored"});
    for (const session::DemoResult& r : results) {
        const scoring::ScoreCard& card = r.result.scores;
        table.add({QString::number(r.result.session), QString::fromStdString(r.person),
                   QString::fromStdString(r.asked.exercise), QString::number(r.asked.level),
                   QString::fromStdString(r.asked.operatorName), valueOf(card, "apex_error_mean", 1),
                   valueOf(card, "apex_error_sd", 1), valueOf(card, "apex_misses", 0), valueOf(card, "time", 0),
                   valueOf(card, "force_max", 2), card.passed ? "yes" : "no",
                   r.replayIdentical ? "identical" : "DIFFERS", r.scoreSame ? "same" : "DIFFERS"});
    }
    return table.toText();
}

QJsonArray resultsJson(const std::vector<session::DemoResult>& results) {
    QJsonArray array;
    for (const session::DemoResult& r : results) {
        array.append(QJsonObject{{"session_id", static_cast<double>(r.result.session)},
                                 {"person", QString::fromStdString(r.person)},
                                 {"exercise", QString::fromStdString(r.asked.exercise)},
                                 {"level", r.asked.level},
                                 {"operator", QString::fromStdString(r.asked.operatorName)},
                                 {"passed", r.result.scores.passed},
                                 {"metrics", metricsJson(r.result.scores.metrics)},
                                 {"replay_identical", r.replayIdentical},
                                 {"score_same", r.scoreSame}});
    }
    return array;
}

/// Where a demonstration goes: --database and --folder, each beside the other where only one is given.
struct DemoPlace {
    QString database;
    QString folder;
};

core::Result<DemoPlace> placeFor(const Arguments& arguments) {
    DemoPlace place;
    if (arguments.has(QStringLiteral("folder")))
        place.folder = QFileInfo(arguments.value(QStringLiteral("folder"))).absoluteFilePath();
    place.database = !place.folder.isEmpty() && !arguments.has(QStringLiteral("database"))
                         ? QDir(place.folder).filePath(QStringLiteral("chiron.db"))
                         : databasePath(arguments);
    if (place.folder.isEmpty())
        place.folder = QFileInfo(place.database).absoluteDir().filePath(QStringLiteral("demonstration"));
    if (QFileInfo::exists(place.database))
        return badInput(QStringLiteral("%1: exists already; a demonstration is made in a fresh database").arg(quoted(place.database)));
    if (!QDir().mkpath(place.folder) || !QDir().mkpath(QFileInfo(place.database).absolutePath()))
        return core::fail(core::ErrorCode::storage, place.folder.toStdString() + ": the folder cannot be made");
    return place;
}

CommandOutput output(const DemoPlace& place, const std::vector<session::DemoResult>& results,
                     const DemoPictures& drawn, const database::VerifyReport& verified) {
    bool holds = verified.ok();
    for (const session::DemoResult& r : results)
        holds = holds && r.replayIdentical && r.scoreSame;
    QJsonArray pictures;
    for (const QString& picture : drawn.pictures)
        pictures.append(picture);
    const QJsonObject json{{"folder", place.folder}, {"database", place.database}, {"report", drawn.reportPdf},
                           {"pictures", pictures}, {"sessions", resultsJson(results)}, {"verify_ok", verified.ok()},
                           {"password", session::kDemoPassword}};
    const QString text = resultsTable(results) + QLatin1Char('\n') + kLegend + QLatin1Char('\n') +
                         alignedPairs({{"verify", verified.ok() ? "nothing wrong found" : QStringLiteral("%1 findings").arg(verified.findings.size())},
                                       {"folder", place.folder}, {"database", place.database}, {"report", drawn.reportPdf},
                                       {"people", QStringLiteral("amalia (administrator), theo, rhea, nikos, ines, eva; password %1").arg(session::kDemoPassword)}});
    return {QJsonDocument(json), text, holds ? 0 : 1};
}

core::Result<CommandOutput> demo(const Arguments& arguments) {
    auto seed = arguments.seed(QStringLiteral("seed"), 1);
    if (!seed)
        return tl::unexpected(seed.error());
    auto place = placeFor(arguments);
    if (!place)
        return tl::unexpected(place.error());
    auto content = catalogue::findContentDirectory();
    if (!content)
        return tl::unexpected(content.error());
    auto catalogue = catalogue::Catalogue::load(*content);
    if (!catalogue)
        return tl::unexpected(catalogue.error());
    database::DatabaseOptions options = databaseOptions();
    options.demonstration = true;
    auto site = session::openSite(place->database.toStdString(), options);
    if (!site)
        return tl::unexpected(site.error());
    auto results = session::makeDemoSite(*site->database, *catalogue, *seed,
                                         [](const session::DemoProgress& now) {
                                             tell(QStringLiteral("session %1 of %2: %3 level %4, %5")
                                                      .arg(now.session)
                                                      .arg(now.of)
                                                      .arg(QString::fromStdString(now.asked.exercise))
                                                      .arg(now.asked.level)
                                                      .arg(QString::fromStdString(now.asked.operatorName)));
                                         });
    if (!results)
        return tl::unexpected(results.error());
    auto drawn = drawDemo(*site->database, *results, place->folder);
    if (!drawn)
        return tl::unexpected(drawn.error());
    site->database.reset(); // verify looks at the file as the next program will find it
    tell(QStringLiteral("verifying"));
    const database::VerifyReport verified = session::verifyEverything(place->database.toStdString(), databaseOptions());
    return output(*place, *results, *drawn, verified);
}

} // namespace

std::vector<CommandSpec> demoCommands() {
    CommandSpec command;
    command.group = QStringLiteral("demo");
    command.summary = QStringLiteral("a demonstration site: people, every exercise by every scripted operator, reports");
    command.options = {{QStringLiteral("folder"), QStringLiteral("DIR"), QStringLiteral("receives report and pictures, and the database unless --database says otherwise")},
                       {QStringLiteral("seed"), QStringLiteral("S"), QStringLiteral("of everything; default: 1")}};
    command.example = QStringLiteral("chiron-cli demo --folder demonstration");
    command.draws = true;
    command.run = demo;
    return {command};
}

} // namespace chiron::cli
