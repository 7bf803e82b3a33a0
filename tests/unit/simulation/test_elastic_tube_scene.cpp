// SPDX-License-Identifier: GPL-3.0-or-later
// The elastic-tube exercise from the first tick to the last: trials, jaws, pauses, cues.
#include "tube_driver.h"

#include <QtTest>
#include <set>

using namespace chiron;
using namespace chiron::simulation;
using namespace chiron::simulation::testing;
namespace bits = chiron::core::event_bits;
using Step = core::LaparoscopyStep;

namespace {

/// Straight up from the base until the tube pulls with the trial's target.
Vec3 placeOfTension(const TubeDriver& d, double tension_N) {
    const ElasticTubeTrial& trial = d.scene.trials()[d.out.trial];
    const double x = tension_N / trial.stiffness_N_per_m; // linear tubes
    return {trial.base_m.x(), trial.base_m.y(), d.p.restLength_m + x};
}

} // namespace

class TestElasticTubeScene : public QObject {
    Q_OBJECT
private slots:
    void flowOfTrials();
    void graspTakesHoldAsItIs();
    void jawsHaveHysteresis();
    void closedJawsSpearNothing();
    void outOfReachIsNotHeld();
    void pauseStandsStill();
    void afterATrialThePullFades();
    void whatIsOffIsOff_data();
    void whatIsOffIsOff();
    void planFollowsSeedAndStreams();
    void sameInputsSameBits();
    void aPoseThatIsNoNumber();
    void bothHandsAreOneBody();
    void asManyToolsAsThereAre();
};

void TestElasticTubeScene::flowOfTrials() {
    TubeDriver d(tubeExercise(TubeTask::hold));
    d.tick();
    QCOMPARE(d.out.phase, core::TrialPhase::idle);
    QVERIFY(!d.out.cues.exercise.of<core::LaparoscopyCues>().tube);
    d.in.started = true;
    d.tick();
    QCOMPARE(d.out.phase, core::TrialPhase::ready);
    QVERIFY(d.out.events & bits::kSceneChanged);
    QVERIFY(d.out.cues.exercise.of<core::LaparoscopyCues>().tube);
    d.ticks(100);
    QCOMPARE(d.out.phase, core::TrialPhase::ready); // until force is armed
    d.in.forceReady = true;
    d.tick();
    QCOMPARE(d.out.phase, core::TrialPhase::running);
    QVERIFY(d.out.events & bits::kTrialStarted);
    QCOMPARE(d.step(), Step::grasp);
    for (int trial = 0; trial < 2; ++trial) {
        d.grasp(0, 1);
        d.moveTo(0, placeOfTension(d, d.scene.trials()[d.out.trial].target_N));
        d.events = 0;
        for (int i = 0; i < 2000 && !(d.events & bits::kCompleted); ++i)
            d.tick();
        QVERIFY(d.events & bits::kCompleted);
        QCOMPARE(d.out.phase, core::TrialPhase::running); // the tick of the end still has the tube
        QVERIFY(d.force(0).norm() > 0.5);
        QCOMPARE(d.step(), Step::done);
        d.tick();
        QCOMPARE(d.out.phase, trial == 0 ? core::TrialPhase::between : core::TrialPhase::finished);
        d.ticks(310); // until the pull has faded
        d.open(0);
        d.ticks(300);
    }
    QVERIFY(d.events & bits::kFinished);
    QVERIFY(d.largestStep_N < 0.1);
}

void TestElasticTubeScene::graspTakesHoldAsItIs() {
    for (const Vec3& off :
         {Vec3(0.0, 0.0, 0.006), Vec3(0.004, -0.004, 0.0), Vec3(0.0, 0.003, -0.005), Vec3(0.0, 0.0, 0.0)}) {
        TubeDriver d(tubeExercise(TubeTask::hold));
        d.startRunning();
        d.grasp(0, 1, off);
        QVERIFY(d.events & bits::kGrasped);
        QCOMPARE(d.quantity(TubeQuantity::grip1), 1.0);
        d.ticks(300);
        QVERIFY(d.force(0).norm() < 1e-9); // nobody moved
        d.moveTo(0, d.tool(0).p_WT + Vec3(0.0, 0.0, 0.015));
        QVERIFY(d.force(0).norm() > 0.5);
        QVERIFY(d.largestStep_N < 0.02); // 0.05 m/s · 60 N/m and damping, a tick
    }
}

