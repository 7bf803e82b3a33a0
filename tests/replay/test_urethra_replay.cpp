// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/urethra_insertion/session/insertion_series.h"
#include "modules/exercises/urethra_insertion/cues/procedure_bits.h"
#include "session/replayer.h"
#include "session/session_export.h"
#include "support/insertion_in.h"
#include "support/looked_back.h"
#include "support/session_fixture.h"
#include "support/urethra_trace.h"

#include <QtTest>
#include <cmath>

using namespace chiron;
using simulation::ProcedureStage;
using tests::OpenStored;
using tests::SessionFixture;

namespace {

const catalogue::ExerciseLevel& level(int number) {
    static const auto catalogue = catalogue::Catalogue::load(CHIRON_SOURCE_DIR "/curriculum/content");
    if (!catalogue)
        qFatal("%s", catalogue.error().message.c_str());
    return *catalogue->find("urethra_insertion", number);
}

const simulation::UrethraInsertionParameters& parametersOf(int number) {
    return level(number).parameters.as<simulation::UrethraInsertionParameters>();
}

session::TrainingRequest played(int number, double speed_m_per_s) {
    auto station = session::traceStation(tests::idealTrace(parametersOf(number), speed_m_per_s));
    if (!station)
        qFatal("%s", station.error().message.c_str());
    session::TrainingRequest request;
    request.level = level(number);
    request.ringFolder = recording::defaultRingFolder();
    request.station = std::move(*station);
    return request;
}

double valueOf(const scoring::ScoreCard& scores, const std::string& id) {
    for (const auto& metric : scores.metrics)
        if (metric.id == id && metric.value)
            return *metric.value;
    return std::nan("");
}

} // namespace

class TestUrethraReplay : public QObject {
    Q_OBJECT
private slots:
    void wholeProcedureReplaysAndScores_data();
    void wholeProcedureReplaysAndScores();
    void endoscopistsReplayToTheSameBits();
    void realtimeAndAsFastAgree();
    void stagesOfTheSeriesAreThoseOfTheScene();
    void anotherTissueIsNoticed();
    void playbackDrawsTheTipInside();
    void torqueCapComesFromTheLevel();
};

void TestUrethraReplay::wholeProcedureReplaysAndScores_data() {
    QTest::addColumn<int>("number");
    for (int number = 1; number <= 5; ++number)
        QTest::newRow(level(number).id.c_str()) << number;
}

void TestUrethraReplay::wholeProcedureReplaysAndScores() {
    QFETCH(int, number);
    SessionFixture site;
    auto result = site.run(played(number, 0.040));
    QVERIFY2(result, result ? "" : result.error().message.c_str());
    OpenStored stored(*site.database, result->session);
    QCOMPARE(stored.session->record().summary.state, database::SessionState::completed);
    auto replay = session::replaySession(*stored.session);
    QVERIFY2(replay, replay ? "" : replay.error().message.c_str());
    QVERIFY(replay->comparable && replay->identical);
    QCOMPARE(replay->maximumDifference_N, 0.0);
    auto again = stored.session->computeScores();
    QVERIFY(again);
    QVERIFY(session::sameScores(result->scores, *again));
    // A perfect hand: on the line, aligned, everything seen.
    QVERIFY(valueOf(result->scores, "offset_rms") < 0.1);
    QVERIFY(valueOf(result->scores, "alignment_rms") <
            20.0); // it looks aside at the landmarks, inside the canal's end
    QCOMPARE(valueOf(result->scores, "trauma_events"), 0.0);
    QVERIFY(valueOf(result->scores, "insertion_depth") >= 1000.0 * parametersOf(number).goalDepth_m);
    if (number > 2)
        QCOMPARE(valueOf(result->scores, "landmarks_seen"), 100.0);
}

// On P1's mechanism, whose hand feels what is commanded.
void TestUrethraReplay::endoscopistsReplayToTheSameBits() {
    for (const char* name : {"expert", "unsafe"}) {
        SessionFixture site;
        auto result = site.run(site.request(level(2), name, 5));
        QVERIFY2(result, result ? "" : result.error().message.c_str());
        OpenStored stored(*site.database, result->session);
        auto replay = session::replaySession(*stored.session);
        QVERIFY(replay && replay->comparable && replay->identical);
        auto again = stored.session->computeScores();
        QVERIFY(again && session::sameScores(result->scores, *again));
    }
}

void TestUrethraReplay::realtimeAndAsFastAgree() {
    SessionFixture site;
    auto fast = site.run(played(1, 0.060));
    session::TrainingRequest slow = played(1, 0.060);
    slow.realtime = true;
    auto realtime = site.run(std::move(slow));
    QVERIFY2(fast && realtime, "both runs end");
    QVERIFY(session::sameScores(fast->scores, realtime->scores));
    OpenStored one(*site.database, fast->session);
    OpenStored two(*site.database, realtime->session);
    const auto a = one.session->reader().allFrames();
    const auto b = two.session->reader().allFrames();
    QVERIFY(a && b);
    QCOMPARE(a->size(), b->size());
    double strongest_N = 0.0;
    for (std::size_t i = 0; i < a->size(); ++i) {
        QCOMPARE((*a)[i].tool[0].counts, (*b)[i].tool[0].counts);
        QCOMPARE((*a)[i].tool[0].tissue, (*b)[i].tool[0].tissue);
        QCOMPARE((*a)[i].header.events, (*b)[i].header.events);
        strongest_N = std::max(strongest_N, core::toWrench((*a)[i].tool[0].tissue).force.norm());
    }
    QVERIFY(strongest_N > 0.05);
}

