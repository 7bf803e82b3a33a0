// SPDX-License-Identifier: GPL-3.0-or-later
#include "comparison_driver.h"
#include "contact_loops.h"

#include "core/fp_environment.h"
#include "core/units.h"

#include <QtTest>

#include <optional>
#include <vector>

using namespace chiron;
using namespace chiron::simulation;
using namespace chiron::simulation::testing;
namespace bits = core::event_bits;
namespace q = comparison_quantity;

namespace {

constexpr double kDamp_N = 1e-9;

/// Without damping, recovery and friction: what is left is conservative.
ComparisonParameters lossless(ComparedAttribute attribute) {
    ComparisonParameters p = compared(attribute);
    p.object.damping_Ns_per_m = p.object.viscosity_Ns_per_m = 0.0;
    p.exploreLimit_s = 0.0;
    return p;
}

bool conservative(ComparedAttribute attribute) {
    return attribute == ComparedAttribute::stiffness || attribute == ComparedAttribute::mass;
}

} // namespace

/// Scene of P2's studies: what is presented lies where it should and pushes as its law says, smoothly and without making energy.
class TestComparisonScene : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { core::setModelFloatingPointEnvironment(); }
    void eachAttribute_data() {
        QTest::addColumn<int>("attribute");
        for (const ComparedAttribute attribute : kComparedAttributes)
            QTest::addRow("%d", static_cast<int>(attribute)) << static_cast<int>(attribute);
    }
    void eachAttribute();
    void noStepOverAnyEdge_data() { eachAttribute_data(); }
    void noStepOverAnyEdge();
    void noTickMakesEnergy_data();
    void noTickMakesEnergy();
    void closedPathsBothWays();
    void tubesPullAsTheirValueSays();
    void objectsWeighAsTheirValueSays();
    void padsPushAlikeWhereTheyDoNotDiffer();
    void controlsAreFaultsOfTheRendering();
    void trialsGoOnByCommand();
    void limitsOfATrial();
    void anAdjustedLevelIsNeverFeltAsAStep();
    void wordsThatDoNotExist();
    void notANumber();
};

/// Arrangement 1 is 0 the other way round; what no present named is not there.
void TestComparisonScene::eachAttribute() {
    QFETCH(int, attribute);
    ComparisonDriver d(compared(static_cast<ComparedAttribute>(attribute)));
    for (int place = 0; place < 3; ++place) {
        QCOMPARE(*d.scene.valueAt({0, 0}, place), d.parameters.values[0][static_cast<std::size_t>(place)]);
        QCOMPARE(*d.scene.valueAt({0, 1}, place), d.parameters.values[0][static_cast<std::size_t>(2 - place)]);
    }
    QVERIFY(!d.scene.valueAt({0, 0}, 3) && !d.scene.valueAt({2, 0}, 0) && !d.scene.valueAt({0, 2}, 0));
    d.explore(1); // nothing was presented
    QCOMPARE(d.largestStep_N, 0.0);
    QCOMPARE(d.quantity(q::kTouched), 0.0);
    d.startRunning();
    for (int place = 0; place < 3; ++place) {
        d.explore(place);
        QCOMPARE(d.quantity(q::kTouched), double((2 << place) - 1));
    }
    QVERIFY(d.largestStep_N > 0.0);
    d.moveTo(d.at(1, 0.080), 0.2);
    QCOMPARE(d.force().norm(), 0.0);
}

/// Taken hold of, let go, over the shoulder of a pad and off it: eight times as slowly, the largest step of force is at most a quarter. A
/// step that belongs to the law would stay.
void TestComparisonScene::noStepOverAnyEdge() {
    QFETCH(int, attribute);
    const auto which = static_cast<ComparedAttribute>(attribute);
    ComparisonParameters p = compared(which);
    p.exploreLimit_s = 0.0;
    const auto largestStep_N = [&](double slowness) {
        ComparisonDriver d(p);
        d.slowness = slowness;
        d.startRunning();
        for (int place = 0; place < 3; ++place)
            d.explore(place);
        if (!isHooked(which))
            for (const double height_m : {-0.0005, -0.002, -0.004}) { // slides on and off every pad
                d.moveTo(d.at(0, 0.03) - Vec3(0.030, 0.0, 0.0), 0.5);
                d.moveTo(d.at(0, height_m) - Vec3(0.030, 0.0, 0.0), 0.5);
                d.moveTo(d.at(2, height_m) + Vec3(0.030, 0.002, 0.0), 2.8);
                d.moveTo(d.at(2, 0.03) + Vec3(0.030, 0.0, 0.0), 0.5);
            }
        return d.largestStep_N;
    };
    const double quick_N = largestStep_N(1.0);
    const double slow_N = largestStep_N(8.0);
    QVERIFY2(slow_N < 0.25 * quick_N && slow_N < 0.05, qPrintable(QStringLiteral("%1 N, slowly %2 N").arg(quick_N).arg(slow_N)));
}

