// SPDX-License-Identifier: GPL-3.0-or-later
// Each task of the elastic tube, done by ideal hands, dropped, torn, and out of time.
#include "tube_driver.h"

#include "core/random.h"

#include <QtTest>

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

class TestElasticTubeTasks : public QObject {
    Q_OBJECT
private slots:
    void holdInTheBand();
    void leavingTheBandBreaksTheHold();
    void stretchToTheMark();
    void twoHands();
    void aFoldIsHeldBack();
    void aFoldLetsNoEnergyOut();
    void transferFromHandToHand();
    void letGoIsDropped();
    void whatSlidesOutOfTheJawsOnlyFalls();
    void tearing();
    void theCheckedRangeEndsAtTheTear();
    void theCheckedRangeOfAPull();
    void overStretchIsCountedOnce();
    void timeRunsOut();
};

void TestElasticTubeTasks::holdInTheBand() {
    TubeDriver d(tubeExercise(TubeTask::hold));
    d.startRunning();
    d.grasp(0, 1);
    QCOMPARE(d.step(), Step::stretch);
    const double target_N = d.scene.trials()[0].target_N;
    QCOMPARE(d.out.cues.exercise.of<core::LaparoscopyCues>().bandLow_N, target_N - d.p.band_N);
    QCOMPARE(d.out.cues.exercise.of<core::LaparoscopyCues>().bandHigh_N, target_N + d.p.band_N);
    d.moveTo(0, placeOfTension(d, target_N - d.p.band_N - 0.02));
    QCOMPARE(d.step(), Step::stretch);
    d.moveTo(0, placeOfTension(d, target_N));
    QCOMPARE(d.step(), Step::hold);
    d.ticks(10);
    QVERIFY(std::abs(d.quantity(TubeQuantity::tension_N) - target_N) < 1e-9);
    QVERIFY(std::abs(d.force(0).norm() - target_N) < 1e-9);
    QVERIFY(d.force(0).z() < 0.0); // towards the base
    const double dwell = d.quantity(TubeQuantity::dwell);
    QVERIFY(dwell > 0.0 && dwell < 1.0);
    int n = 0;
    while (!(d.events & bits::kCompleted) && n < 1000) {
        d.tick();
        ++n;
    }
    QVERIFY(d.events & bits::kCompleted);
    QVERIFY(std::abs(n * 1e-3 - (1.0 - dwell) * d.p.hold_s) < 0.003);
    QCOMPARE(d.quantity(TubeQuantity::dwell), 1.0);
}

void TestElasticTubeTasks::leavingTheBandBreaksTheHold() {
    ElasticTubeParameters p = tubeExercise(TubeTask::hold);
    p.hold_s = 3.0;
    TubeDriver d(p);
    d.startRunning();
    d.grasp(0, 1);
    const double target_N = d.scene.trials()[0].target_N;
    d.moveTo(0, placeOfTension(d, target_N));
    d.ticks(100);
    d.moveTo(0, placeOfTension(d, target_N + 2.0 * p.band_N));
    d.ticks(300); // shorter than half a second: still the hold
    QCOMPARE(d.step(), Step::hold);
    d.ticks(300);
    QCOMPARE(d.step(), Step::stretch);
    QCOMPARE(d.quantity(TubeQuantity::dwell), 0.0);
    d.moveTo(0, placeOfTension(d, target_N));
    QCOMPARE(d.step(), Step::hold);
    d.ticks(2990);
    QVERIFY(d.events & bits::kCompleted);
}

void TestElasticTubeTasks::stretchToTheMark() {
    TubeDriver d(tubeExercise(TubeTask::stretch));
    d.startRunning();
    QVERIFY(d.out.cues.exercise.of<core::LaparoscopyCues>().targetShown);
    QCOMPARE(d.out.cues.exercise.of<core::LaparoscopyCues>().bandHigh_N,
             0.0); // a task without a target tension
    d.grasp(0, 1);
    const auto& mark = d.out.cues.exercise.of<core::LaparoscopyCues>().p_WTarget;
    d.moveTo(0, {mark[0], mark[1], mark[2]});
    QCOMPARE(d.step(), Step::hold);
    QVERIFY(std::abs(d.quantity(TubeQuantity::stretch_m) - 0.4 * d.p.restLength_m) < 1e-9);
    d.ticks(600);
    QVERIFY(d.events & bits::kCompleted);
    QVERIFY(!(d.events & bits::kDamaged));
}

