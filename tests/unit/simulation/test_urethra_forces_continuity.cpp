// SPDX-License-Identifier: GPL-3.0-or-later
// Every component is a continuous function of pose: across the entrance, the bend, section boundaries, the
// edges of the moving windows, springs that go slack, the neck and the bladder's wall.
#include "core/fp_environment.h"
#include "urethra_states.h"

#include <QtTest>
#include <algorithm>
#include <functional>

using namespace chiron;
using namespace chiron::simulation;
using namespace chiron::simulation::testing;
using core::Vec3;

namespace {

constexpr std::size_t kComponents = 17;
constexpr std::array<const char*, kComponents> kNames{
    "N",         "F1",        "F2",      "F3",      "T_x",     "T_y",      "T_z",      "U",       "lateral x",
    "lateral y", "lateral z", "force x", "force y", "force z", "torque x", "torque y", "torque z"};

std::array<double, kComponents> componentsOf(const UrethraResponse& r) {
    return {r.normal_N,           r.friction_N,         r.viscous_N,           r.elastic_N,
            r.torqueX_Nm,         r.torqueY_Nm,         r.torqueZ_Nm,          r.energy_J,
            r.lateral_A.x(),      r.lateral_A.y(),      r.lateral_A.z(),       r.wrench_A.force.x(),
            r.wrench_A.force.y(), r.wrench_A.force.z(), r.wrench_A.torque.x(), r.wrench_A.torque.y(),
            r.wrench_A.torque.z()};
}

/// A path x ↦ pose, x in metres of tip travel.
using Path = std::function<EndoscopeMotion(double)>;

/// The largest change of each component from one step to the next.
std::array<double, kComponents> largestChange(const UrethraForces& forces, const Path& path, double length_m,
                                              double step_m) {
    std::array<double, kComponents> largest{};
    auto before = componentsOf(forces.respond(path(0.0)));
    const int steps = static_cast<int>(length_m / step_m);
    for (int i = 1; i <= steps; ++i) {
        const auto now = componentsOf(forces.respond(path(i * step_m)));
        for (std::size_t k = 0; k < kComponents; ++k)
            largest[k] = std::max(largest[k], std::abs(now[k] - before[k]));
        before = now;
    }
    return largest;
}

/// Largest changes must halve when the step is halved (a jump would keep its height): at most 0.6, where not
/// all is zero.
void verifyContinuous(const UrethraForces& forces, const Path& path, double length_m, const char* what) {
    const double step = 1e-5; // 0.01 mm
    const auto whole = largestChange(forces, path, length_m, step);
    const auto half = largestChange(forces, path, length_m, 0.5 * step);
    const auto quarter = largestChange(forces, path, length_m, 0.25 * step);
    for (std::size_t k = 0; k < kComponents; ++k) {
        const QString found =
            QString("%1, %2: %3, %4, %5").arg(what, kNames[k]).arg(whole[k]).arg(half[k]).arg(quarter[k]);
        QVERIFY2(half[k] <= 0.6 * whole[k] + 1e-11, qPrintable(found));
        QVERIFY2(quarter[k] <= 0.35 * whole[k] + 1e-11, qPrintable(found));
    }
}

/// Along the whole canal with waves of offset and tilt.
Path insertion(core::Random& random, const UrethraForces& forces, double offset_m) {
    std::array<double, 4> frequency{}, phase{};
    for (std::size_t k = 0; k < 4; ++k) {
        frequency[k] = random.uniform(50.0, 400.0);
        phase[k] = random.uniform(0.0, 2.0 * core::kPi);
    }
    const Vec3 v = randomVector(random, 0.05), w = randomVector(random, 1.0);
    return [=, &forces](double x) {
        const auto wave = [&](std::size_t k) { return std::sin(frequency[k] * x + phase[k]); };
        EndoscopeMotion m = motionAt(forces.centreline(), {-0.015 + x, offset_m * wave(0), offset_m * wave(1),
                                                           0.4 * wave(2), 0.4 * wave(3)});
        m.v_A = v;
        m.w_A = w;
        return m;
    };
}

} // namespace

class TestUrethraForcesContinuity : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { core::setModelFloatingPointEnvironment(); }
    void alongTheCanal_data() { rows(); }
    void alongTheCanal();
    void straightAcross_data() { rows(); }
    void straightAcross();
    void overTheBladdersWall();

private:
    static void rows() {
        QTest::addColumn<int>("which");
        for (int i = 0; i < static_cast<int>(variants().size()); ++i)
            QTest::newRow(variants()[static_cast<std::size_t>(i)].name) << i;
    }
    static UrethraForces make(int which) {
        const Variant v = variants()[static_cast<std::size_t>(which)];
        return UrethraForces(v.anatomy, v.endoscope, v.settings);
    }
};

void TestUrethraForcesContinuity::alongTheCanal() {
    QFETCH(int, which);
    const UrethraForces forces = make(which);
    core::Random random(31);
    for (const double offset : {0.0, 0.001, 0.003, 0.007})
        verifyContinuous(forces, insertion(random, forces, offset), 0.200, "insertion");
}

void TestUrethraForcesContinuity::straightAcross() {
    QFETCH(int, which);
    const UrethraForces forces = make(which);
    core::Random random(32);
    for (int n = 0; n < 20; ++n) { // straight lines between random places, any way across the canal
        const EndoscopeMotion from = randomMotion(random, forces.centreline());
        const Vec3 way = randomVector(random, 1.0).normalized();
        const auto path = [&](double x) {
            EndoscopeMotion m = from;
            m.p_A += (x - 0.005) * way;
            m.axis_A = Eigen::AngleAxisd(20.0 * x, Vec3(way.y(), way.z(), way.x())) * from.axis_A;
            return m;
        };
        verifyContinuous(forces, path, 0.010, "straight");
    }
}

void TestUrethraForcesContinuity::overTheBladdersWall() {
    const UrethraForces forces({}, {});
    const CentrelinePoint neck = forces.centreline().at(forces.centreline().length_m());
    const Vec3 centre = neck.p_A + 0.035 * neck.t_A;
    core::Random random(33);
    for (int n = 0; n < 10;
         ++n) { // great circles through the opening, from free space to 5 mm into the wall and back
        const double turn = random.uniform(0.0, 2.0 * core::kPi);
        const Vec3 side = std::cos(turn) * Vec3::UnitX() + std::sin(turn) * neck.n_A;
        const auto path = [&](double x) {
            const double angle = x / 0.035 - 1.2;
            const double depth = 0.0335 + 0.003 * std::sin(200.0 * x);
            EndoscopeMotion m;
            m.p_A = centre + depth * (-std::cos(angle) * neck.t_A + std::sin(angle) * side);
            m.axis_A = neck.t_A;
            m.v_A = Vec3(0.01, 0.02, 0.01);
            return m;
        };
        verifyContinuous(forces, path, 0.090, "bladder");
    }
}

QTEST_APPLESS_MAIN(TestUrethraForcesContinuity)
#include "test_urethra_forces_continuity.moc"
