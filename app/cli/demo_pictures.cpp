// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/demo_pictures.h"

#include "cli/cli_errors.h"
#include "database/accounts/account_service.h"
#include "report/report_writer.h"
#include "session/exercise_kind.h"
#include "session_report/session_report.h"
#include "session_report/study_report.h"

#include <QDir>
#include <algorithm>
#include <span>

namespace chiron::cli {

namespace {

const session::DemoResult* expertOf(const std::vector<session::DemoResult>& results,
                                    const std::string& exercise, int level) {
    const auto found = std::find_if(results.begin(), results.end(), [&](const session::DemoResult& r) {
        return r.asked.exercise == exercise && r.asked.operatorName == "expert" && r.asked.level == level;
    });
    return found != results.end() ? &*found : nullptr;
}

void addValues(std::span<const scoring::MetricValue> metrics, const std::string& id,
               std::vector<double>& values) {
    for (const scoring::MetricValue& metric : metrics)
        if (metric.id == id && metric.value)
            values.push_back(*metric.value);
}

/// The points of the plot are the trials of one level, or the levels.
report::ComparisonData operatorsOf(const std::vector<session::DemoResult>& results,
                                   const std::string& exercise, const session::OperatorComparison& shown) {
    report::ComparisonData data;
    data.title = QString::fromStdString(shown.title);
    data.metricName = QString::fromStdString(shown.metricName);
    data.unit = QString::fromStdString(shown.unit);
    data.pointLabel = shown.level > 0 ? QStringLiteral("trial") : QStringLiteral("level");
    data.reference = shown.reference;
    data.referenceLabel = QString::fromStdString(shown.referenceLabel);
    for (const session::DemoResult& result : results) {
        if (result.asked.exercise != exercise || result.person != "simulated" ||
            (shown.level > 0 && result.asked.level != shown.level))
            continue;
        const QString name = QString::fromStdString(result.asked.operatorName);
        auto group = std::find_if(data.groups.begin(), data.groups.end(),
                                  [&](const auto& g) { return g.name == name; });
        if (group == data.groups.end())
            group = data.groups.insert(data.groups.end(), {name, {}});
        if (shown.level == 0)
            addValues(result.result.scores.metrics, shown.metric, group->values);
        else
            for (const auto& trial : result.result.scores.trials)
                addValues(trial, shown.metric, group->values);
    }
    return data;
}

core::Result<void> addComparison(DemoPictures& drawn, const QString& file, const report::ComparisonData& data,
                                 const report::PlotTheme& theme) {
    if (data.groups.empty())
        return {};
    CHIRON_TRY(report::writeComparisonPng(file, data, theme));
    drawn.pictures.push_back(file);
    return {};
}

/// Draws the report of the session, and its plots if `plots` is true.
core::Result<void> addReport(DemoPictures& drawn, database::Database& database,
                             const session::DemoResult& shown, const QString& folder,
                             const report::PlotTheme& theme, bool plots) {
    auto connection = database.openReader();
    CHIRON_TRY(connection);
    const database::Actor actor = database::Actor::simulated();
    auto session = session::SessionView::open(**connection, actor, shown.result.session);
    CHIRON_TRY(session);
    auto data = session_report::reportDataOf(**session, **connection, actor, "en");
    CHIRON_TRY(data);
    const QString file = QDir(folder).filePath(QStringLiteral("session_%1.pdf").arg(shown.result.session));
    CHIRON_TRY(report::writeSessionPdf(file, *data, theme));
    drawn.reports.push_back(file);
    if (!plots)
        return {};
    auto pictures = report::writeSessionPngs(folder, *data, theme);
    CHIRON_TRY(pictures);
    drawn.pictures.insert(drawn.pictures.end(), pictures->begin(), pictures->end());
    return {};
}

/// Draws the study's report as the demonstration's researcher, who owns the study.
core::Result<void> addStudyReport(DemoPictures& drawn, database::Database& database,
                                  const session::DemoStudy& study, const QString& folder,
                                  const report::PlotTheme& theme) {
    const auto author =
        database::AccountService(database).login(session::kDemoResearcher, session::kDemoPassword);
    CHIRON_TRY(author);
    auto connection = database.openReader();
    CHIRON_TRY(connection);
    database::StudyReader reader(**connection, *author);
    const QString file = QDir(folder).filePath(QStringLiteral("study_%1.pdf").arg(study.study));
    CHIRON_TRY(session_report::writeStudyReport(file, reader, study.study, theme));
    drawn.reports.push_back(file);
    return {};
}

} // namespace

std::vector<std::string> exercisesOf(const std::vector<session::DemoResult>& results) {
    std::vector<std::string> exercises;
    for (const session::DemoResult& result : results)
        if (std::find(exercises.begin(), exercises.end(), result.asked.exercise) == exercises.end())
            exercises.push_back(result.asked.exercise);
    return exercises;
}

core::Result<DemoPictures> drawDemo(database::Database& database, const session::DemoSite& made,
                                    const QString& folder) {
    const std::vector<session::DemoResult>& results = made.sessions;
    DemoPictures drawn;
    const report::PlotTheme theme = report::lightTheme(QLocale(QLocale::English, QLocale::UnitedKingdom));
    if (!QDir().mkpath(folder))
        return noFolder(folder);
    const auto file = [&](const std::string& name) {
        return QDir(folder).filePath(QString::fromStdString(name));
    };
    struct Shown {
        std::string exercise;
        session::Demonstration how;
    };
    std::vector<Shown> exercises;
    for (const std::string& exercise : exercisesOf(results)) {
        auto kind = session::exerciseKind(exercise);
        CHIRON_TRY(kind);
        exercises.push_back({exercise, (*kind)->demonstration()});
    }
    for (const auto& [exercise, how] : exercises)
        if (how.comparison)
            CHIRON_TRY(addComparison(drawn, file(how.comparison->file),
                                     operatorsOf(results, exercise, *how.comparison), theme));
    for (const auto& [exercise, how] : exercises)
        if (const auto* expert = how.report ? expertOf(results, exercise, how.report->level) : nullptr)
            CHIRON_TRY(addReport(drawn, database, *expert, folder, theme, how.report->plots));
    CHIRON_TRY(addStudyReport(drawn, database, made.study, folder, theme));
    return drawn;
}

} // namespace chiron::cli