void TestElasticTubeScene::jawsHaveHysteresis() {
    TubeDriver d(tubeExercise(TubeTask::hold));
    d.startRunning();
    d.tool(0).p_WT = d.place(1);
    for (const double jaw : {0.6, 0.4, 0.3, 0.21}) {
        d.tool(0).jaw_rad = jaw;
        d.tick();
        QCOMPARE(d.quantity(TubeQuantity::grip1), 0.0);
    }
    d.tool(0).jaw_rad = 0.2;
    d.tick();
    QCOMPARE(d.quantity(TubeQuantity::grip1), 1.0);
    for (const double jaw : {0.25, 0.3, 0.349}) {
        d.tool(0).jaw_rad = jaw;
        d.tick();
        QCOMPARE(d.quantity(TubeQuantity::grip1), 1.0);
    }
    d.tool(0).jaw_rad = 0.36;
    d.tick();
    QCOMPARE(d.quantity(TubeQuantity::grip1), 0.0);
    QVERIFY(d.out.events & bits::kReleased);
}

void TestElasticTubeScene::closedJawsSpearNothing() {
    TubeDriver d(tubeExercise(TubeTask::hold));
    d.startRunning();
    d.close(0); // away from it
    d.tool(0).p_WT = d.place(1);
    d.ticks(50);
    QCOMPARE(d.quantity(TubeQuantity::grip1), 0.0);
    d.open(0);
    d.close(0);
    QCOMPARE(d.quantity(TubeQuantity::grip1), 1.0);
}

void TestElasticTubeScene::outOfReachIsNotHeld() {
    TubeDriver d(tubeExercise(TubeTask::hold));
    d.startRunning();
    d.grasp(0, 1, {0.0, 0.0, d.p.graspReach_m + 1e-6});
    QCOMPARE(d.quantity(TubeQuantity::grip1), 0.0);
    d.open(0);
    d.grasp(0, 0); // the fixed end is nobody's
    QCOMPARE(d.quantity(TubeQuantity::grip0), 0.0);
}

void TestElasticTubeScene::pauseStandsStill() {
    TubeDriver d(tubeExercise(TubeTask::hold));
    d.startRunning();
    d.grasp(0, 1);
    d.moveTo(0, placeOfTension(d, d.scene.trials()[0].target_N));
    d.ticks(50);
    const double dwell = d.quantity(TubeQuantity::dwell);
    const double left_s = d.out.cues.timeLeft_s;
    d.in.paused = true;
    d.tool(0).p_WT.z() += 0.05; // would tear
    d.ticks(700);
    QCOMPARE(d.quantity(TubeQuantity::dwell), dwell);
    QCOMPARE(d.out.cues.timeLeft_s, left_s);
    QVERIFY(!(d.events & (bits::kFailed | bits::kDamaged)));
    QVERIFY(d.force(0).allFinite());
    d.tool(0).p_WT.z() -= 0.05;
    d.tick();
    d.in.paused = false;
    d.ticks(600);
    QVERIFY(d.events & bits::kCompleted);
}

void TestElasticTubeScene::afterATrialThePullFades() {
    TubeDriver d(tubeExercise(TubeTask::hold));
    d.startRunning();
    d.grasp(0, 1);
    d.moveTo(0, placeOfTension(d, d.scene.trials()[0].target_N));
    while (!(d.events & bits::kCompleted))
        d.tick();
    d.largestStep_N = 0.0;
    double before_J = d.out.storedEnergy_J;
    for (int i = 0; i < 310; ++i) {
        d.tick();
        QVERIFY(d.out.storedEnergy_J <= before_J);
        before_J = d.out.storedEnergy_J;
    }
    QVERIFY(d.largestStep_N < 0.01);
    QVERIFY(d.force(0) == Vec3::Zero());
    QVERIFY(!d.out.cues.exercise.of<core::LaparoscopyCues>().tube);
}