/// All but roughness: the energy of a rough surface is ObjectContact's own test (test_object_contact).
void TestComparisonScene::noTickMakesEnergy_data() {
    QTest::addColumn<int>("attribute");
    for (const ComparedAttribute attribute : kComparedAttributes)
        if (attribute != ComparedAttribute::roughness)
            QTest::addRow("%d", static_cast<int>(attribute)) << static_cast<int>(attribute);
}

/// Whatever is done, in no tick more is stored and given back than was put in (by more than the step's own second order).
void TestComparisonScene::noTickMakesEnergy() {
    QFETCH(int, attribute);
    const auto which = static_cast<ComparedAttribute>(attribute);
    ComparisonDriver d(compared(which));
    d.startRunning();
    const double before_J = d.work_J;
    for (int place = 0; place < 3; ++place)
        d.explore(place);
    QVERIFY2(d.work_J - before_J > -1e-6, qPrintable(QString::number(d.work_J)));
    QVERIFY2(d.largestMade_J < 2e-5, qPrintable(QString::number(d.largestMade_J)));
}

/// Random loops through slack, stretch, lift, bed and both directions: ≥ −1 µJ.
void TestComparisonScene::closedPathsBothWays() {
    core::Random random(5);
    for (const ComparedAttribute attribute : kComparedAttributes) {
        if (!conservative(attribute))
            continue;
        ComparisonDriver d(lossless(attribute));
        d.startRunning();
        d.moveTo(d.at(1, d.hook_m()), 0.4);
        for (int loop = 0; loop < 100; ++loop) {
            // an object stays held over its bed: pressed deeper than kPress_N it would be let go, which test "noTickMakesEnergy" does
            const double lowest_m = attribute == ComparedAttribute::mass ? 0.0 : -0.008;
            std::vector<Vec3> path = randomLoop(random, d.at(1, d.hook_m() + 0.004), 0.0055, 400); // never let go
            for (Vec3& corner : path)
                corner.z() = std::max(corner.z(), d.hook_m() + lowest_m);
            for (const bool reverse : {false, true}) {
                if (reverse)
                    std::reverse(path.begin(), path.end());
                d.moveTo(path.front(), 0.05);
                const double before_J = d.work_J;
                const double stored_J = d.out.storedEnergy_J;
                for (const Vec3& corner : path) {
                    d.tool().p_WT = corner;
                    d.tick();
                }
                d.tool().p_WT = path.front();
                d.tick();
                const double made_J = d.out.storedEnergy_J - stored_J - (d.work_J - before_J);
QVERIFY2(std::abs(made_J) < 1e-6, qPrintable(QStringLiteral("%1: %2 J in loop %3").arg(int(attribute)).arg(made_J).arg(loop)));
                QVERIFY(d.work_J - before_J > -1e-6);
            }
        }
    }
}

/// T = k x: at rest 5 mm out the force is the value times the stretch, straight back to the foot.
void TestComparisonScene::tubesPullAsTheirValueSays() {
    ComparisonDriver d(lossless(ComparedAttribute::stiffness));
    d.startRunning(0, 1);
    for (int place = 0; place < 3; ++place) {
        d.moveTo(d.at(place, d.hook_m() - 0.002), 0.4);
        QCOMPARE(d.quantity(q::kPlace), place + 1.0);
        QCOMPARE(d.force().norm(), 0.0); // zero depth, zero force
        d.moveTo(d.at(place, d.hook_m() + 0.005), 0.2);
        d.ticks(5);
        QVERIFY(std::abs(-d.force().z() - 0.005 * *d.scene.valueAt({0, 1}, place)) < kDamp_N);
        QVERIFY(std::abs(d.quantity(q::kDisplacement) - 0.005) < 1e-12);
        d.moveTo(d.at(place, d.hook_m() - 0.012), 0.2);
        QCOMPARE(d.quantity(q::kPlace), 0.0); // let go where it is slack
    }
}

