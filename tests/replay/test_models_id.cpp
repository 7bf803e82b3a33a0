// SPDX-License-Identifier: GPL-3.0-or-later
// The models id names the laws and their numerics (data.md, Samples). Forces that were stored with an id are
// made again: where they differ and the id does not, somebody changed a law and did not say so, and replays
// of stored sessions would be called tampering.
#include "core/fp_environment.h"
#include "support/haptic_bench.h"
#include "sweep/level_sweep.h"
#include "unit/simulation/comparison_driver.h"

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QtTest>
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <vector>

using namespace chiron;

namespace {

const QString kFile = QStringLiteral(CHIRON_SOURCE_DIR "/tests/replay/model_forces.json");
constexpr std::uint64_t kSeed = 20261125;
constexpr std::array<int, 2> kScenes{
    0, 10}; ///< the first path of a scene that begins in the air, and of one that begins anywhere
constexpr int kPaths = 4; ///< of each
constexpr double kPath_s = 3.0;
constexpr std::uint64_t kBlock_ticks = 500;
/// Of a sum over 500 ticks, N or N·m. Libraries of mathematics round differently on processors with and
/// without FMA, by some 1e-16 of a force; a changed law moves the sum by far more.
constexpr double kSame = 1e-7;

/// Sums of force and torque over blocks of 500 ticks, as six numbers for each tool.
class Sums {
public:
    void add(std::uint64_t tick, const core::Wrench& w, std::size_t tool, std::size_t tools) {
        add(tick, {w.force.x(), w.force.y(), w.force.z(), w.torque.x(), w.torque.y(), w.torque.z()}, tool,
            tools);
    }
    void add(std::uint64_t tick, const double (&wrench)[6], std::size_t tool, std::size_t tools) {
        const std::size_t at = (static_cast<std::size_t>(tick / kBlock_ticks) * tools + tool) * 6;
        if (m_sums.size() < at + 6)
            m_sums.resize(at + 6, 0.0);
        for (std::size_t i = 0; i < 6; ++i)
            m_sums[at + i] += wrench[i];
    }
    QJsonArray json() const {
        QJsonArray array;
        for (const double sum : m_sums)
            array.append(QString::number(sum, 'g', 12).toDouble());
        return array;
    }

private:
    std::vector<double> m_sums;
};

/// Everything of every level, without loop and device: what the scenes answer along the sweep's paths.
QJsonObject sceneForces(const catalogue::Catalogue& catalogue) {
    QJsonObject levels;
    for (const catalogue::Exercise& exercise : catalogue.exercises())
        for (const catalogue::ExerciseLevel& level : exercise.levels) {
            std::vector<Sums> paths(kScenes.size() * kPaths);
            tests::SweepSettings settings;
            settings.seed = kSeed;
            settings.paths = kPaths;
            settings.path_s = kPath_s;
            std::size_t scene = 0;
            settings.witness = [&](std::uint64_t path, std::uint64_t tick,
                                   const simulation::SceneOutput& out) {
                const auto tools = static_cast<std::size_t>(out.tissue.count);
                for (std::size_t i = 0; i < tools; ++i)
                    paths[scene * kPaths + path - static_cast<std::uint64_t>(settings.firstPath)].add(
                        tick, out.tissue.tools[i], i, tools);
            };
            for (; scene < kScenes.size(); ++scene) {
                settings.firstPath = kScenes[scene];
                tests::sweepLevel(level, settings);
            }
            QJsonArray all;
            for (const Sums& path : paths)
                all.append(path.json());
            levels[QString::fromStdString(exercise.id + "/" + level.id)] = all;
        }
    return levels;
}

/// Of simulation::testing::kComparedAttributes.
constexpr std::array kAttributeNames{"stiffness", "mass",     "deformation",
                                     "roughness", "friction", "viscosity"};

/// What a study compares, which no level of the content has: each attribute, touched as it asks for.
QJsonArray comparedForces(simulation::ComparedAttribute attribute) {
    Sums sums;
    std::uint64_t tick = 0;
    for (const int which : {0, 1}) {
        simulation::testing::ComparisonDriver driver(simulation::testing::compared(attribute));
        driver.witness = [&](const simulation::SceneOutput& out) {
            sums.add(tick++, out.tissue.tools[0], 0, 1);
        };
        driver.startRunning(which, which);
        for (int place = 0; place < 3; ++place)
            driver.explore(place);
    }
    return sums.json();
}

/// An object that is pressed onto its bed until the bed gives way, and taken hold of again.
QJsonArray pressedObjectForces() {
    simulation::ComparisonParameters p = simulation::testing::compared(simulation::ComparedAttribute::mass);
    p.yield.force_N = 12.0;
    Sums sums;
    std::uint64_t tick = 0;
    simulation::testing::ComparisonDriver driver(p);
    driver.witness = [&](const simulation::SceneOutput& out) { sums.add(tick++, out.tissue.tools[0], 0, 1); };
    driver.startRunning();
    driver.moveTo(driver.at(0, driver.hook_m() + 0.04), 0.3);
    driver.moveTo(driver.at(0, driver.hook_m()), 0.4);
    driver.moveTo(driver.at(0, driver.hook_m() - 0.06), 0.6);
    driver.moveTo(driver.at(0, driver.hook_m() + 0.04), 0.6);
    return sums.json();
}

/// A floor for each tool, each a body of its own. The one of tool 0 may stiffen by itself while it is
/// pressed: it then gives more than was put in, and is rendered softer where the scene states energy per
/// body.
class StiffeningFloors final : public simulation::IScene {
public:
    StiffeningFloors(bool stiffens, bool byBody) : m_stiffens(stiffens), m_byBody(byBody) {}
    void respond(const realtime::HapticTick& now, const simulation::SceneInput& in,
                 simulation::SceneOutput& out) noexcept override {
        constexpr double kFloor_m = 0.020, kSoft_N_per_m = 200.0, kRise_N_per_m = 1300.0;
        const double risen =
            std::clamp(static_cast<double>(now.index()) * core::kTickSeconds - 5.0, 0.0, 1.0);
        out = simulation::SceneOutput{};
        out.phase = core::TrialPhase::running;
        out.energyByBody = m_byBody;
        out.tissue.count = in.tools.count;
        for (std::size_t i = 0; i < static_cast<std::size_t>(in.tools.count); ++i) {
            const core::Vec3& p_WT = in.tools.tools[i].p_WT;
            const double depth_m = kFloor_m - p_WT.z();
            out.p_WProxy[i] = p_WT;
            if (m_byBody)
                out.body[i] = static_cast<std::uint8_t>(i);
            if (depth_m <= 0.0)
                continue;
            const double k_N_per_m = kSoft_N_per_m + (m_stiffens && i == 0 ? risen * kRise_N_per_m : 0.0);
            const double stored_J = 0.5 * k_N_per_m * depth_m * depth_m;
            out.tissue.tools[i].force = k_N_per_m * depth_m * core::Vec3::UnitZ();
            out.storedEnergy_J += stored_J;
            out.contactStiffness_N_per_m = std::max(out.contactStiffness_N_per_m, k_N_per_m);
            if (m_byBody) {
                out.bodyEnergy_J[i] = stored_J;
                out.bodyStiffness_N_per_m[i] = k_N_per_m;
            }
        }
    }

private:
    bool m_stiffens;
    bool m_byBody;
};

/// A scene through loop, passivity controller and supervisor: what the devices were commanded.
QJsonArray commandedForces(std::unique_ptr<simulation::IScene> scene,
                           const haptics::SafetySettings& safety = {}, std::size_t count = 1) {
    std::vector<std::unique_ptr<tests::BenchDevice>> devices;
    std::vector<haptics::LoopTool> tools;
    for (std::size_t i = 0; i < count; ++i) {
        devices.push_back(std::make_unique<tests::BenchDevice>(tests::circlingPath));
        tools.push_back({*devices.back(), {}});
    }
    haptics::LiveInputs inputs;
    tests::FrameStore frames;
    tests::LoopBench bench(tools, inputs, frames, std::move(scene), safety);
    inputs.post({core::CommandKind::start});
    realtime::TickSource ticks;
    Sums sums;
    for (std::uint64_t tick = 0; tick < 9000; ++tick)
        bench.loop->tick(ticks.next(static_cast<std::int64_t>(tick) * 1'000'000));
    for (const core::HapticFrame& frame : frames.frames)
        for (std::size_t i = 0; i < count; ++i)
            sums.add(frame.header.index, core::toWrench(frame.tool[i].commanded), i, count);
    return sums.json();
}

/// Two tools on two floors.
QJsonArray onFloors(bool stiffens, bool byBody) {
    return commandedForces(std::make_unique<StiffeningFloors>(stiffens, byBody), {}, 2);
}

/// Of two, the sums of one.
QJsonArray ofTool(const QJsonArray& sums, qsizetype tool) {
    QJsonArray own;
    for (qsizetype i = 0; i < sums.size(); ++i)
        if (i / 6 % 2 == tool)
            own.append(sums[i]);
    return own;
}

/// The dome presses harder than this cap.
haptics::SafetySettings lowCap(double knee) {
    haptics::SafetySettings safety;
    safety.exerciseForce_N = 1.0;
    safety.capKnee = knee;
    return safety;
}

/// A ball whose dimple reaches into the circle of the bench's path; the sweep's paths walk past that of the
/// level.
simulation::SphereApexParameters dimpledBall() {
    simulation::SphereApexParameters ball = tests::benchExercise();
    ball.dimpleDepth_m = 0.0015;
    ball.dimpleRadius_m = 0.009;
    return ball;
}

double largest(const QJsonValue& value) {
    double most = std::abs(value.toDouble());
    for (const QJsonValue& item : value.toArray())
        most = std::max(most, largest(item));
    return most;
}

double difference(const QJsonValue& a, const QJsonValue& b) {
    if (a.isDouble() && b.isDouble())
        return std::abs(a.toDouble() - b.toDouble());
    const QJsonArray x = a.toArray(), y = b.toArray();
    if (!a.isArray() || !b.isArray() || x.size() != y.size())
        return HUGE_VAL;
    double most = 0.0;
    for (qsizetype i = 0; i < x.size(); ++i)
        most = std::max(most, difference(x[i], y[i]));
    return most;
}

} // namespace