void TestElasticTubeScene::whatIsOffIsOff_data() {
    QTest::addColumn<bool>("object");
    QTest::addColumn<bool>("bars");
    QTest::newRow("nothing") << false << false;
    QTest::newRow("object alone") << true << false;
    QTest::newRow("bars alone") << false << true;
}

void TestElasticTubeScene::whatIsOffIsOff() {
    QFETCH(bool, object);
    QFETCH(bool, bars);
    for (const TubeTask task : {TubeTask::hold, TubeTask::stretch}) {
        ElasticTubeParameters p = tubeExercise(task);
        p.cues = {"tool"};
        if (object)
            p.cues.emplace_back("object");
        if (bars)
            p.cues.emplace_back("bars");
        TubeDriver d(p);
        d.startRunning();
        const ElasticTubeTrial& trial = d.scene.trials()[0];
        d.tool(0).p_WT = {trial.base_m.x(), trial.base_m.y(), p.restLength_m};
        d.tick();
        d.close(0);
        d.moveTo(0,
                 d.tool(0).p_WT +
                     Vec3(0.0, 0.0, task == TubeTask::hold ? trial.target_N / 60.0 : 0.4 * p.restLength_m));
        d.ticks(100);
        QCOMPARE(d.step(), Step::hold); // what is recorded does not depend on what is shown
        const core::LaparoscopyCues& cues = d.out.cues.exercise.of<core::LaparoscopyCues>();
        QVERIFY(cues.present);
        QCOMPARE(cues.tube, object);
        QCOMPARE(cues.objectShown, object);
        QCOMPARE(d.out.cues.objectShown, object);
        QCOMPARE(cues.stretch_m > 0.0, object);
        QCOMPARE(cues.grips, object ? 2 : 0);
        QCOMPARE(cues.gripHeldBy[1] != 0, object);
        QCOMPARE(cues.targetShown, object && task == TubeTask::stretch);
        QCOMPARE(cues.tensionShown, bars);
        QCOMPARE(cues.tension_N > 0.0, bars);
        QCOMPARE(cues.bandHigh_N > 0.0, bars && task == TubeTask::hold);
        QCOMPARE(cues.dwell > 0.0, object || bars);
        QVERIFY(object || d.out.cues.p_WObject == Vec3::Zero());
    }
}

void TestElasticTubeScene::planFollowsSeedAndStreams() {
    ElasticTubeParameters p = tubeExercise(TubeTask::hold);
    p.trials = 32;
    p.stiffnessLow_N_per_m = 40.0;
    p.stiffnessHigh_N_per_m = 120.0;
    const auto first = planElasticTubeTrials(p, 1);
    const auto again = planElasticTubeTrials(p, 1);
    const auto other = planElasticTubeTrials(p, 2);
    ElasticTubeParameters fixed = p;
    fixed.stiffnessLow_N_per_m = fixed.stiffnessHigh_N_per_m = 0.0;
    const auto alone = planElasticTubeTrials(fixed, 1);
    std::set<double> targets;
    for (std::size_t i = 0; i < first.size(); ++i) {
        QVERIFY(first[i].base_m == again[i].base_m && first[i].target_N == again[i].target_N);
        QVERIFY(first[i].base_m != other[i].base_m && first[i].target_N != other[i].target_N);
        QVERIFY(first[i].base_m == alone[i].base_m &&
                first[i].target_N == alone[i].target_N); // streams of their own
        QCOMPARE(alone[i].stiffness_N_per_m, 60.0);
        QVERIFY(first[i].stiffness_N_per_m >= 40.0 && first[i].stiffness_N_per_m <= 120.0);
        QVERIFY(first[i].target_N >= p.targetLow_N && first[i].target_N <= p.targetHigh_N);
        QVERIFY(first[i].base_m.norm() <= p.baseSpread_m);
        targets.insert(first[i].target_N);
    }
    QCOMPARE(targets.size(), std::size_t{32});
    p.task = TubeTask::stretch;
    QCOMPARE(planElasticTubeTrials(p, 1)[0].target_N, 0.0);
}