/// Held in the air it weighs m g, as it lies nothing, pressed by 1 mm its bed pushes.
void TestComparisonScene::objectsWeighAsTheirValueSays() {
    ComparisonDriver d(lossless(ComparedAttribute::mass));
    d.startRunning();
    for (int place = 0; place < 3; ++place) {
        const double weight_N = *d.scene.valueAt({0, 0}, place) * core::kStandardGravity;
        d.moveTo(d.at(place, d.hook_m() + 0.03), 0.3);
        d.moveTo(d.at(place, d.hook_m()), 0.4);
        const Vec3 lies = d.tool().p_WT; // taken on the way; its offset stays
        const double taken_m = d.quantity(q::kDisplacement);
        d.moveTo(lies - Vec3(0.0, 0.0, taken_m), 0.1);
        d.ticks(2);
        QVERIFY(d.force().norm() < 1e-9);
        d.moveTo(lies + Vec3(0.0, 0.0, 0.02), 0.3);
        d.ticks(2);
        QVERIFY(std::abs(d.force().z() + weight_N) < 1e-9 && d.force().head<2>().norm() == 0.0);
        d.moveTo(lies - Vec3(0.0, 0.0, taken_m + 0.001), 0.3);
        d.ticks(2);
        QVERIFY(std::abs(d.force().z() - 0.4) < 1e-9);
        d.moveTo(lies + Vec3(0.0, 0.0, 0.03), 0.3);
        QCOMPARE(d.force().norm(), 0.0); // lifted, pressed and released: let go
    }
}

/// Two places with the same value feel the same to the last bit; with another value they do not.
void TestComparisonScene::padsPushAlikeWhereTheyDoNotDiffer() {
    for (const ComparedAttribute attribute : {ComparedAttribute::deformation, ComparedAttribute::friction, ComparedAttribute::viscosity}) {
        ComparisonParameters p = compared(attribute);
        p.arrangements = {{0, 2, 0}};
        std::vector<Vec3> felt[3];
        ComparisonDriver d(p);
        d.startRunning();
        for (int place = 0; place < 3; ++place) {
            d.moveTo(d.at(place, 0.02), 0.3);
            for (int i = 0; i <= 300; ++i) {
                const double s = 0.01 * i;
                d.tool().p_WT = d.at(place, 0.004 - 0.008 * std::min(1.0, s), 0.004 * std::sin(s));
                d.tick();
                felt[place].push_back(d.force());
            }
            d.moveTo(d.at(place, 0.02), 0.3);
        }
        double same_N = 0.0, other_N = 0.0;
        for (std::size_t i = 0; i < felt[0].size(); ++i) {
            same_N = std::max(same_N, (felt[0][i] - felt[2][i]).norm());
            other_N = std::max(other_N, (felt[0][i] - felt[1][i]).norm());
        }
        QVERIFY2(same_N < 1e-9, qPrintable(QString::number(same_N))); // x differs by place: rounding
        QVERIFY2(other_N > 0.02, qPrintable(QString::number(other_N)));
    }
}

void TestComparisonScene::controlsAreFaultsOfTheRendering() {
    ComparisonParameters p = compared(ComparedAttribute::stiffness);
    const auto pulled = [&](ComparisonControl control) {
        p.control = control;
        ComparisonDriver d(p);
        d.startRunning();
        d.moveTo(d.at(0, d.hook_m() - 0.002), 0.4);
        d.moveTo(d.at(0, d.hook_m() + 0.005), 0.2);
        d.ticks(2);
        return -d.force().z();
    };
    const double plain_N = pulled(ComparisonControl::none);
    QVERIFY(std::abs(pulled(ComparisonControl::gain) - kControlGain * plain_N) < 1e-12);
    QVERIFY(std::abs(pulled(ComparisonControl::swapped) - 2.0 * plain_N) < 1e-9);
    p.arrangements = {{2, 1, 0}};
    QVERIFY(std::abs(pulled(ComparisonControl::constant) - plain_N) < 1e-9);
}