void TestElasticTubeTasks::twoHands() {
    TubeDriver d(tubeExercise(TubeTask::twoHanded));
    d.startRunning();
    QVERIFY(!d.out.cues.exercise.of<core::LaparoscopyCues>().gripAnchored[0]);
    d.grasp(0, 1);
    QCOMPARE(d.step(), Step::grasp); // one end is not enough
    d.grasp(1, 0);
    QCOMPARE(d.step(), Step::stretch);
    QCOMPARE(d.quantity(TubeQuantity::grip0), 2.0);
    QCOMPARE(d.quantity(TubeQuantity::grip1), 1.0);
    const ElasticTubeTrial& trial = d.scene.trials()[0];
    const double half = 0.5 * (d.p.restLength_m + trial.target_N / trial.stiffness_N_per_m);
    const Vec3 middle(trial.base_m.x(), trial.base_m.y(), 0.03);
    d.moveTo(0, middle + Vec3(0.5 * d.p.restLength_m, 0.0, 0.0)); // lifted, one after the other
    d.moveTo(1, middle - Vec3(0.5 * d.p.restLength_m, 0.0, 0.0));
    d.moveTo(0, middle + Vec3(half, 0.0, 0.0));
    d.moveTo(1, middle - Vec3(half, 0.0, 0.0));
    d.ticks(20);
    QVERIFY(std::abs(d.quantity(TubeQuantity::tension_N) - trial.target_N) < 1e-6);
    QVERIFY(d.force(0) == -d.force(1));
    QVERIFY(d.force(0).x() < 0.0);
    d.ticks(600);
    QVERIFY(d.events & bits::kCompleted);
    QVERIFY(d.largestStep_N < 0.02);
}

namespace {

ElasticTubeParameters behindAFold() {
    ElasticTubeParameters p = tubeExercise(TubeTask::twoHanded);
    p.foldStiffness_N_per_m = 25.0;
    p.retractionLow_N = 0.6;
    p.retractionHigh_N = 1.0;
    p.trialLimit_s = 60.0;
    return p;
}

Vec3 edgeOf(const TubeDriver& d) {
    const auto& at = d.out.cues.exercise.of<core::LaparoscopyCues>().p_WFoldEdge;
    return {at[0], at[1], at[2]};
}

/// Where the fold's edge is when it is drawn back with this pull.
Vec3 drawnBack(const TubeDriver& d, double pull_N) {
    const auto& at = d.out.cues.exercise.of<core::LaparoscopyCues>().p_WFoldBase;
    const double length_m = tissueFoldShape(d.p, d.scene.trials()[d.out.trial]).length_m;
    return Vec3(at[0], at[1], at[2]) + (length_m + pull_N / d.p.foldStiffness_N_per_m) * Vec3(0.0, 0.8, 0.6);
}

} // namespace

// Three instruments: nothing can be taken hold of under the fold, the retractor feels its pull and nobody
// else does, and a fold that slips forward breaks the hold.
void TestElasticTubeTasks::aFoldIsHeldBack() {
    TubeDriver d(behindAFold());
    QCOMPARE(d.p.tools(), 3);
    d.startRunning();
    QCOMPARE(d.step(), Step::retract);
    d.grasp(0, 1);
    d.grasp(1, 0);
    QCOMPARE(d.quantity(TubeQuantity::grip0), 0.0); // it lies under the fold
    QCOMPARE(d.quantity(TubeQuantity::grip1), 0.0);
    d.open(0);
    d.open(1);
    d.tool(2).p_WT = edgeOf(d);
    d.tick();
    d.close(2);
    QCOMPARE(d.out.cues.exercise.of<core::LaparoscopyCues>().foldHeldBy, std::uint8_t{4});
    d.moveTo(2, drawnBack(d, 0.55));
    QCOMPARE(d.quantity(TubeQuantity::foldOpen), 0.0);
    d.moveTo(2, drawnBack(d, 0.8));
    d.ticks(5);
    QCOMPARE(d.quantity(TubeQuantity::foldOpen), 1.0);
    QCOMPARE(d.step(), Step::grasp);
    QVERIFY(std::abs(d.quantity(TubeQuantity::retraction_N) - 0.8) < 1e-6);
    QVERIFY(std::abs(d.force(2).norm() - 0.8) < 1e-6 && d.force(2).y() < 0.0); // back over the tube
    QVERIFY(d.force(0) == Vec3::Zero() && d.force(1) == Vec3::Zero());
    QVERIFY(d.out.body[2] == 1 && d.out.body[0] == 0 &&
            std::abs(d.out.bodyEnergy_J[1] - 0.5 * 0.8 * 0.8 / 25.0) < 1e-9);
    d.grasp(0, 1);
    d.grasp(1, 0);
    QCOMPARE(d.step(), Step::stretch);
    const ElasticTubeTrial& trial = d.scene.trials()[0];
    const double half = 0.5 * (d.p.restLength_m + trial.target_N / trial.stiffness_N_per_m);
    const Vec3 middle(trial.base_m.x(), trial.base_m.y(), 0.03);
    for (const double share : {0.5 * d.p.restLength_m, half}) {
        d.moveTo(0, middle + Vec3(share, 0.0, 0.0));
        d.moveTo(1, middle - Vec3(share, 0.0, 0.0));
    }
    d.ticks(20);
    QCOMPARE(d.step(), Step::hold);
    d.events = 0;
    d.open(2); // the fold falls forward
    d.ticks(900);
    QCOMPARE(d.quantity(TubeQuantity::foldOpen), 0.0);
    QCOMPARE(d.step(), Step::stretch); // the tension is right, and does not count
    QVERIFY(!(d.events & bits::kCompleted) && d.force(2) == Vec3::Zero());
    d.tool(2).p_WT = edgeOf(d);
    d.tick();
    d.close(2);
    d.moveTo(2, drawnBack(d, 0.8));
    d.ticks(700);
    QVERIFY(d.events & bits::kCompleted);
    QVERIFY(d.largestStep_N < 0.02);
}

