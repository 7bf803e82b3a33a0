// SPDX-License-Identifier: GPL-3.0-or-later
// A tool pushed, dragged and lifted through every level of every exercise, and through the objects of every
// study: no force without bound, none that jumps, none in free air, and no energy that nobody put in.
#include "catalogue/study_catalogue.h"
#include "core/random.h"
#include "session/study/study_setup.h"
#include "simulation/geometry/mesh/make_mesh.h"
#include "support/level_rows.h"
#include "sweep/level_sweep.h"
#include "sweep/sweep_facts.h"
#include "sweep/triangle_distance.h"

#include <QtTest>
#include <cmath>
#include <cstdio>
#include <random>

using namespace chiron;
using tests::SweepResult;

namespace {

constexpr double kChange_N = 0.1; ///< in a tick, above stiffness times way: what is allowed for rounding and
                                  ///< for what a scene's bound leaves out
constexpr double kChange_Nm = 0.001; ///< likewise: 0.1 N over a lever of 10 mm, which is as long as the beak
constexpr double kMade_J = 1e-6;     ///< models.md §0: what a law with a potential may make in one contact
constexpr std::uint64_t kFastSeed = 4711;

#ifdef CHIRON_LONG_SWEEP
constexpr bool kLong = true;
#else
constexpr bool kLong = false;
#endif

std::uint64_t seedOfRun() {
    bool given = false;
    const std::uint64_t seed = qEnvironmentVariable("CHIRON_SWEEP_SEED").toULongLong(&given);
    return given ? seed : (kLong ? std::random_device{}() : kFastSeed);
}

int pathsOfRun() {
    return kLong ? 200 * std::max(1, qEnvironmentVariableIntValue("CHIRON_SOAK")) : 12;
}

} // namespace

class TestLevelSweep : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void everyLevel_data();
    void everyLevel();
    void everyLevelIsGuarded_data();
    void everyLevelIsGuarded();
    void everyStudy_data();
    void everyStudy();
    void everyStudyIsGuarded_data();
    void everyStudyIsGuarded();
    void formerJumps_data();
    void formerJumps();
    void aSceneTellsWhetherItsLawHasAPotential_data();
    void aSceneTellsWhetherItsLawHasAPotential();
    void distancesFromTriangles();

private:
    void levels();
    void conditions();
    catalogue::ExerciseLevel conditionLevel() const;
    SweepResult swept(const catalogue::ExerciseLevel& level, bool guarded) const;
    void judgeLaw(const SweepResult& result) const;
    void judgeYield(const SweepResult& result) const;
    void judgeGuard(const SweepResult& result) const;

    catalogue::Catalogue m_catalogue = *catalogue::Catalogue::load(CHIRON_SOURCE_DIR "/curriculum/content");
    catalogue::StudyCatalogue m_studies =
        *catalogue::StudyCatalogue::load(CHIRON_SOURCE_DIR "/curriculum/content");
    std::uint64_t m_seed = seedOfRun();
};

void TestLevelSweep::initTestCase() {
    std::printf("seed of all paths: %llu (CHIRON_SWEEP_SEED repeats it)\n",
                static_cast<unsigned long long>(m_seed));
}

void TestLevelSweep::levels() {
    tests::addLevelRows(m_catalogue);
}

/// What is felt side by side in a study. Those that look for the apex are a level of sphere_apex.
void TestLevelSweep::conditions() {
    QTest::addColumn<QString>("study");
    QTest::addColumn<QString>("condition");
    for (const psychophysics::StudyDesign& design : m_studies.studies())
        for (const psychophysics::Condition& condition : design.conditions)
            if (condition.stimulus.attribute != psychophysics::Attribute::apex)
                QTest::newRow((design.id + "_" + condition.id).c_str())
                    << QString::fromStdString(design.id) << QString::fromStdString(condition.id);
}

catalogue::ExerciseLevel TestLevelSweep::conditionLevel() const {
    QFETCH(QString, study);
    QFETCH(QString, condition);
    const psychophysics::StudyDesign& design = *m_studies.find(study.toStdString());
    auto level = session::studyLevel(design, *session::conditionOf(design, condition.toStdString()));
    if (!level)
        qFatal("%s", level.error().message.c_str());
    return *level;
}

SweepResult TestLevelSweep::swept(const catalogue::ExerciseLevel& level, bool guarded) const {
    tests::SweepSettings settings;
    settings.seed = m_seed;
    settings.paths = pathsOfRun();
    settings.guarded = guarded;
    const SweepResult result = tests::sweepLevel(level, settings);
    std::printf("%s\n", (guarded ? result.guardedLine() : result.line()).c_str());
    std::fflush(stdout);
    return result;
}

/// What is asked of every law, whether its tissue gives way or not.
void TestLevelSweep::judgeLaw(const SweepResult& result) const {
    QVERIFY(result.finite);
    QVERIFY2(result.measured,
             "no tests/exercises/<id>/sweep_facts.cpp says where this exercise's objects are");
    QVERIFY2(!(result.inAir.value > 0.0), "force where nothing is touched, by true distances");
    QVERIFY2(!(result.inAirAsTold.value > 0.0), "force where the scene itself says that nothing is touched");
    QVERIFY2(!(result.change.value > kChange_N), "the force jumps");
    if (result.conservative)
        QVERIFY2(!(result.made.value > kMade_J), "a law that has a potential makes energy");
    if (kLong)
        QVERIFY2(result.touching > 0 && result.closed > 0, "no contact was followed from beginning to end");
}

