// SPDX-License-Identifier: GPL-3.0-or-later
// What the printed report tells of a palpation: findings, missed lumps, sensitivity, maps.
// CHIRON_KEEP_PICTURES=<folder> keeps it.
#include "../../unit/scoring/palpation_traces.h"
#include "app/exercises/palpation/session_report/palpation_report.h"
#include "modules/exercises/sphere_apex/simulation/sphere_apex_parameters.h"
#include "report/report_writer.h"
#include "support/image_region.h"

#include <QtTest>
#include <cmath>

using namespace chiron;
using report::PalpationFindingRow;
using tests::MadeTrial;

namespace {

bool isNear(double a, double b) {
    return std::abs(a - b) < 1e-9;
}

catalogue::ExerciseLevel level() {
    catalogue::ExerciseLevel out;
    out.exercise = "palpation";
    simulation::PalpationParameters p;
    p.areaHalf_m = {0.03, 0.03};
    out.parameters = p;
    return out;
}

/// A hit 3 mm away whose size is said 1 mm too large, a false alarm, a missed lump; pressed along a row.
scoring::TrialTrace searched() {
    MadeTrial trial({{0.0, 0.0, 0.006, 5}, {-0.02, 0.02, 0.005, 3}});
    trial.found(0, 0.003, 0.0, 4, 5, 70).found(1, 0.02, -0.02, 1).press(0, 0, 90, 1.0);
    for (std::size_t i = 0; i < 90; ++i)
        trial.trial().tools[0].p_WT_m[i] = {-0.027 + 0.0006 * static_cast<double>(i), 0.0, -0.002};
    return trial;
}

report::ReportData dataOf(const std::vector<scoring::TrialTrace>& trials) {
    report::ReportData data;
    data.person = QStringLiteral("Dr Ada Example");
    data.exerciseTitle = QStringLiteral("Palpation");
    data.exerciseId = QStringLiteral("palpation");
    data.state = QStringLiteral("completed");
    if (auto section = session_report::palpationSectionOf(tests::palpationSession(trials), level()))
        data.sections.push_back(std::move(section));
    return data;
}

QByteArray pdfOf(const report::ReportData& data, const QString& path) {
    const auto done = report::writeSessionPdf(
        path, data, report::lightTheme(QLocale(QLocale::English, QLocale::UnitedKingdom)));
    QFile file(path);
    return done && file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

} // namespace

class TestPalpationReport : public QObject {
    Q_OBJECT
private slots:
    void rows() {
        const auto out = session_report::palpationReportOf(tests::palpationSession({searched()}), level());
        QVERIFY(out && out->trials.size() == 1);
        const auto& trial = out->trials[0];
        QCOMPARE(trial.rows.size(), std::size_t{3});
        const PalpationFindingRow& hit = trial.rows[0];
        QVERIFY(hit.kind == PalpationFindingRow::Kind::hit && hit.number == 1 && hit.confidence == 4 &&
                hit.hardness == 5);
        QVERIFY(isNear(hit.x_mm, 3.0) && isNear(hit.radius_mm, 7.0) && isNear(*hit.error_mm, 3.0) &&
                isNear(*hit.sizeError_mm, 1.0));
        QVERIFY(trial.rows[1].kind == PalpationFindingRow::Kind::falseAlarm && !trial.rows[1].error_mm &&
                !trial.rows[1].sizeError_mm);
        const PalpationFindingRow& missed = trial.rows[2];
        QVERIFY(missed.kind == PalpationFindingRow::Kind::missed && missed.number == 0 &&
                isNear(missed.radius_mm, 5.0) && missed.hardness == 3);
        QVERIFY((out->regions == core::DetectionCounts{1, 2, 1, 7}));
    }

    void truthOnTheMap() {
        const auto out = session_report::palpationReportOf(tests::palpationSession({searched()}), level());
        const auto& view = out->trials[0].view;
        QVERIFY(view.lumps.size() == 2 && view.lumps[0].found && !view.lumps[1].found);
        QVERIFY(view.findings[0].outcome == simulation::FindingOutcome::hit &&
                view.findings[1].outcome == simulation::FindingOutcome::falseAlarm);
        QCOMPARE(view.regionColumns, 3);
        QVERIFY(out->trials[0].map.coverage() > 0.1 &&
                out->trials[0].map.coverage() < 0.25); // a row of 54 × 10 mm of 60 × 60
    }

    void nothingToTell() {
        scoring::TrialTrace bare = searched();
        bare.quantities.clear();
        QVERIFY(!session_report::palpationReportOf(tests::palpationSession({bare}), level()));
        catalogue::ExerciseLevel other = level();
        other.parameters = simulation::SphereApexParameters{};
        QVERIFY(!session_report::palpationReportOf(tests::palpationSession({searched()}), other));
        QVERIFY(!session_report::palpationReportOf(tests::palpationSession({}), level()));
    }

    /// The maps take room: three a page, so that nine trials take at least two pages more than none.
    void pages() {
        QTemporaryDir temporary;
        const QString folder = qEnvironmentVariable("CHIRON_KEEP_PICTURES", temporary.path());
        const auto pagesOf = [&](const std::vector<scoring::TrialTrace>& trials, const char* name) {
            return static_cast<int>(pdfOf(dataOf(trials), folder + QLatin1Char('/') + QLatin1String(name))
                                        .count("/Type /Page\n"));
        };
        const int none = pagesOf({}, "palpation_none.pdf");
        std::vector<scoring::TrialTrace> trials(7, searched());
        trials.push_back(MadeTrial());
        trials.push_back(MadeTrial({{0.0, 0.0}}).timedOut());
        const int nine = pagesOf(trials, "palpation.pdf");
        QVERIFY2(none >= 1 && nine >= none + 2, qPrintable(QStringLiteral("%1, %2").arg(none).arg(nine)));
    }

    void pictures() {
        QTemporaryDir temporary;
        const QString folder = qEnvironmentVariable("CHIRON_KEEP_PICTURES", temporary.path());
        const auto theme = report::lightTheme(QLocale(QLocale::English, QLocale::UnitedKingdom));
        const auto written =
            report::writeSessionPngs(folder, dataOf({searched(), scoring::TrialTrace(MadeTrial())}), theme);
        QVERIFY(written && written->size() == 5);
        const QImage searchedMap(folder + QStringLiteral("/palpation_1.png"));
        const QImage emptyMap(folder + QStringLiteral("/palpation_2.png"));
        QVERIFY(searchedMap.width() == 2800 && searchedMap.size() == emptyMap.size() &&
                searchedMap != emptyMap);
        QVERIFY(tests::regionOf(searchedMap, theme.paper).contains(QPoint(0, 0)));
        bool wide = false, high = false; // drawn at twice its size, not in a corner
        for (int y = 0; y < searchedMap.height(); ++y)
            for (int x = 0; x < searchedMap.width(); ++x)
                if (searchedMap.pixelColor(x, y) != theme.paper) {
                    wide = wide || x > searchedMap.width() / 2;
                    high = high || y > searchedMap.height() / 2;
                }
        QVERIFY(wide && high);
    }

    void enoughRegionsForSensitivity() {
        QTemporaryDir folder;
        std::vector<scoring::TrialTrace> many(20, searched());
        const auto data = dataOf(many);
        const auto found = session_report::palpationReportOf(tests::palpationSession(many), level());
        QVERIFY(found && core::isUsable(found->regions));
        QVERIFY(!pdfOf(data, folder.filePath(QStringLiteral("many.pdf"))).isEmpty());
    }
};

QTEST_MAIN(TestPalpationReport)
#include "test_palpation_report.moc"