// The retractor gets no more out of the fold than it put in, on any way, and letting go steps nothing.
void TestElasticTubeTasks::aFoldLetsNoEnergyOut() {
    TubeDriver d(behindAFold());
    d.startRunning();
    d.tool(2).p_WT = edgeOf(d);
    d.tick();
    d.close(2);
    double given_J = 0.0, least_J = 0.0;
    core::Random random(7);
    for (int way = 0; way < 40; ++way) {
        const Vec3 from = d.tool(2).p_WT;
        const Vec3 goal = drawnBack(d, random.uniform(0.0, 1.5)) +
                          Vec3(random.uniform(-0.02, 0.02), random.uniform(-0.02, 0.02), 0.0);
        const int n = static_cast<int>(1000.0 * (goal - from).norm() / random.uniform(0.02, 0.3)) + 1;
        for (int k = 0; k < n; ++k) {
            const Vec3 step = (goal - from) / n;
            d.tool(2).p_WT += step;
            d.tool(2).v_WT = step / core::kTickSeconds;
            const Vec3 before = d.force(2);
            d.tick();
            given_J -= 0.5 * (before + d.force(2)).dot(step);
            least_J = std::min(least_J, given_J - d.out.bodyEnergy_J[1]);
        }
    }
    QVERIFY2(least_J > -2e-6, qPrintable(QString::number(least_J)));
    d.open(2);
    d.ticks(400);
    QVERIFY(d.largestStep_N < 0.2 && d.force(2) == Vec3::Zero());
}

void TestElasticTubeTasks::transferFromHandToHand() {
    TubeDriver d(tubeExercise(TubeTask::transfer));
    d.startRunning();
    d.grasp(1, 1); // the left hand first is not the task
    QCOMPARE(d.step(), Step::grasp);
    d.open(1);
    d.ticks(500);
    d.grasp(0, 2);
    QCOMPARE(d.step(), Step::handOver);
    d.moveTo(0, d.tool(0).p_WT + Vec3(-0.004, 0.0, 0.006));
    QVERIFY(d.force(0).norm() > 0.2);
    const Vec3 felt = d.force(0);
    d.tool(1).jaw_rad = TubeDriver::kOpen_rad;
    d.grasp(1, 1);
    QVERIFY((d.force(0) - felt).norm() < 1e-6 &&
            d.force(1).norm() < 1e-6); // the same tension on both sides of it
    QCOMPARE(d.step(), Step::handOver);
    d.largestStep_N = 0.0;
    const Vec3 place = d.force(0);
    d.open(0);
    QVERIFY((d.force(0) - place).norm() < 0.05); // it slides out of the jaws: no jerk ...
    QCOMPARE(d.step(), Step::carry);
    QVERIFY(!(d.events & bits::kSlipped));
    d.largestStep_N = 0.0;
    d.ticks(800);
    QVERIFY(d.force(0) == Vec3::Zero()); // ... and who let go feels nothing more
    QVERIFY2(d.largestStep_N < 0.05, qPrintable(QString::number(d.largestStep_N)));
    const auto& at = d.out.cues.exercise.of<core::LaparoscopyCues>().p_WTarget;
    for (int i = 0; i < 40 && d.step() != Step::hold; ++i) { // sees where the end is and leads it there
        const Vec3 off = Vec3(at[0], at[1], at[2]) - d.place(2);
        d.moveTo(1, d.tool(1).p_WT + 0.5 * off);
        d.ticks(50);
    }
    QCOMPARE(d.step(), Step::hold);
    d.ticks(700);
    QVERIFY(d.events & bits::kCompleted);
    QVERIFY(!(d.events & (bits::kFailed | bits::kDamaged)));
}

