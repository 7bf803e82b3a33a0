// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/exercises/palpation/operators/palpation_trainee.h"

#include <QtTest>
#include <vector>

using namespace chiron;
using namespace chiron::operators;

/// A palpator that presses a spot several times presses deeper each time, and its last press is as deep as
/// the only press of one that presses once.
class TestPalpationPressures : public QObject {
    Q_OBJECT
private slots:
    void eachPressIsDeeperThanTheOneBefore_data();
    void eachPressIsDeeperThanTheOneBefore();
    void everyPressureIsFeltAtTheSameSpot();
    void noPressIsDeeperThanTheTissueAllows();
};

namespace {

struct Pressed {
    int pressure = 0;
    double depth_m = 0.0;
    core::Vec2 spot_m = core::Vec2::Zero();
};

/// What the first hand orders of one trial on flat tissue, with a hand that is where it wants to be at once
/// and nothing that is felt.
std::vector<Pressed> pressesOfOneTrial(int pressures, double bandHigh_N = 2.5, std::uint64_t seed = 3) {
    PalpationOperatorSettings settings;
    settings.pressures = pressures;
    settings.pressSd = 0.0;
    PalpationBriefing briefing;
    briefing.bandHigh_N = bandHigh_N;
    PalpationTrainee trainee(settings, briefing, seed);
    trainee.wake(0, core::Vec3(0.0, 0.0, 0.02));
    core::VisibleCues cues;
    cues.trial = 1;
    cues.phase = core::TrialPhase::running;
    cues.force = core::ForceState::on;
    std::vector<Pressed> found;
    core::Vec3 place_W(0.0, 0.0, 0.02);
    int last = 0;
    for (int tick = 0; tick < 20'000; ++tick) {
        cues.timeLeft_s = 60.0 - 0.001 * tick;
        trainee.hear(0, 0.001 * tick, cues, place_W);
        const FingerOrder& order = trainee.order(0);
        if (order.press != last)
            found.push_back({order.pressure, -order.goal_W.z(), order.goal_W.head<2>()});
        last = order.press;
        place_W = order.goal_W;
    }
    return found;
}

} // namespace

void TestPalpationPressures::eachPressIsDeeperThanTheOneBefore_data() {
    QTest::addColumn<int>("pressures");
    QTest::addColumn<QList<double>>("shares"); // of the depth of a palpator that presses once
    QTest::newRow("once") << 1 << QList<double>{1.0};
    QTest::newRow("twice") << 2 << QList<double>{0.5, 1.0};
    QTest::newRow("three times") << 3 << QList<double>{0.5, 0.75, 1.0};
}

void TestPalpationPressures::eachPressIsDeeperThanTheOneBefore() {
    QFETCH(int, pressures);
    QFETCH(QList<double>, shares);
    const double once_m = pressesOfOneTrial(1).at(0).depth_m;
    QVERIFY(once_m > 0.001);
    const std::vector<Pressed> presses = pressesOfOneTrial(pressures);
    QVERIFY(presses.size() > 3 * std::size_t(pressures));
    for (std::size_t i = 0; i < presses.size(); ++i) {
        QCOMPARE(presses[i].pressure, int(i) % pressures);
        QVERIFY(std::abs(presses[i].depth_m / once_m - shares[int(i) % pressures]) < 1e-9);
    }
}

void TestPalpationPressures::everyPressureIsFeltAtTheSameSpot() {
    const std::vector<Pressed> presses = pressesOfOneTrial(3);
    for (std::size_t i = 0; i + 2 < presses.size(); i += 3) {
        QVERIFY((presses[i].spot_m - presses[i + 2].spot_m).norm() < 1e-12);
        if (i > 0)
            QVERIFY((presses[i].spot_m - presses[i - 1].spot_m).norm() > 1e-6);
    }
}

void TestPalpationPressures::noPressIsDeeperThanTheTissueAllows() {
    for (const Pressed& press : pressesOfOneTrial(3, 500.0))
        QVERIFY(press.depth_m <= 0.016 + 1e-12);
}

QTEST_APPLESS_MAIN(TestPalpationPressures)
#include "test_palpation_pressures.moc"