/// What is asked where the content has to say how much tissue bears.
void TestLevelSweep::judgeYield(const SweepResult& result) const {
    QVERIFY2(result.yieldStated, "the content does not say at which force the tissue gives way");
    QVERIFY2(result.yieldForce_N <= 3.0 * result.limit_N, "yields only beyond three times the level's limit");
    QVERIFY2(result.force.value <= result.yieldForce_N * (1.0 + 1e-9), "more force than the tissue bears");
    QVERIFY2(!(result.fall.value > kChange_N), "tissue that gives way falls faster than its curve");
}

void TestLevelSweep::judgeGuard(const SweepResult& result) const {
    QVERIFY2(result.commanded.value <= result.cap_N * (1.0 + 1e-9), "more force than the cap");
    QVERIFY2(!(result.overReturned.value > 0.0),
             "a contact gave the hand more energy than the passivity controller allows");
    if (kLong)
        QVERIFY2(result.commanded.value > 0.0, "nothing was felt");
}

void TestLevelSweep::everyLevel_data() {
    std::printf("%s\n", SweepResult::heading().c_str());
    levels();
}

void TestLevelSweep::everyLevel() {
    QFETCH(QString, exercise);
    QFETCH(int, number);
    const SweepResult result = swept(*m_catalogue.find(exercise.toStdString(), number), false);
    judgeLaw(result);
    if (QTest::currentTestFailed())
        return;
    if (!kLong && !result.yieldStated)
        QSKIP("the content does not say at which force the tissue gives way: only the long test fails for "
              "that");
    judgeYield(result);
    if (QTest::currentTestFailed())
        return;
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

void TestLevelSweep::everyLevelIsGuarded_data() {
    std::printf("%s\n", SweepResult::guardedHeading().c_str());
    levels();
}

/// The same paths behind the supervisor: a contact gives the hand no more than 1 mJ that nobody put in, at
/// any time, whatever its law makes.
void TestLevelSweep::everyLevelIsGuarded() {
    QFETCH(QString, exercise);
    QFETCH(int, number);
    judgeGuard(swept(*m_catalogue.find(exercise.toStdString(), number), true));
}

void TestLevelSweep::everyStudy_data() {
    std::printf("%s\n", SweepResult::heading().c_str());
    conditions();
}

/// An object that is lifted comes off where it is pressed too hard. Tubes and pads never give way: their
/// forces are bounded by where the mechanism reaches, and what is felt by the cap (everyStudyIsGuarded).
void TestLevelSweep::everyStudy() {
    const SweepResult result = swept(conditionLevel(), false);
    judgeLaw(result);
    if (!QTest::currentTestFailed() && result.givesWay)
        judgeYield(result);
}

void TestLevelSweep::everyStudyIsGuarded_data() {
    std::printf("%s\n", SweepResult::guardedHeading().c_str());
    conditions();
}

void TestLevelSweep::everyStudyIsGuarded() {
    judgeGuard(swept(conditionLevel(), true));
}

void TestLevelSweep::formerJumps_data() {
    QTest::addColumn<QString>("exercise");
    QTest::addColumn<int>("number");
    QTest::addColumn<qulonglong>("seed");
    QTest::addColumn<int>("firstPath");
    for (const auto& [exercise, facts] : tests::SweepFacts::all())
        for (const tests::FormerJump& jump : facts->formerJumps())
            QTest::newRow((exercise + ": " + jump.name).c_str())
                << QString::fromStdString(exercise) << jump.level << qulonglong{jump.seed} << jump.firstPath;
}

void TestLevelSweep::formerJumps() {
    QFETCH(QString, exercise);
    QFETCH(int, number);
    QFETCH(qulonglong, seed);
    QFETCH(int, firstPath);
    tests::SweepSettings settings;
    settings.seed = seed;
    settings.paths = 10;
    settings.firstPath = firstPath;
    settings.pathsPerScene = 20;
    settings.onlyInTheAir = true;
    const SweepResult result = tests::sweepLevel(*m_catalogue.find(exercise.toStdString(), number), settings);
    QVERIFY(result.touching > 0);
    QVERIFY2(!(result.change.value > kChange_N), result.line().c_str());
}

void TestLevelSweep::aSceneTellsWhetherItsLawHasAPotential_data() {
    QTest::addColumn<bool>("told");
    QTest::addColumn<bool>("hasPotential");
    for (const auto& [exercise, facts] : tests::SweepFacts::all())
        for (const tests::StatedLaw& law : facts->laws())
            QTest::newRow((exercise + ": " + law.name).c_str()) << law.told << law.hasPotential;
}

// What everyLevel() judges by: a law says of itself that it has no potential, whatever level renders it.
void TestLevelSweep::aSceneTellsWhetherItsLawHasAPotential() {
    QFETCH(bool, told);
    QFETCH(bool, hasPotential);
    QCOMPARE(told, hasPotential);
}

/// What tells where a mesh is, against a ball: its triangles lie within 0.03 mm of it.
void TestLevelSweep::distancesFromTriangles() {
    simulation::MeshSource source;
    source.shape = simulation::MeshSource::Shape::ellipsoid;
    const auto mesh = simulation::makeMesh(source); // 20 mm
    QVERIFY2(mesh.has_value(), mesh ? "" : mesh.error().message.c_str());
    core::Random random(5);
    for (int n = 0; n < 200; ++n) {
        const core::Vec3 p(random.uniform(-0.03, 0.03), random.uniform(-0.03, 0.03),
                           random.uniform(-0.03, 0.03));
        const double distance_m = tests::signedDistance_m(
            mesh->triangles(),
            [&mesh](std::uint32_t vertex) -> const core::Vec3& { return mesh->position(vertex); }, p,
            mesh->longestEdge_m());
        QVERIFY(std::abs(distance_m - (p.norm() - 0.02)) < 5e-5);
    }
}

QTEST_GUILESS_MAIN(TestLevelSweep)
#include "test_level_sweep.moc"
