// SPDX-License-Identifier: GPL-3.0-or-later
// Whole sessions of the elastic tube, one hand and two: they replay to the same bits, and their scores are
// the same from the run, from the recording and from the exported file.
#include "app/exercises/elastic_tube/session/planned_tube.h"
#include "curriculum/exercises/elastic_tube/scoring/tube_truth.h"
#include "modules/exercises/elastic_tube/simulation/elastic_tube_plan.h"
#include "scoring/score_calculator.h"
#include "scoring/trace_builder.h"
#include "scoring/trace_csv.h"
#include "session/replayer.h"
#include "session/session_export.h"
#include "support/session_fixture.h"

#include <QtTest>
#include <cmath>

using namespace chiron;
using tests::OpenStored;
using tests::SessionFixture;

namespace {

constexpr std::uint64_t kSeed = 7;

/// A shipped level with `trials` tubes of 30 s at most.
catalogue::ExerciseLevel shortTube(int number, int trials) {
    static const auto catalogue = catalogue::Catalogue::load(CHIRON_SOURCE_DIR "/curriculum/content");
    if (!catalogue)
        qFatal("%s", catalogue.error().message.c_str());
    QJsonObject json = QJsonDocument::fromJson(
                           QByteArray::fromStdString(catalogue->find("elastic_tube", number)->resolvedJson))
                           .object();
    QJsonObject level = json["level"].toObject();
    QJsonObject parameters = level["parameters"].toObject();
    parameters["trials"] = trials;
    parameters["trial_limit_s"] = 30;
    level["parameters"] = parameters;
    json["level"] = level;
    auto changed =
        catalogue::fromResolvedJson(QJsonDocument(json).toJson(QJsonDocument::Compact).toStdString());
    if (!changed)
        qFatal("%s", changed.error().message.c_str());
    return *changed;
}

/// An ideal hand at the first tube: on its end, jaw closed, up until the tension (or length) is there in
/// `pull_s`, and still.
scoring::TraceRows idealPull(const catalogue::ExerciseLevel& level, double pull_s) {
    const auto& p = level.parameters.as<simulation::ElasticTubeParameters>();
    const simulation::ElasticTubeTrial trial = simulation::planElasticTubeTrials(p, kSeed).front();
    const double b = p.tube.stiffening_per_m, k = trial.stiffness_N_per_m;
    double stretch_m = (p.markRatio - 1.0) * p.restLength_m;
    if (trial.target_N > 0.0)
        stretch_m = b > 0.0 ? std::log1p(b * trial.target_N / k) / b : trial.target_N / k;
    scoring::TraceRows rows;
    rows.source = "pull.csv";
    rows.columns.jaw = true;
    for (int i = 0; i <= static_cast<int>(1e3 * (pull_s + p.hold_s + 3.0)); ++i) {
        scoring::TraceRow row;
        row.t_s = 1e-3 * i;
        const double x = std::clamp((row.t_s - 1.5) / pull_s, 0.0, 1.0);
        const double way = x * x * x * (10.0 + x * (-15.0 + 6.0 * x));
        row.p_WT_m = {trial.base_m.x(), trial.base_m.y(), p.restLength_m + way * stretch_m};
        row.jaw_rad = row.t_s < 1.0 ? 0.7 : 0.05;
        rows.rows.push_back(row);
    }
    return rows;
}

double valueOf(const scoring::ScoreCard& card, const std::string& id) {
    for (const scoring::MetricValue& metric : card.metrics)
        if (metric.id == id)
            return metric.value.value_or(std::nan(""));
    return std::nan("");
}

} // namespace

class TestElasticTubeIsKept : public QObject {
    Q_OBJECT
private slots:
    void anIdealHand_data();
    void anIdealHand();
    void scriptedHands_data();
    void scriptedHands();

private:
    /// Replayed, computed again, and read back from the exported file: always the same.
    void isKept(SessionFixture& site, const catalogue::ExerciseLevel& level,
                const session::TrainingResult& result);
};

