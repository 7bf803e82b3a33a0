// SPDX-License-Identifier: GPL-3.0-or-later
// A tool pushed, dragged and lifted through every level of every exercise: no force without bound, none that
// jumps, none in free air.
#include "sweep/level_sweep.h"

#include <QtTest>
#include <cstdio>
#include <random>

using namespace chiron;
using tests::SweepResult;

namespace {

constexpr double kChange_N = 0.1; ///< in a tick, above stiffness times way: what is allowed for rounding and
                                  ///< for what a scene's bound leaves out
constexpr double kChange_Nm = 0.001; ///< likewise: 0.1 N over a lever of 10 mm, which is as long as the beak

#ifdef CHIRON_LONG_SWEEP
constexpr bool kLong = true;
#else
constexpr bool kLong = false;
#endif

std::uint64_t seedOfRun() {
    if (!kLong)
        return 4711;
    bool given = false;
    const std::uint64_t seed = qEnvironmentVariable("CHIRON_SWEEP_SEED").toULongLong(&given);
    return given ? seed : std::random_device{}();
}

} // namespace

class TestLevelSweep : public QObject {
    Q_OBJECT
private slots:
    void everyLevel_data();
    void everyLevel();
    void formerJumps_data();
    void formerJumps();

private:
    catalogue::Catalogue m_catalogue = *catalogue::Catalogue::load(CHIRON_SOURCE_DIR "/curriculum/content");
};

void TestLevelSweep::everyLevel_data() {
    QTest::addColumn<QString>("exercise");
    QTest::addColumn<int>("number");
    std::printf("%s\n", SweepResult::heading().c_str());
    for (const catalogue::Exercise& exercise : m_catalogue.exercises())
        for (const catalogue::ExerciseLevel& level : exercise.levels)
            QTest::newRow((exercise.id + "_" + std::to_string(level.number)).c_str())
                << QString::fromStdString(exercise.id) << level.number;
}

void TestLevelSweep::everyLevel() {
    QFETCH(QString, exercise);
    QFETCH(int, number);
    tests::SweepSettings settings;
    settings.seed = seedOfRun();
    settings.paths = kLong ? 200 * std::max(1, qEnvironmentVariableIntValue("CHIRON_SOAK")) : 12;
    const SweepResult result = tests::sweepLevel(*m_catalogue.find(exercise.toStdString(), number), settings);
    std::printf("%s   seed %llu\n", result.line().c_str(), static_cast<unsigned long long>(settings.seed));
    std::fflush(stdout);
    if (!kLong && !result.yieldStated)
        QSKIP("the content does not say at which force the tissue gives way: only the long test fails for "
              "that");
    QVERIFY(result.finite);
    QVERIFY2(result.yieldStated, "the content does not say at which force the tissue gives way");
    QVERIFY2(result.yieldForce_N <= 3.0 * result.limit_N, "yields only beyond three times the level's limit");
    QVERIFY2(result.force.value <= result.yieldForce_N * (1.0 + 1e-9), "more force than the tissue bears");
    QVERIFY2(!(result.inAir.value > 0.0), "force where nothing is touched");
    QVERIFY2(!(result.change.value > kChange_N), "the force jumps");
    QVERIFY2(!(result.fall.value > kChange_N), "tissue that gives way falls faster than its curve");
    if (result.yieldTorque_Nm == 0.0) {
        QVERIFY2(!(result.torque.value > 0.0),
                 "a torque, and the content does not say at which the tissue gives way");
        return;
    }
    QVERIFY2(result.yieldTorque_Nm <= 3.0 * result.limit_Nm,
             "yields only beyond three times the level's limit of torque");
    QVERIFY2(result.torque.value <= result.yieldTorque_Nm * (1.0 + 1e-9),
             "more torque than the tissue bears");
    QVERIFY2(!(result.torqueChange.value > kChange_Nm), "the torque jumps");
    QVERIFY2(!(result.torqueFall.value > kChange_Nm),
             "the torque of tissue that gives way falls faster than its curve");
}

void TestLevelSweep::formerJumps_data() {
    QTest::addColumn<qulonglong>("seed");
    QTest::addColumn<int>("firstPath");
    QTest::newRow("another sheet, 6 mm deep: 3.6 N") << 13503906239192ull << 140;
    QTest::newRow("another sheet, 4.4 mm deep: 2.6 N") << 17230532855949ull << 120;
    QTest::newRow("another sheet, 1.8 mm deep: 1.05 N") << 14497812207606ull << 120;
    QTest::newRow("the normal turns under a deep tool: 0.21 N") << 8678721026058ull << 0;
    QTest::newRow("the organ moves under a still tool: 0.13 N") << 24069354330247ull << 20;
    QTest::newRow("it turns under a press: 0.26 N") << 17566737335040ull << 60;
}

/// Paths through the soft organ on which the force jumped by so much more than it may, until what is felt of
/// a mesh had a bound (felt_place.h).
void TestLevelSweep::formerJumps() {
    QFETCH(qulonglong, seed);
    QFETCH(int, firstPath);
    tests::SweepSettings settings;
    settings.seed = seed;
    settings.paths = 10;
    settings.firstPath = firstPath;
    settings.pathsPerScene = 20;
    settings.onlyInTheAir = true;
    const SweepResult result = tests::sweepLevel(*m_catalogue.find("sphere_apex", 6), settings);
    QVERIFY(result.touching > 0);
    QVERIFY2(!(result.change.value > kChange_N), result.line().c_str());
}

QTEST_GUILESS_MAIN(TestLevelSweep)
#include "test_level_sweep.moc"
