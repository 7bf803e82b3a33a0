// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/demo_pictures.h"

#include "report/report_writer.h"
#include "session_report/session_report.h"

#include <QDir>
#include <algorithm>

namespace chiron::cli {

namespace {

constexpr int kFeltAloneLevel = 2; // P2's condition: no visible object

const session::DemoResult* shownSession(const std::vector<session::DemoResult>& results) {
    const auto found = std::find_if(results.begin(), results.end(), [](const session::DemoResult& r) {
        return r.asked.operatorName == "expert" && r.asked.level == kFeltAloneLevel;
    });
    return found != results.end() ? &*found : results.empty() ? nullptr : &results.front();
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

report::ComparisonData comparisonOf(const std::vector<session::DemoResult>& results) {
    report::ComparisonData data;
    data.title = QStringLiteral("Apex error by operator, by touch alone");
    data.metricName = QStringLiteral("Apex error");
    data.unit = QStringLiteral("% of R");
    data.pointLabel = QStringLiteral("trial");
    data.reference = 14.2;
    data.referenceLabel = QStringLiteral("published mean of five people, 14.2 %");
    for (const session::DemoResult& result : results) {
        if (result.asked.level == kFeltAloneLevel && result.person == "simulated")
            data.groups.push_back({QString::fromStdString(result.asked.operatorName), trialErrors(result.result.scores)});
    }
    return data;
}

} // namespace

core::Result<DemoPictures> drawDemo(database::Database& database, const std::vector<session::DemoResult>& results,
                                    const QString& folder) {
    DemoPictures drawn;
    const report::PlotTheme theme = report::lightTheme(QLocale(QLocale::English, QLocale::UnitedKingdom));
    if (!QDir().mkpath(folder))
        return core::fail(core::ErrorCode::storage, folder.toStdString() + ": the folder cannot be made");
    const QString comparison = QDir(folder).filePath(QStringLiteral("operators.png"));
    if (auto written = report::writeComparisonPng(comparison, comparisonOf(results), theme); !written)
        return tl::unexpected(written.error());
    drawn.pictures.push_back(comparison);
    const session::DemoResult* shown = shownSession(results);
    if (!shown)
        return drawn;
    auto connection = database.openReader();
    if (!connection)
        return tl::unexpected(connection.error());
    const database::Actor actor = database::Actor::simulated();
    auto session = session::StoredSession::open(**connection, actor, shown->result.session);
    if (!session)
        return tl::unexpected(session.error());
    auto data = session_report::reportDataOf(**session, **connection, actor, "en");
    if (!data)
        return tl::unexpected(data.error());
    drawn.reportPdf = QDir(folder).filePath(QStringLiteral("session_%1.pdf").arg(shown->result.session));
    if (auto written = report::writeSessionPdf(drawn.reportPdf, *data, theme); !written)
        return tl::unexpected(written.error());
    auto plots = report::writeSessionPngs(folder, *data, theme);
    if (!plots)
        return tl::unexpected(plots.error());
    drawn.pictures.insert(drawn.pictures.end(), plots->begin(), plots->end());
    return drawn;
}

} // namespace chiron::cli