void TestElasticTubeIsKept::isKept(SessionFixture& site, const catalogue::ExerciseLevel& level,
                                   const session::TrainingResult& result) {
    OpenStored stored(*site.database, result.session);
    const auto replay = session::replaySession(*stored.session);
    QVERIFY2(replay, replay ? "" : replay.error().message.c_str());
    QVERIFY(replay->comparable && replay->identical);
    const auto again = stored.session->computeScores();
    QVERIFY(again && session::sameScores(*again, result.scores));

    const QString path = QString::fromStdString(site.folder() + "/tube.csv");
    const auto done = session::exportCsv(*stored.session, path);
    QVERIFY2(done, done ? "" : done.error().message.c_str());
    const auto rows = scoring::readTraceCsvFile(path.toStdString());
    QVERIFY2(rows, rows ? "" : rows.error().message.c_str());
    const auto trace = scoring::buildSessionTrace(*rows, "elastic_tube");
    QVERIFY2(trace, trace ? "" : trace.error().message.c_str());
    // The typed truth is the planned one, from the recording and from the file, and costs no further reading.
    const int decodings = stored.session->decodings();
    const auto truths = stored.session->truths(scoring::tubeTruthOf);
    QVERIFY2(truths, truths ? "" : truths.error().message.c_str());
    QCOMPARE(stored.session->decodings(), decodings);
    const session::SessionSetup& setup = stored.session->setup();
    const auto planned =
        session::plannedTubes(setup.level.parameters.as<simulation::ElasticTubeParameters>(), setup.seed);
    QVERIFY(!truths->empty() && truths->size() == trace->trials.size() && truths->size() <= planned.size());
    for (std::size_t i = 0; i < truths->size(); ++i) {
        QVERIFY((*truths)[i] == planned[i] && (*truths)[i].overStretch_m && (*truths)[i].task);
        QVERIFY(scoring::tubeTruthIn(trace->trials[i]) == planned[i]);
    }
    std::vector<scoring::MetricRequest> wanted;
    for (const auto& metric : level.metrics)
        wanted.push_back({metric.id, metric.version});
    const auto card = scoring::calculateScore(*trace, wanted, level.gates, true);
    QVERIFY2(card, card ? "" : card.error().message.c_str());
    for (std::size_t i = 0; i < card->metrics.size(); ++i)
        QVERIFY2(card->metrics[i].value == result.scores.metrics[i].value, card->metrics[i].id.c_str());
    QVERIFY(session::sameScores(*card, result.scores));
}

void TestElasticTubeIsKept::anIdealHand_data() {
    QTest::addColumn<int>("number");
    for (int number = 1; number <= 3; ++number)
        QTest::newRow(shortTube(number, 1).id.c_str()) << number;
}

void TestElasticTubeIsKept::anIdealHand() {
    QFETCH(int, number);
    const catalogue::ExerciseLevel level = shortTube(number, 1);
    session::TrainingRequest request;
    request.level = level;
    request.seed = kSeed;
    request.ringFolder = recording::defaultRingFolder();
    auto station = session::traceStation(idealPull(level, 2.0), session::PointerTool::grasper);
    QVERIFY2(station, station ? "" : station.error().message.c_str());
    request.station = std::move(*station);
    SessionFixture site;
    const auto result = site.run(std::move(request));
    QVERIFY2(result, result ? "" : result.error().message.c_str());
    const double hold_s = level.parameters.as<simulation::ElasticTubeParameters>().hold_s;
    const scoring::ScoreCard& card = result->scores;
    QCOMPARE(valueOf(card, "procedure_completed"), 100.0);
    QCOMPARE(valueOf(card, "over_stretches"), 0.0);
    QCOMPARE(valueOf(card, "drops"), 0.0);
    QVERIFY2(std::abs(valueOf(card, "time_in_band") - hold_s) < 0.005,
             qPrintable(QString::number(valueOf(card, "time_in_band"))));
    QVERIFY(card.passed);
    if (number != 2) // at the band's edge first, on the target from 0.2 s on
        QVERIFY2(valueOf(card, "tension_error_rms") < 0.05,
                 qPrintable(QString::number(valueOf(card, "tension_error_rms"))));
    isKept(site, level, *result);
}

void TestElasticTubeIsKept::scriptedHands_data() {
    QTest::addColumn<int>("number");
    for (int number = 1; number <= 5; ++number)
        QTest::newRow(shortTube(number, 2).id.c_str()) << number;
}

void TestElasticTubeIsKept::scriptedHands() {
    QFETCH(int, number);
    const catalogue::ExerciseLevel level = shortTube(number, 2);
    SessionFixture site;
    const auto result = site.run(site.request(level, "expert", kSeed));
    QVERIFY2(result, result ? "" : result.error().message.c_str());
    QCOMPARE(valueOf(result->scores, "procedure_completed"), 100.0);
    QCOMPARE(valueOf(result->scores, "over_stretches"), 0.0);
    isKept(site, level, *result);
}

QTEST_GUILESS_MAIN(TestElasticTubeIsKept)
#include "test_elastic_tube_is_kept.moc"
