// SPDX-License-Identifier: GPL-3.0-or-later
// A whole insertion, played from a trace: its scores are those of its path, they are the same from the
// recording and from the exported file, and what they count is marked in playback.
#include "app/exercises/urethra_insertion/session/insertion_marks.h"
#include "core/units.h"
#include "curriculum/exercises/urethra_insertion/scoring/canal_series.h"
#include "database/repositories/score_repository.h"
#include "database/repositories/session_reader.h"
#include "modules/exercises/urethra_insertion/simulation/procedure_plan.h"
#include "scoring/score_calculator.h"
#include "scoring/trace_builder.h"
#include "scoring/trace_csv.h"
#include "session/session_export.h"
#include "support/looked_back.h"
#include "support/session_fixture.h"

#include <QtTest>
#include <algorithm>

using namespace chiron;
namespace mark_kinds = session::mark_kinds;
using tests::OpenStored;
using tests::SessionFixture;

namespace {

constexpr double kOffset_m = 0.0012;
constexpr double kTilt_rad = 6.0 * core::kPi / 180.0;

/// Minimum jerk from 0 to 1 (Flash & Hogan 1985).
double reach(double t, double begin_s, double end_s) {
    const double x = std::clamp((t - begin_s) / (end_s - begin_s), 0.0, 1.0);
    return x * x * x * (10.0 + x * (-15.0 + 6.0 * x));
}

/// 2 s before the entrance, 50 mm in, 4 mm back, on to 62 mm, and out again.
double arcAt(double t) {
    return -0.020 + 0.070 * reach(t, 2.0, 5.0) - 0.004 * reach(t, 5.2, 5.8) + 0.016 * reach(t, 6.0, 8.0) -
           0.085 * reach(t, 8.5, 12.5);
}

const catalogue::ExerciseLevel& guided() {
    static const auto catalogue = catalogue::Catalogue::load(CHIRON_SOURCE_DIR "/curriculum/content");
    if (!catalogue)
        qFatal("%s", catalogue.error().message.c_str());
    return *catalogue->find("urethra_insertion", 1);
}

/// Beside the centre-line by kOffset_m and tilted by kTilt_rad about the normal of its plane.
scoring::TraceRows path(double duration_s) {
    const auto& p = guided().parameters.as<simulation::UrethraInsertionParameters>();
    const simulation::UrethraCentreline line(p.anatomy);
    scoring::TraceRows rows;
    rows.source = "insertion.csv";
    rows.columns.orientation = true;
    for (int i = 0; i <= static_cast<int>(std::lround(duration_s * 1e3)); ++i) {
        const auto at = line.at(arcAt(1e-3 * i));
        core::Mat3 r_AT;
        r_AT.col(2) = -at.t_A;
        r_AT.col(1) = at.n_A;
        r_AT.col(0) = at.n_A.cross(-at.t_A);
        const core::Quat q_AT =
            core::Quat(Eigen::AngleAxisd(kTilt_rad, core::Vec3::UnitX())) * core::Quat(r_AT);
        scoring::TraceRow row;
        row.t_s = 1e-3 * i;
        row.p_WT_m = p.pose.pointToW(at.p_A + kOffset_m * core::Vec3::UnitX());
        row.q_WT = (p.pose.q_WA * q_AT).normalized();
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

class TestInsertionScoreIsKept : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void scoresAreThoseOfThePath();
    void storedAndRecomputedAgree();
    void exportedTraceAgrees();
    void trialAndEventsAreStored();
    void penaltiesAreMarks();
    void unfinishedProcedure();
    void cleanupTestCase() { m_site.reset(); }

private:
    session::TrainingResult play(double duration_s) {
        session::TrainingRequest request;
        request.level = guided();
        request.seed = 3;
        request.ringFolder = recording::defaultRingFolder();
        auto station = session::traceStation(path(duration_s), session::PointerTool::endoscope);
        if (!station)
            qFatal("%s", station.error().message.c_str());
        request.station = std::move(*station);
        auto result = m_site->run(std::move(request));
        if (!result)
            qFatal("%s", result.error().message.c_str());
        return std::move(*result);
    }
    std::vector<database::EventRecord> eventsOf(database::SessionId id) {
        auto connection = m_site->database->openReader();
        return *database::SessionReader(**connection, database::Actor::simulated()).events(id);
    }
    database::TrialRecord trialOf(database::SessionId id) {
        auto connection = m_site->database->openReader();
        return database::SessionReader(**connection, database::Actor::simulated()).trials(id)->at(0);
    }

    std::unique_ptr<SessionFixture> m_site;
    session::TrainingResult m_result;
};

void TestInsertionScoreIsKept::initTestCase() {
    m_site = std::make_unique<SessionFixture>();
    m_result = play(13.0);
}

void TestInsertionScoreIsKept::scoresAreThoseOfThePath() {
    const scoring::ScoreCard& card = m_result.scores;
    QVERIFY(std::abs(valueOf(card, "offset_rms") - 1.2) < 0.002);
    QVERIFY(std::abs(valueOf(card, "offset_max") - 1.2) < 0.002);
    QVERIFY(std::abs(valueOf(card, "alignment_rms") - 6.0) < 0.01);
    QCOMPARE(valueOf(card, "reversals"), 1.0);
    QCOMPARE(valueOf(card, "trauma_events"), 0.0);
    QCOMPARE(valueOf(card, "insertion_depth"), 60.0);
    QVERIFY(valueOf(card, "torque_max") >= valueOf(card, "torque_rms"));
    QVERIFY(valueOf(card, "force_max") > 0.1); // the canal really held on to it
}

void TestInsertionScoreIsKept::storedAndRecomputedAgree() {
    auto connection = m_site->database->openReader();
    const auto stored =
        database::ScoreRepository(**connection, database::Actor::simulated()).scores(m_result.session);
    QVERIFY(stored && session::sameScores(*stored, m_result.scores));
    OpenStored again(*m_site->database, m_result.session);
    const auto card = again.session->computeScores();
    QVERIFY(card && session::sameScores(*card, m_result.scores));
}

void TestInsertionScoreIsKept::exportedTraceAgrees() {
    OpenStored stored(*m_site->database, m_result.session);
    const QString path = QString::fromStdString(m_site->folder() + "/trace.csv");
    const auto done = session::exportCsv(*stored.session, path);
    QVERIFY2(done, done ? "" : done.error().message.c_str());
    const auto rows = scoring::readTraceCsvFile(path.toStdString());
    QVERIFY2(rows, rows ? "" : rows.error().message.c_str());
    QVERIFY(rows->columns.own == &scoring::canalColumns() && rows->columns.torque &&
            rows->columns.orientation && !rows->columns.target);
    const auto trace = scoring::buildSessionTrace(*rows, "urethra_insertion");
    QVERIFY2(trace, trace ? "" : trace.error().message.c_str());
    QVERIFY(trace->trials.at(0).completed);
    std::vector<scoring::MetricRequest> wanted;
    for (const auto& metric : guided().metrics)
        wanted.push_back({metric.id, metric.version});
    const auto card = scoring::calculateScore(*trace, wanted, guided().gates, true);
    QVERIFY2(card, card ? "" : card.error().message.c_str());
    for (std::size_t i = 0; i < card->metrics.size(); ++i)
        QVERIFY2(card->metrics[i].value == m_result.scores.metrics[i].value, card->metrics[i].id.c_str());
    QVERIFY(session::sameScores(*card, m_result.scores));
}

void TestInsertionScoreIsKept::trialAndEventsAreStored() {
    const database::TrialRecord trial = trialOf(m_result.session);
    QVERIFY(trial.marked && !trial.timedOut && trial.state == database::SessionState::completed);
    QVERIFY2(trial.sceneJson.find("\"completed\":true") != std::string::npos, trial.sceneJson.c_str());
    std::vector<std::string> kinds;
    for (const database::EventRecord& event : eventsOf(m_result.session))
        if (event.kind == "trial_started" || event.kind == "stage_changed" || event.kind == "completed")
            kinds.push_back(event.kind);
    QCOMPARE(kinds,
             (std::vector<std::string>{"trial_started", "stage_changed", "stage_changed", "completed"}));
}

void TestInsertionScoreIsKept::penaltiesAreMarks() {
    OpenStored stored(*m_site->database, m_result.session);
    const auto track = tests::trackOf(*stored.session);
    QVERIFY(track);
    QVERIFY(track->trials.at(0).completed);
    std::vector<session::PlaybackMark> stages;
    std::vector<session::PlaybackMark> reversals;
    for (const session::PlaybackMark& mark : track->marks) {
        if (mark.kind == mark_kinds::kStageChanged)
            stages.push_back(mark);
        if (mark.kind == mark_kinds::kReversal)
            reversals.push_back(mark);
    }
    QCOMPARE(stages.size(), std::size_t{2});
    QCOMPARE(stages[0].detail, std::string("insertion"));
    QCOMPARE(stages[1].detail, std::string("withdrawal"));
    QCOMPARE(reversals.size(), std::size_t{1});
    QVERIFY(std::abs(*reversals[0].value - 0.004) < 1e-5);
    QVERIFY(std::abs(reversals[0].end_s - reversals[0].t_s - 0.7) <
            0.3); // from 5.0–5.2 s to 5.8–6.0 s of the path
    const session::PlaybackMark& back = reversals[0];
    const auto& from = track->tool(track->indexAt(back.t_s), 0).p_WT;
    const auto& to = track->tool(track->indexAt(back.end_s), 0).p_WT;
    QVERIFY(std::abs((to - from).norm() - 0.004) < 1e-4); // the mark stands where the tip really went back
}

void TestInsertionScoreIsKept::unfinishedProcedure() {
    const session::TrainingResult cut = play(7.0); // the trace ends in the canal
    const database::TrialRecord trial = trialOf(cut.session);
    QVERIFY(!trial.marked && !trial.timedOut && trial.state != database::SessionState::completed);
    QVERIFY(!cut.scores.passed);
    for (const scoring::MetricValue& metric : cut.scores.metrics) {
        QVERIFY2(!metric.value, metric.id.c_str());
        QCOMPARE(metric.reason, std::string("no trial was finished"));
    }
    OpenStored stored(*m_site->database, cut.session);
    auto as = tests::traceOf(*stored.session); // scored as sessions were that say nothing of it
    QVERIFY(as && as->trials.at(0).unfinished);
    as->trials.at(0).unfinished = false;
    const auto before = stored.session->scoresOf(*as, false);
    QVERIFY(before && valueOf(*before, "insertion_depth") < 60.0);
    QVERIFY(std::abs(valueOf(*before, "offset_rms") - 1.2) < 0.002);
    const QString path = QString::fromStdString(m_site->folder() + "/cut.csv");
    QVERIFY(session::exportCsv(*stored.session, path));
    const auto rows = scoring::readTraceCsvFile(path.toStdString());
    QVERIFY2(rows, rows ? "" : rows.error().message.c_str());
    const auto trace = scoring::buildSessionTrace(*rows, "urethra_insertion");
    QVERIFY(trace && !trace->trials.at(0).completed && !trace->trials.at(0).marked &&
            trace->trials.at(0).unfinished);
}

QTEST_GUILESS_MAIN(TestInsertionScoreIsKept)
#include "test_insertion_score_is_kept.moc"
