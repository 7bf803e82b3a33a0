// SPDX-License-Identifier: GPL-3.0-or-later
// A tool pushed, dragged and lifted through every level of every exercise: no force without bound, none that jumps, none in free air.
#include "sweep/level_sweep.h"

#include <QtTest>
#include <cstdio>
#include <random>

using namespace chiron;
using tests::SweepResult;

namespace {

constexpr double kChange_N = 0.1; ///< in a tick, above stiffness times way: what is allowed for rounding and for what a scene's bound leaves out

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

private:
    catalogue::Catalogue m_catalogue = *catalogue::Catalogue::load(CHIRON_SOURCE_DIR "/curriculum/content");
};

void TestLevelSweep::everyLevel_data() {
    QTest::addColumn<QString>("exercise");
    QTest::addColumn<int>("number");
    std::printf("%s\n", SweepResult::heading().c_str());
    for (const catalogue::Exercise& exercise : m_catalogue.exercises())
        for (const catalogue::ExerciseLevel& level : exercise.levels)
            QTest::newRow((exercise.id + "_" + std::to_string(level.number)).c_str()) << QString::fromStdString(exercise.id) << level.number;
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
        QSKIP("the content does not say at which force the tissue gives way: only the long test fails for that");
    QVERIFY(result.finite);
    QVERIFY2(result.yieldStated, "the content does not say at which force the tissue gives way");
    QVERIFY2(result.yieldForce_N <= 3.0 * result.limit_N, "yields only beyond three times the level's limit");
    QVERIFY2(result.force.value <= result.yieldForce_N * (1.0 + 1e-9), "more force than the tissue bears");
    QVERIFY2(!(result.inAir.value > 0.0), "force where nothing is touched");
    QVERIFY2(!(result.change.value > kChange_N), "the force jumps");
    QVERIFY2(!(result.fall.value > kChange_N), "tissue that gives way falls faster than its curve");
}

QTEST_GUILESS_MAIN(TestLevelSweep)
#include "test_level_sweep.moc"