class TestModelsId : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void forcesAreTheStoredOnes();
    void everyLevelIsFelt();
    void theDimpleIsFelt();
    void theKneeIsFelt();
    void theSofterBodyIsFelt();

private:
    QJsonObject m_now;
};

void TestModelsId::initTestCase() {
    core::setModelFloatingPointEnvironment();
    m_now = sceneForces(*catalogue::Catalogue::load(CHIRON_SOURCE_DIR "/curriculum/content"));
    for (std::size_t i = 0; i < kAttributeNames.size(); ++i)
        m_now[QStringLiteral("comparison, %1").arg(QLatin1String(kAttributeNames[i]))] =
            comparedForces(simulation::testing::kComparedAttributes[i]);
    m_now[QStringLiteral("comparison, pressed mass")] = pressedObjectForces();
    m_now[QStringLiteral("loop")] = commandedForces(tests::apexScene());
    m_now[QStringLiteral("loop, dimple")] = commandedForces(tests::apexScene(dimpledBall()));
    m_now[QStringLiteral("loop, knee")] = commandedForces(tests::apexScene(), lowCap(0.3));
    m_now[QStringLiteral("loop, softer body")] = onFloors(true, true);
    if (qEnvironmentVariableIsSet("CHIRON_STORE_MODEL_FORCES")) {
        QFile file(kFile);
        QVERIFY(file.open(QIODevice::WriteOnly));
        QByteArray text =
            QJsonDocument(QJsonObject{{QStringLiteral("models"),
                                       QString::fromStdString(core::modelsOfBuild(core::buildId()))},
                                      {QStringLiteral("sums"), m_now}})
                .toJson(QJsonDocument::Compact);
        file.write(text.replace("],\"", "],\n\"") + '\n');
    }
}