void TestElasticTubeScene::sameInputsSameBits() {
    const auto run = [] {
        TubeDriver d(tubeExercise(TubeTask::transfer), 9);
        std::vector<double> bitsOfAll;
        d.startRunning();
        d.grasp(0, 2);
        for (int i = 0; i < 3000; ++i) {
            d.tool(0).p_WT += Vec3(1e-5 * std::sin(0.01 * i), 1e-5 * std::cos(0.013 * i), 4e-6);
            d.tool(1).p_WT = d.place(1);
            d.tool(1).jaw_rad = (i / 400) % 2 == 0 ? 0.7 : 0.0;
            d.tool(0).jaw_rad = (i / 900) % 3 == 2 ? 0.7 : 0.0;
            d.tick();
            for (const double q : d.out.quantities)
                bitsOfAll.push_back(q);
            for (int t = 0; t < 2; ++t)
                for (int axis = 0; axis < 3; ++axis)
                    bitsOfAll.push_back(d.force(t)[axis]);
        }
        return bitsOfAll;
    };
    const auto first = run();
    QVERIFY(first == run());
    QVERIFY(*std::max_element(first.begin(), first.end()) > 1.0);
}

void TestElasticTubeScene::aPoseThatIsNoNumber() {
    TubeDriver d(tubeExercise(TubeTask::hold));
    d.startRunning();
    d.grasp(0, 1);
    d.moveTo(0, placeOfTension(d, 1.0));
    const Vec3 felt = d.force(0);
    const Vec3 p = d.tool(0).p_WT;
    d.tool(0).p_WT = Vec3::Constant(std::nan(""));
    d.ticks(5);
    QVERIFY((d.force(0) - felt).norm() < 1e-9); // as it was; the supervisor deals with the sample
    d.tool(0).p_WT = p;
    d.tick();
    QVERIFY((d.force(0) - felt).norm() < 1e-9);
}

void TestElasticTubeScene::bothHandsAreOneBody() {
    TubeDriver d(tubeExercise(TubeTask::twoHanded));
    d.startRunning();
    QCOMPARE(d.out.bodyStiffness_N_per_m[0], 0.0); // nobody holds it
    d.grasp(0, 1);
    d.grasp(1, 0);
    d.moveTo(0, d.tool(0).p_WT - Vec3(0.01, 0.0, 0.0));
    QCOMPARE(d.out.storedEnergy_J, 0.0);
    QVERIFY(std::abs(d.out.bodyStiffness_N_per_m[0] - 120.0) < 1e-9); // held though slack
    d.moveTo(0, d.tool(0).p_WT + Vec3(0.02, 0.0, 0.0));
    QVERIFY(d.out.energyByBody);
    QCOMPARE(d.out.body[0], d.out.body[1]);
    QCOMPARE(d.out.bodyEnergy_J[0], d.out.storedEnergy_J);
    QVERIFY(std::abs(d.out.storedEnergy_J - 0.5 * 60.0 * 0.01 * 0.01) < 1e-9);
    QVERIFY(std::abs(d.out.contactStiffness_N_per_m - 60.0) < 1e-9);
    QVERIFY(std::abs(d.out.bodyStiffness_N_per_m[0] - 120.0) < 1e-9); // both ends move
}

/// None, all, and numbers that no device gives.
void TestElasticTubeScene::asManyToolsAsThereAre() {
    for (const auto& [given, answered] : {std::pair{0, 0},
                                          {1, 1},
                                          {core::kMaxTools, core::kMaxTools},
                                          {-1, 0},
                                          {core::kMaxTools + 1, core::kMaxTools}}) {
        TubeDriver d(tubeExercise(TubeTask::hold));
        d.startRunning();
        d.in.tools.count = given;
        d.scene.respond(d.source.next(0), d.in, d.out);
        QCOMPARE(d.out.tissue.count, answered);
        for (const core::Wrench& w : d.out.tissue.tools)
            QVERIFY(w.force == Vec3::Zero()); // nobody holds
    }
}

QTEST_APPLESS_MAIN(TestElasticTubeScene)
#include "test_elastic_tube_scene.moc"
