// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/demo_pictures.h"

#include "database/accounts/account_service.h"
#include "report/report_writer.h"
#include "session_report/session_report.h"
#include "session_report/study_report.h"

#include <QDir>
#include <algorithm>

namespace chiron::cli {

namespace {

constexpr int kFeltAloneLevel = 2; // P2's condition: no visible object
constexpr int kCystoscopyLevel = 3; // P1's procedure, whole, in normal tissue
constexpr double kBendMark_deg = 15.0; // of the levels that have a bend (content/README.md)

const session::DemoResult* expertOf(const std::vector<session::DemoResult>& results, const char* exercise, int level) {
    const auto found = std::find_if(results.begin(), results.end(), [&](const session::DemoResult& r) {
        return r.asked.exercise == exercise && r.asked.operatorName == "expert" && r.asked.level == level;
    });
    return found != results.end() ? &*found : nullptr;
}

std::vector<double> trialErrors(const scoring::ScoreCard& card) {
    std::vector<double> values;
    for (const auto& trial : card.trials) {
        for (const scoring::MetricValue& metric : trial) {
            if (metric.id == "apex_error_mean" && metric.value)
                values.push_back(*metric.value);
        }
    }
    return values;
}

report::ComparisonData apexErrors(const std::vector<session::DemoResult>& results) {
    report::ComparisonData data;
    data.title = QStringLiteral("Apex error by operator, by touch alone");
    data.metricName = QStringLiteral("Apex error");
    data.unit = QStringLiteral("% of R");
    data.pointLabel = QStringLiteral("trial");
    data.reference = 14.2;
    data.referenceLabel = QStringLiteral("published mean of five people, 14.2 %");
    for (const session::DemoResult& result : results) {
        const bool shown = result.asked.exercise == "sphere_apex" && result.asked.level == kFeltAloneLevel;
        if (shown && result.person == "simulated")
            data.groups.push_back({QString::fromStdString(result.asked.operatorName), trialErrors(result.result.scores)});
    }
    return data;
}

/// One point a level that has a bend.
report::ComparisonData bendAlignment(const std::vector<session::DemoResult>& results) {
    report::ComparisonData data;
    data.title = QStringLiteral("Urethra insertion: alignment round the bend by operator");
    data.metricName = QStringLiteral("Alignment round the bend");
    data.unit = QStringLiteral("°");
    data.pointLabel = QStringLiteral("level");
    data.reference = kBendMark_deg;
    data.referenceLabel = QStringLiteral("pass mark, 15°");
    for (const session::DemoResult& result : results) {
        if (result.asked.exercise != "urethra_insertion" || result.person != "simulated")
            continue;
        const QString name = QString::fromStdString(result.asked.operatorName);
        auto group = std::find_if(data.groups.begin(), data.groups.end(), [&](const auto& g) { return g.name == name; });
        if (group == data.groups.end())
            group = data.groups.insert(data.groups.end(), {name, {}});
        for (const scoring::MetricValue& metric : result.result.scores.metrics) {
            if (metric.id == "curve_alignment" && metric.value)
                group->values.push_back(*metric.value);
        }
    }
    return data;
}

core::Result<void> addComparison(DemoPictures& drawn, const QString& file, const report::ComparisonData& data,
                                 const report::PlotTheme& theme) {
    if (data.groups.empty())
        return {};
    if (auto written = report::writeComparisonPng(file, data, theme); !written)
        return tl::unexpected(written.error());
    drawn.pictures.push_back(file);
    return {};
}

/// The session's report, and its plots where `plots` says so.
core::Result<void> addReport(DemoPictures& drawn, database::Database& database, const session::DemoResult& shown,
                             const QString& folder, const report::PlotTheme& theme, bool plots) {
    auto connection = database.openReader();
    if (!connection)
        return tl::unexpected(connection.error());
    const database::Actor actor = database::Actor::simulated();
    auto session = session::SessionView::open(**connection, actor, shown.result.session);
    if (!session)
        return tl::unexpected(session.error());
    auto data = session_report::reportDataOf(**session, **connection, actor, "en");
    if (!data)
        return tl::unexpected(data.error());
    const QString file = QDir(folder).filePath(QStringLiteral("session_%1.pdf").arg(shown.result.session));
    if (auto written = report::writeSessionPdf(file, *data, theme); !written)
        return tl::unexpected(written.error());
    drawn.reports.push_back(file);
    if (!plots)
        return {};
    auto pictures = report::writeSessionPngs(folder, *data, theme);
    if (!pictures)
        return tl::unexpected(pictures.error());
    drawn.pictures.insert(drawn.pictures.end(), pictures->begin(), pictures->end());
    return {};
}

/// As the demonstration's researcher, whose study it is.
core::Result<void> addStudyReport(DemoPictures& drawn, database::Database& database, const session::DemoStudy& study, const QString& folder,
                                  const report::PlotTheme& theme) {
    const auto author = database::AccountService(database).login(session::kDemoResearcher, session::kDemoPassword);
    if (!author)
        return tl::unexpected(author.error());
    auto connection = database.openReader();
    if (!connection)
        return tl::unexpected(connection.error());
    database::StudyReader reader(**connection, *author);
    const QString file = QDir(folder).filePath(QStringLiteral("study_%1.pdf").arg(study.study));
    if (auto written = session_report::writeStudyReport(file, reader, study.study, theme); !written)
        return written;
    drawn.reports.push_back(file);
    return {};
}

} // namespace

core::Result<DemoPictures> drawDemo(database::Database& database, const session::DemoSite& made, const QString& folder) {
    const std::vector<session::DemoResult>& results = made.sessions;
    DemoPictures drawn;
    const report::PlotTheme theme = report::lightTheme(QLocale(QLocale::English, QLocale::UnitedKingdom));
    if (!QDir().mkpath(folder))
        return core::fail(core::ErrorCode::storage, folder.toStdString() + ": the folder cannot be made");
    const auto file = [&](const char* name) { return QDir(folder).filePath(QLatin1String(name)); };
    if (auto added = addComparison(drawn, file("operators.png"), apexErrors(results), theme); !added)
        return tl::unexpected(added.error());
    if (auto added = addComparison(drawn, file("operators_urethra_insertion.png"), bendAlignment(results), theme); !added)
        return tl::unexpected(added.error());
    if (const auto* apex = expertOf(results, "sphere_apex", kFeltAloneLevel)) {
        if (auto added = addReport(drawn, database, *apex, folder, theme, true); !added)
            return tl::unexpected(added.error());
    }
    if (const auto* cystoscopy = expertOf(results, "urethra_insertion", kCystoscopyLevel)) {
        if (auto added = addReport(drawn, database, *cystoscopy, folder, theme, false); !added)
            return tl::unexpected(added.error());
    }
    if (auto added = addStudyReport(drawn, database, made.study, folder, theme); !added)
        return tl::unexpected(added.error());
    return drawn;
}

} // namespace chiron::cli