// What the scene said while it ran (events) and what is derived from the stored poses must be the same
// procedure.
void TestUrethraReplay::stagesOfTheSeriesAreThoseOfTheScene() {
    SessionFixture site;
    auto result = site.run(played(3, 0.040));
    QVERIFY(result);
    OpenStored stored(*site.database, result->session);
    auto frames = stored.session->reader().allFrames();
    auto trace = tests::traceOf(*stored.session);
    QVERIFY(frames && trace);
    QCOMPARE(trace->trials.size(), std::size_t{1});
    QVERIFY(trace->trials[0].own);
    const scoring::InsertionSeries& series = insertionIn(trace->trials[0]);
    std::vector<double> changes_s;
    std::vector<double> seen_s;
    for (const core::HapticFrame& frame : *frames) {
        const double t_s =
            static_cast<double>(frame.tool[0].deviceTime_us - frames->front().tool[0].deviceTime_us) * 1e-6;
        if (frame.header.events & core::event_bits::kStageChanged)
            changes_s.push_back(t_s);
        if (frame.header.events & simulation::procedure_bits::kLandmarkSeen)
            seen_s.push_back(t_s);
    }
    QCOMPARE(changes_s.size(), std::size_t{4});
    QCOMPARE(seen_s.size(), std::size_t{5});
    const scoring::ToolTrace& tool = trace->trials[0].tools[0];
    QCOMPARE(series.stage.size(), tool.t_s.size());
    std::size_t change = 0;
    for (std::size_t i = 1; i < series.stage.size(); ++i) {
        if (series.stage[i] == series.stage[i - 1])
            continue;
        QVERIFY(change < changes_s.size());
        QVERIFY(std::abs(tool.t_s[i] - changes_s[change]) < 1e-9);
        ++change;
    }
    QCOMPARE(change, changes_s.size());
    std::vector<double> derived_s = series.landmarkSeen_s;
    std::sort(derived_s.begin(), derived_s.end());
    for (std::size_t k = 0; k < 5; ++k)
        QVERIFY(std::abs(derived_s[k] - seen_s[k]) < 1e-9);
    QCOMPARE(series.stage.back(), static_cast<std::uint8_t>(ProcedureStage::completed));
}

// So that the comparison can fail: the same movements in another tissue give other forces.
void TestUrethraReplay::anotherTissueIsNoticed() {
    const scoring::TraceRows trace = tests::idealTrace(parametersOf(1), 0.060);
    const auto largest = [&](double stiffness_N_per_m3) {
        simulation::UrethraInsertionParameters p = parametersOf(1);
        p.anatomy.wallStiffness_N_per_m3 = stiffness_N_per_m3;
        simulation::UrethraInsertionScene scene(p);
        realtime::TickSource ticks;
        simulation::SceneInput in;
        simulation::SceneOutput out;
        in.started = in.forceReady = true;
        in.tools.count = 1;
        double energy_J = 0.0;
        for (const scoring::TraceRow& row : trace.rows) {
            in.tools.tools[0].p_WT = row.p_WT_m;
            in.tools.tools[0].q_WT = row.q_WT;
            scene.respond(ticks.next(0), in, out);
            energy_J = std::max(energy_J, out.storedEnergy_J);
        }
        return energy_J;
    };
    QVERIFY(largest(6.0e6) > 1.9 * largest(3.0e6));
}

void TestUrethraReplay::playbackDrawsTheTipInside() {
    SessionFixture site;
    auto result = site.run(played(2, 0.060));
    QVERIFY(result);
    OpenStored stored(*site.database, result->session);
    auto track = tests::trackOf(*stored.session, {});
    QVERIFY2(track, track ? "" : track.error().message.c_str());
    QVERIFY(!track->moments.empty());
    QVERIFY(tests::traceOf(*stored.session));
    QCOMPARE(stored.session->decodings(), 1); // its marks are of the trace, which came with the track
    for (std::size_t i = 0; i < track->moments.size(); ++i)
        QVERIFY((track->tool(i, 0).p_WProxy - track->tool(i, 0).p_WT).norm() <
                1e-9); // a perfect hand is where it is drawn
    const auto kind = session::exerciseKind("urethra_insertion");
    const auto surfaces = (*kind)->makeSurfaces(level(2), 1);
    const auto& pose = parametersOf(2).pose;
    const core::Vec3 wild = pose.pointToW(core::Vec3(0.050, 0.0, 0.02));
    QVERIFY(std::abs(pose.pointToA(surfaces->surfacePoint(0, wild)).x() - 0.008) < 1e-4);
    QVERIFY(!surfaces->object(0).has_value());
}

void TestUrethraReplay::torqueCapComesFromTheLevel() {
    catalogue::ExerciseLevel changed = level(3);
    auto& p = changed.parameters.as<simulation::UrethraInsertionParameters>();
    p.maximumTorque_Nm = 0.090;
    p.maximumForce_N = 3.0;
    const haptics::SafetySettings safety = session::headlessSafety(changed);
    QCOMPARE(safety.exerciseTorque_Nm, 0.090);
    QCOMPARE(safety.exerciseForce_N, 3.0);
}

QTEST_GUILESS_MAIN(TestUrethraReplay)
#include "test_urethra_replay.moc"