void TestComparisonScene::trialsGoOnByCommand() {
    ComparisonDriver d(compared(ComparedAttribute::friction));
    d.ticks(100);
    QVERIFY(d.out.phase == core::TrialPhase::idle);
    d.in.forceReady = false;
    d.present(0, 0);
    d.ticks(30);
    QVERIFY(d.out.phase == core::TrialPhase::ready); // no trial without force
    QCOMPARE(d.events & bits::kSceneChanged, bits::kSceneChanged);
    d.in.forceReady = true;
    d.tick();
    QVERIFY(d.out.phase == core::TrialPhase::running && (d.out.events & bits::kTrialStarted) != 0);
    QCOMPARE(d.quantity(q::kCandidate), 1.0);
    d.present(1, 1); // early: waits for its time, and changes nothing now
    QCOMPARE(d.quantity(q::kCandidate), 1.0);
    d.in.paused = true;
    d.answer(4);
    d.ticks(50);
    QVERIFY(d.out.phase == core::TrialPhase::running); // an answer in a pause counts when it goes on
    d.in.paused = false;
    d.tick();
    QVERIFY((d.out.events & bits::kCompleted) != 0);
    QCOMPARE(d.quantity(q::kAnswer), 5.0);
    d.tick();
    QVERIFY(d.out.phase == core::TrialPhase::between);
    d.ticks(25);
    QVERIFY(d.out.phase == core::TrialPhase::running);
    QCOMPARE(d.out.trial, std::uint16_t(1));
    QCOMPARE(d.quantity(q::kCandidate), 2.0);
    QCOMPARE(d.quantity(q::kAnswer), 0.0);
    d.answer(kAnswerFinish);
    QVERIFY((d.out.events & (bits::kFailed | bits::kFinished)) != 0);
    d.ticks(3);
    QVERIFY(d.out.phase == core::TrialPhase::finished);
    d.present(0, 0);
    d.ticks(50);
    QVERIFY(d.out.phase == core::TrialPhase::finished);
}

/// After the time to explore nothing is there; after the time to answer the trial ends unanswered.
void TestComparisonScene::limitsOfATrial() {
    ComparisonParameters p = compared(ComparedAttribute::viscosity);
    p.exploreLimit_s = 0.5;
    p.answerLimit_s = 0.3;
    ComparisonDriver d(p);
    d.startRunning();
    d.tool().p_WT = d.at(1, -0.002);
    d.ticks(498);
    QVERIFY(d.force().norm() > 0.5 && d.out.cues.laparoscopy.objectShown);
    d.ticks(4);
    QCOMPARE(d.force().norm(), 0.0);
    QVERIFY(!d.out.cues.laparoscopy.objectShown && d.out.phase == core::TrialPhase::running);
    d.ticks(300);
    QVERIFY((d.events & bits::kTimedOut) != 0 && d.out.phase == core::TrialPhase::between);
}

/// A new level comes to a place while nobody touches it, to the touched one as soon as it is left.
void TestComparisonScene::anAdjustedLevelIsNeverFeltAsAStep() {
    ComparisonParameters p = lossless(ComparedAttribute::stiffness);
    p.adjusts = true;
    ComparisonDriver d(p);
    d.startRunning(0, 0);
    d.moveTo(d.at(2, d.hook_m() - 0.002), 0.4);
    d.moveTo(d.at(2, d.hook_m() + 0.006), 0.3);
    d.ticks(2);
    const double before_N = -d.force().z();
    d.largestStep_N = 0.0;
    d.present(1, 0);
    d.ticks(20);
    QCOMPARE(d.largestStep_N, 0.0);
    QCOMPARE(-d.force().z(), before_N);
    d.moveTo(d.at(2, d.hook_m() - 0.015), 0.3);
    d.moveTo(d.at(2, d.hook_m() - 0.002), 0.3);
    d.moveTo(d.at(2, d.hook_m() + 0.006), 0.3);
    d.ticks(2);
    QVERIFY(std::abs(-d.force().z() - 0.006 * p.values[1][2]) < kDamp_N);
    QVERIFY(d.out.phase == core::TrialPhase::running);
}

void TestComparisonScene::wordsThatDoNotExist() {
    ComparisonDriver d(compared(ComparedAttribute::mass));
    d.present(2, 0);
    d.present(0, 2);
    d.ticks(100);
    QVERIFY(d.out.phase == core::TrialPhase::idle);
    ComparisonParameters none = compared(ComparedAttribute::mass);
    none.values.clear();
    none.arrangements.clear();
    ComparisonDriver empty(none);
    empty.present(0, 0);
    empty.explore(0);
    QCOMPARE(empty.largestStep_N, 0.0);
}

void TestComparisonScene::notANumber() {
    for (const ComparedAttribute attribute : kComparedAttributes) {
        ComparisonDriver d(compared(attribute));
        d.startRunning();
        d.moveTo(d.at(1, isHooked(attribute) ? d.hook_m() : -0.002), 0.3);
        for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
            const Vec3 good = d.tool().p_WT;
            d.tool().p_WT.z() = bad;
            d.scene.respond(d.source.next(0), d.in, d.out);
            QCOMPARE(d.force().norm(), 0.0);
            d.tool().p_WT = good;
            d.tool().v_WT = Vec3::Zero();
            d.scene.respond(d.source.next(0), d.in, d.out);
            QVERIFY(d.force().allFinite());
            d.last = good;
        }
    }
}

QTEST_APPLESS_MAIN(TestComparisonScene)
#include "test_comparison_scene.moc"