void TestModelsId::forcesAreTheStoredOnes() {
    QFile file(kFile);
    QVERIFY2(file.open(QIODevice::ReadOnly), qPrintable(kFile));
    const QJsonObject stored = QJsonDocument::fromJson(file.readAll()).object();
    const QJsonObject sums = stored[QStringLiteral("sums")].toObject();
    QStringList differing;
    for (const QString& key : m_now.keys())
        if (const double d = difference(m_now[key], sums[key]); !(d <= kSame))
            differing << QStringLiteral("%1 (by %2)").arg(key).arg(d);
    for (const QString& key : sums.keys())
        if (!m_now.contains(key))
            differing << key + QStringLiteral(" (gone)");
    const QString id = QString::fromStdString(core::modelsOfBuild(core::buildId()));
    const bool sameId = stored[QStringLiteral("models")].toString() == id;
    QVERIFY2(differing.isEmpty(),
             qPrintable(QStringLiteral("%1.\nForces differ from those stored for models %2: %3.\nIf a law or "
                                       "its numerics changed, raise CHIRON_MODELS_ID in "
                                       "modules/core/CMakeLists.txt; if only content, a level or the sweep's "
                                       "paths changed, keep it. Then run this test once with "
                                       "CHIRON_STORE_MODEL_FORCES=1 and commit the file.")
                            .arg(sameId ? QStringLiteral("The models id was not raised")
                                        : QStringLiteral("The stored forces are of another models id"),
                                 stored[QStringLiteral("models")].toString(),
                                 differing.join(QStringLiteral(", ")))));
    QVERIFY2(sameId, "the models id was raised although no force changed: recordings would be called "
                     "incomparable for nothing");
}

void TestModelsId::everyLevelIsFelt() {
    for (const QString& key : m_now.keys())
        QVERIFY2(largest(m_now[key]) > 1.0,
                 qPrintable(key)); // N × ticks: a path that touches nothing watches over nothing
}

void TestModelsId::theDimpleIsFelt() {
    QVERIFY(difference(m_now[QStringLiteral("loop")], m_now[QStringLiteral("loop, dimple")]) > 1.0);
}

/// Otherwise than a force that is cut off at the same cap.
void TestModelsId::theKneeIsFelt() {
    QVERIFY(difference(m_now[QStringLiteral("loop, knee")],
                       commandedForces(tests::apexScene(), lowCap(0.0))) > 1.0);
}

/// Softer than its law, otherwise than by damping, and the other body is not.
void TestModelsId::theSofterBodyIsFelt() {
    const QJsonArray softer = m_now[QStringLiteral("loop, softer body")].toArray(),
                     still = onFloors(false, true);
    QVERIFY(difference(softer, onFloors(true, false)) > 1.0);
    QVERIFY(difference(ofTool(softer, 0), ofTool(still, 0)) > 1.0);
    QCOMPARE(difference(ofTool(softer, 1), ofTool(still, 1)), 0.0);
    QVERIFY(largest(ofTool(softer, 1)) > 1.0);
}

QTEST_GUILESS_MAIN(TestModelsId)
#include "test_models_id.moc"