/// Wherever the hand goes meanwhile: along the pull of what it had held, and for a tenth of a second. This is
/// friction and no potential; a hand that goes along gets no more than half of the pull over that way.
void TestElasticTubeTasks::whatSlidesOutOfTheJawsOnlyFalls() {
    constexpr double kSpeed_m_per_s = 0.3;
    for (const Vec3& way : {Vec3(0, 0, -1), Vec3(0, 0, 1), Vec3(1, 0, 0), Vec3(0, 0, 0)}) {
        TubeDriver d(tubeExercise(TubeTask::hold));
        d.startRunning();
        d.grasp(0, 1);
        d.moveTo(0, placeOfTension(d, 1.0));
        d.ticks(10);
        const Vec3 from = d.force(0);
        QVERIFY(std::abs(from.norm() - 1.0) < 1e-9);
        d.open(0);
        const Vec3 step = kSpeed_m_per_s * core::kTickSeconds * way;
        double before = 1.0, work_J = 0.0;
        for (int tick = 0; tick < 110; ++tick) {
            const double share = d.force(0).dot(from) / from.squaredNorm();
            QVERIFY((d.force(0) - share * from).norm() < 1e-12);
            QVERIFY(share >= 0.0 && share <= before);
            QCOMPARE(share == 0.0, tick >= 99);
            before = share;
            work_J += d.force(0).dot(step);
            d.tool(0).p_WT += step;
            d.tool(0).v_WT = kSpeed_m_per_s * way;
            d.tick();
        }
        QVERIFY2(work_J < 0.0501 * kSpeed_m_per_s * from.norm(), qPrintable(QString::number(work_J)));
    }
}

void TestElasticTubeTasks::letGoIsDropped() {
    TubeDriver d(tubeExercise(TubeTask::hold));
    d.startRunning();
    d.grasp(0, 1);
    d.moveTo(0, placeOfTension(d, 0.5));
    d.open(0);
    QVERIFY((d.out.events & bits::kSlipped) && (d.out.events & bits::kReleased));
    QCOMPARE(d.step(), Step::grasp);
    d.largestStep_N = 0.0;
    d.ticks(100); // it slides out of the jaws
    QVERIFY(d.largestStep_N < 0.01);
    QVERIFY(d.force(0) == Vec3::Zero());
    QCOMPARE(d.out.contactStiffness_N_per_m, 0.0);
    d.ticks(1900); // it comes back to where it stood
    const ElasticTubeTrial& trial = d.scene.trials()[0];
    QVERIFY((d.place(1) - Vec3(trial.base_m.x(), trial.base_m.y(), d.p.restLength_m)).norm() < 1e-5);
    d.grasp(0, 1);
    QCOMPARE(d.step(), Step::stretch);
}

void TestElasticTubeTasks::tearing() {
    TubeDriver d(tubeExercise(TubeTask::hold));
    d.startRunning();
    d.grasp(0, 1);
    const ElasticTubeTrial& trial = d.scene.trials()[0];
    d.moveTo(0, {trial.base_m.x(), trial.base_m.y(), 1.88 * d.p.restLength_m});
    QVERIFY(d.force(0).norm() > 2.0);
    QVERIFY(!(d.events & bits::kFailed));
    QCOMPARE(int(d.out.contact[0]), 0);
    d.tool(0).p_WT.z() = 1.901 * d.p.restLength_m;
    d.tick();
    QVERIFY(d.out.events & bits::kFailed);
    QVERIFY(d.events & bits::kDamaged);
    QVERIFY(d.out.cues.exercise.of<core::LaparoscopyCues>().torn);
    QCOMPARE(int(d.out.contact[0]), int(core::contact_bits::kYielded | core::contact_bits::kThrough |
                                        core::contact_bits::kBeyondChecked));
    const double torn_N = d.force(0).norm();
    QVERIFY(torn_N > 2.0);
    QVERIFY(d.quantity(TubeQuantity::stretch_m) > 0.9 * d.p.restLength_m); // what tore it is recorded
    d.tick();
    QCOMPARE(d.out.phase, core::TrialPhase::between);
    QCOMPARE(int(d.out.contact[0]), int(core::contact_bits::kThrough | core::contact_bits::kBeyondChecked));
    d.largestStep_N = 0.0;
    d.ticks(18); // 20 ms by a smoothstep: 1.5 times as steep in its middle
    QVERIFY(d.largestStep_N < 1.6 * torn_N / 20.0);
    QVERIFY(d.force(0) == Vec3::Zero());
    QCOMPARE(d.out.storedEnergy_J, 0.0);
}

