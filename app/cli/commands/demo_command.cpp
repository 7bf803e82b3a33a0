// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/cli_errors.h"
#include "cli/command_groups.h"
#include "cli/demo_pictures.h"
#include "cli/demo_study_table.h"
#include "cli/session_output.h"
#include "cli/site_access.h"
#include "cli/text_table.h"
#include "session/exercise_kind.h"
#include "session/integrity_check.h"

#include <QDir>
#include <QFileInfo>
#include <QJsonArray>
#include <algorithm>

namespace chiron::cli {

namespace {

QString valueOf(const scoring::ScoreCard& card, const std::string& id, int decimals) {
    for (const scoring::MetricValue& metric : card.metrics) {
        if (metric.id == id && metric.value)
            return QString::number(*metric.value, 'f', decimals);
    }
    return QStringLiteral("-");
}

const QString kLegend = QStringLiteral("max N: the largest force of the tissue; passed: every pass mark of "
                                       "the level met; replay: forces simulated again from the\n"
                                       "recording; rescored: scores computed again from it\n");

QString resultsTable(const std::vector<session::DemoResult>& results, const std::string& exercise,
                     const session::Demonstration& shown) {
    QStringList headings{">session", "person", ">level", "operator"};
    for (const session::DemoColumn& column : shown.columns)
        headings << QString::fromStdString(column.heading);
    TextTable table(headings + QStringList{">time s", ">max N", "passed", "replay", "rescored"});
    for (const session::DemoResult& r : results) {
        if (r.asked.exercise != exercise)
            continue;
        const scoring::ScoreCard& card = r.result.scores;
        QStringList cells{QString::number(r.result.session), QString::fromStdString(r.person),
                          QString::number(r.asked.level), QString::fromStdString(r.asked.operatorName)};
        for (const session::DemoColumn& column : shown.columns)
            cells << valueOf(card, column.metric, column.decimals);
        table.add(cells + QStringList{valueOf(card, "time", 0), valueOf(card, "force_max", 2),
                                      card.passed ? "yes" : "no", r.replayIdentical ? "identical" : "DIFFERS",
                                      r.scoreSame ? "same" : "DIFFERS"});
    }
    return QString::fromStdString(exercise) + QLatin1Char('\n') + table.toText() + QLatin1Char('\n') +
           QString::fromStdString(shown.legend) + QLatin1Char('\n');
}

/// One table per exercise, in the order in which the exercises were done.
QString resultsTables(const std::vector<session::DemoResult>& results) {
    QString text;
    for (const std::string& exercise : exercisesOf(results)) {
        const auto kind = session::exerciseKind(exercise);
        text += resultsTable(results, exercise, kind ? (*kind)->demonstration() : session::Demonstration{});
    }
    return text;
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

/// Where a demonstration is stored: --database and --folder. If only one is given, the other is placed beside
/// it.
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
        return badInput(QStringLiteral("%1: exists already; expected a file that does not exist yet, because "
                                       "a demonstration is made in a database of its own")
                            .arg(quoted(place.database)));
    if (!QDir().mkpath(place.folder) || !QDir().mkpath(QFileInfo(place.database).absolutePath()))
        return noFolder(place.folder);
    return place;
}

CommandOutput output(const DemoPlace& place, const session::DemoSite& made, const DemoPictures& drawn,
                     const database::VerifyReport& verified) {
    QJsonArray pictures;
    for (const QString& picture : drawn.pictures)
        pictures.append(picture);
    QJsonArray reports;
    QStringList reportFiles;
    for (const QString& report : drawn.reports) {
        reports.append(report);
        reportFiles << report;
    }
    const QJsonObject json{{"folder", place.folder},
                           {"database", place.database},
                           {"reports", reports},
                           {"pictures", pictures},
                           {"sessions", resultsJson(made.sessions)},
                           {"study", demoStudyJson(made.study)},
                           {"verify_ok", verified.ok()},
                           {"password", session::kDemoPassword}};
    const QString text =
        resultsTables(made.sessions) + kLegend + QLatin1Char('\n') + demoStudyTable(made.study) +
        QLatin1Char('\n') +
        alignedPairs(
            {{"verify", verified.ok() ? "nothing wrong found"
                                      : QStringLiteral("%1 findings").arg(verified.findings.size())},
             {"folder", place.folder},
             {"database", place.database},
             {"reports", reportFiles.join(QStringLiteral(", "))},
             {"people", QStringLiteral("amalia (administrator), theo, rhea, nikos, ines, eva; password %1")
                            .arg(session::kDemoPassword)}});
    return {QJsonDocument(json), text, verified.ok() && made.holds() ? 0 : 1};
}

core::Result<CommandOutput> demo(const Arguments& arguments) {
    auto seed = arguments.seed(QStringLiteral("seed"), 1);
    CHIRON_TRY(seed);
    auto place = placeFor(arguments);
    CHIRON_TRY(place);
    auto content = catalogue::findContentDirectory();
    CHIRON_TRY(content);
    auto catalogue = catalogue::Catalogue::load(*content);
    CHIRON_TRY(catalogue);
    database::DatabaseOptions options = databaseOptions();
    options.demonstration = true;
    auto site = session::openSite(place->database.toStdString(), options);
    CHIRON_TRY(site);
    auto made =
        session::makeDemoSite(*site->database, *catalogue, *seed, [](const session::DemoProgress& now) {
            tell(QStringLiteral("step %1 of %2: %3")
                     .arg(now.step)
                     .arg(now.of)
                     .arg(QString::fromStdString(now.doing)));
        });
    CHIRON_TRY(made);
    auto drawn = drawDemo(*site->database, *made, place->folder);
    CHIRON_TRY(drawn);
    site->database.reset(); // verify must read the file as the next program will find it
    tell(QStringLiteral("verifying"));
    const database::VerifyReport verified =
        session::verifyEverything(place->database.toStdString(), databaseOptions());
    return output(*place, *made, *drawn, verified);
}

} // namespace

std::vector<CommandSpec> demoCommands() {
    CommandSpec command;
    command.group = QStringLiteral("demo");
    command.summary = QStringLiteral("a demonstration site: people, every exercise by every scripted "
                                     "operator, a study by simulated participants, reports");
    command.options = {
        {QStringLiteral("folder"), QStringLiteral("DIR"),
         QStringLiteral("receives report and pictures, and the database unless --database says otherwise")},
        {QStringLiteral("seed"), QStringLiteral("S"), QStringLiteral("of everything; default: 1")}};
    command.example = QStringLiteral("chiron-cli demo --folder demonstration");
    command.draws = true;
    command.run = demo;
    return {command};
}

} // namespace chiron::cli