// During a pause nothing tears. The force is the law's up to the tear stretch; beyond it stays as it is, and
// is flagged, each way.
void TestElasticTubeTasks::theCheckedRangeEndsAtTheTear() {
    TubeDriver d(tubeExercise(TubeTask::hold));
    d.startRunning();
    d.grasp(0, 1);
    d.in.paused = true;
    const ElasticTubeTrial& trial = d.scene.trials()[0];
    for (const double ratio : {1.2, 1.6, 1.899, 1.95, 2.6, 1.899, 1.0}) {
        d.moveTo(0, {trial.base_m.x(), trial.base_m.y(), ratio * d.p.restLength_m});
        const double stretch_m = (std::min(ratio, d.p.tearRatio) - 1.0) * d.p.restLength_m;
        QVERIFY(std::abs(d.force(0).norm() - trial.stiffness_N_per_m * stretch_m) < 1e-9);
        QCOMPARE(int(d.out.contact[0]), ratio > d.p.tearRatio ? int(core::contact_bits::kBeyondChecked) : 0);
    }
    QVERIFY(!(d.events & bits::kFailed));
}

// A pull that the tube would not bear is cut off, and flagged; the other tools are not concerned.
void TestElasticTubeTasks::theCheckedRangeOfAPull() {
    ElasticTubeParameters p = tubeExercise(TubeTask::hold);
    p.yield.force_N = 1.0;
    TubeDriver d(p);
    d.startRunning();
    d.grasp(0, 1);
    d.in.paused = true;
    d.moveTo(0, placeOfTension(d, 0.99));
    QCOMPARE(int(d.out.contact[0]), 0);
    d.moveTo(0, placeOfTension(d, 1.1));
    QVERIFY(std::abs(d.force(0).norm() - 1.0) < 1e-9);
    QCOMPARE(int(d.out.contact[0]), int(core::contact_bits::kBeyondChecked));
    QCOMPARE(int(d.out.contact[1]), 0);
}

void TestElasticTubeTasks::overStretchIsCountedOnce() {
    TubeDriver d(tubeExercise(TubeTask::hold));
    d.startRunning();
    d.grasp(0, 1);
    const ElasticTubeTrial& trial = d.scene.trials()[0];
    int counted = 0;
    const auto to = [&](double ratio) {
        const Vec3 goal(trial.base_m.x(), trial.base_m.y(), ratio * d.p.restLength_m);
        for (int i = 0; i < 50; ++i) {
            d.tool(0).p_WT += (goal - d.tool(0).p_WT) / (50 - i);
            d.tick();
            counted += (d.out.events & bits::kDamaged) ? 1 : 0;
        }
    };
    to(1.75);
    QCOMPARE(counted, 1);
    to(1.60); // 0.60 of 0.70 is above 80 %
    to(1.75);
    QCOMPARE(counted, 1);
    to(1.50);
    to(1.75);
    QCOMPARE(counted, 2);
}

void TestElasticTubeTasks::timeRunsOut() {
    ElasticTubeParameters p = tubeExercise(TubeTask::hold);
    p.trialLimit_s = 0.2;
    TubeDriver d(p);
    d.startRunning();
    d.ticks(198);
    QVERIFY(!(d.events & bits::kTimedOut));
    d.tick();
    QVERIFY(d.out.events & bits::kTimedOut);
    d.tick();
    QCOMPARE(d.out.phase, core::TrialPhase::between);
}

QTEST_APPLESS_MAIN(TestElasticTubeTasks)
#include "test_elastic_tube_tasks.moc"
