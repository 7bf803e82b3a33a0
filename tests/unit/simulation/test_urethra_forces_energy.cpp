// SPDX-License-Identifier: GPL-3.0-or-later
// One potential, and dissipation.
#include "core/fp_environment.h"
#include "support/sanitized.h"
#include "urethra_states.h"

#include <QtTest>
#include <algorithm>

using namespace chiron;
using namespace chiron::simulation;
using namespace chiron::simulation::testing;
using core::Vec3;

namespace {

constexpr double kLoopTolerance_J = 1e-6; // models.md §0: every loop and its reverse ≥ −1 µJ

/// A smooth closed path in position and orientation: place ± reach·Σ of three harmonics in each of its five
/// numbers.
struct Loop {
    Placement place;
    Placement reach;
    std::array<std::array<double, 3>, 5> amplitude{}, phase{};

    Loop(core::Random& random, const Placement& centre, const Placement& width)
        : place(centre), reach(width) {
        for (std::size_t k = 0; k < 5; ++k)
            for (std::size_t h = 0; h < 3; ++h) {
                amplitude[k][h] = random.uniform(-1.0, 1.0) / 3.0;
                phase[k][h] = random.uniform(0.0, 2.0 * core::kPi);
            }
    }
    double wave(std::size_t k, double x) const {
        double sum = 0.0;
        for (std::size_t h = 0; h < 3; ++h)
            sum += amplitude[k][h] * std::sin(2.0 * core::kPi * static_cast<double>(h + 1) * x + phase[k][h]);
        return sum;
    }
    EndoscopeMotion at(const UrethraCentreline& line, double x) const {
        return motionAt(line,
                        {place.s_m + reach.s_m * wave(0, x), place.ex_m + reach.ex_m * wave(1, x),
                         place.en_m + reach.en_m * wave(2, x), place.pitch_rad + reach.pitch_rad * wave(3, x),
                         place.yaw_rad + reach.yaw_rad * wave(4, x)});
    }
};

struct Work {
    double net_J = 0.0;       ///< what the hand puts in
    double exchanged_J = 0.0; ///< Σ of the magnitudes
};

/// −∮ f·dp + τ·dθ by the trapezoid rule, at rest (elastic terms alone). `lateralOnly`: without the parts
/// along t, to show that the loops can tell.
Work workOf(const UrethraForces& forces, const Loop& loop, int steps, bool reversed,
            bool lateralOnly = false) {
    const auto respond = [&](int i) {
        const double x = static_cast<double>(i % steps) / steps;
        const EndoscopeMotion m = loop.at(forces.centreline(), reversed ? 1.0 - x : x);
        return std::pair(m, forces.respond(m));
    };
    const auto forceOf = [&](const UrethraResponse& r) {
        return lateralOnly ? r.lateral_A : r.wrench_A.force;
    };
    Work work;
    auto [before, felt] = respond(0);
    for (int i = 1; i <= steps; ++i) {
        const auto [now, feels] = respond(i);
        const Vec3 turned = before.axis_A.cross(now.axis_A);
        const double piece = -0.5 * (forceOf(felt) + forceOf(feels)).dot(now.p_A - before.p_A) -
                             0.5 * (felt.wrench_A.torque + feels.wrench_A.torque).dot(turned);
        work.net_J += piece;
        work.exchanged_J += std::abs(piece);
        before = now;
        felt = feels;
    }
    return work;
}

} // namespace

class TestUrethraForcesEnergy : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { core::setModelFloatingPointEnvironment(); }
    void wrenchIsMinusGradientOfEnergy();
    void loopsMakeNoEnergy_data();
    void loopsMakeNoEnergy();
    void restHasNoFriction();
    void frictionAndViscosityNeverDoWork();
};

void TestUrethraForcesEnergy::wrenchIsMinusGradientOfEnergy() {
    core::Random random(21);
    const double h =
        1e-8; // m: a spring that goes slack within it bends −∂U by at most ½k h, 0.3 µN in the stricture
    const double turn = 1e-6; // rad
    for (const Variant& v : variants()) {
        const UrethraForces forces(v.anatomy, v.endoscope, v.settings);
        const auto energy = [&](const EndoscopeMotion& m) { return forces.respond(m).energy_J; };
        for (int n = 0; n < support::repeated(20000, 2000); ++n) {
            EndoscopeMotion motion =
                n % 4 == 0 ? randomInBladder(random, forces) : randomMotion(random, forces.centreline());
            motion.v_A.setZero();
            motion.w_A.setZero();
            const UrethraResponse here = forces.respond(motion);
            Vec3 force, torque;
            for (int axis = 0; axis < 3; ++axis) {
                EndoscopeMotion up = motion, down = motion;
                up.p_A[axis] += h;
                down.p_A[axis] -= h;
                force[axis] = -(energy(up) - energy(down)) / (2.0 * h);
                up = down = motion;
                up.axis_A = Eigen::AngleAxisd(turn, Vec3::Unit(axis)) * motion.axis_A;
                down.axis_A = Eigen::AngleAxisd(-turn, Vec3::Unit(axis)) * motion.axis_A;
                torque[axis] = -(energy(up) - energy(down)) / (2.0 * turn);
            }
            const double wrong = (force - here.wrench_A.force).norm() / (1.0 + here.wrench_A.force.norm());
            QVERIFY2(wrong < 1e-6,
                     qPrintable(QString("%1 %2 at s = %3").arg(v.name).arg(wrong).arg(here.foot.at.s_m)));
            QVERIFY((torque - here.wrench_A.torque).norm() < 1e-6 * here.wrench_A.torque.norm() + 1e-9);
        }
    }
}

void TestUrethraForcesEnergy::loopsMakeNoEnergy_data() {
    QTest::addColumn<QList<double>>("reach");
    QTest::newRow("lateral") << QList<double>{0.0, 0.005, 0.005, 0.0, 0.0};
    QTest::newRow("tilt") << QList<double>{0.0, 0.0, 0.0, 0.5, 0.5};
    QTest::newRow("axial") << QList<double>{0.020, 0.0, 0.0, 0.0, 0.0};
    QTest::newRow("axial and lateral") << QList<double>{0.010, 0.005, 0.005, 0.0, 0.0};
    QTest::newRow("axial and tilt") << QList<double>{0.010, 0.0, 0.0, 0.5, 0.5};
    QTest::newRow("everything") << QList<double>{0.015, 0.006, 0.006, 0.5, 0.5};
}

void TestUrethraForcesEnergy::loopsMakeNoEnergy() {
    QFETCH(QList<double>, reach);
    core::Random random(22);
    for (const Variant& v : variants()) {
        const UrethraForces forces(v.anatomy, v.endoscope, v.settings);
        double exchanged = 0.0, coarse = 0.0, fine = 0.0, without = 0.0;
        for (int n = 0; n < 12; ++n) {
            const Placement centre{random.uniform(-0.005, forces.centreline().length_m() + 0.03),
                                   random.uniform(-0.002, 0.002), random.uniform(-0.002, 0.002), 0.1, 0.1};
            const Loop loop(random, centre, {reach[0], reach[1], reach[2], reach[3], reach[4]});
            for (const bool reversed : {false, true}) {
                const Work rough = workOf(forces, loop, 1000, reversed);
                const Work work = workOf(forces, loop, 4000, reversed);
                QVERIFY2(
                    work.net_J >= -kLoopTolerance_J,
                    qPrintable(QString("%1: %2 of %3 J").arg(v.name).arg(work.net_J).arg(work.exchanged_J)));
                exchanged = std::max(exchanged, work.exchanged_J);
                coarse += std::abs(rough.net_J);
                fine += std::abs(work.net_J);
                without = std::min(without, workOf(forces, loop, 4000, reversed, true).net_J);
            }
        }
        // what is left over is the rule's error: it falls with the square of the step
        QVERIFY2(fine < 0.25 * coarse + 1e-12,
                 qPrintable(QString("%1: %2, %3").arg(v.name).arg(coarse).arg(fine)));
        if (reach[1] > 0.0)
            QVERIFY2(exchanged > 1e-3, qPrintable(QString::number(exchanged)));
        if (reach[0] > 0.0 && reach[1] > 0.0)
            QVERIFY2(without < -100.0 * kLoopTolerance_J, qPrintable(QString::number(without)));
    }
}

void TestUrethraForcesEnergy::restHasNoFriction() {
    core::Random random(23);
    UrethraAnatomy anatomy = strictured();
    anatomy.wallRetardation_s = 0.005;
    const UrethraForces forces(anatomy, {});
    for (int n = 0; n < 5000; ++n) {
        EndoscopeMotion motion = randomMotion(random, forces.centreline());
        motion.v_A.setZero();
        motion.w_A.setZero();
        const UrethraResponse r = forces.respond(motion);
        QVERIFY(r.friction_N == 0.0 && r.viscous_N == 0.0 && r.wallDamped_N == 0.0 && r.torqueZ_Nm == 0.0);
    }
}

void TestUrethraForcesEnergy::frictionAndViscosityNeverDoWork() {
    core::Random random(24);
    UrethraAnatomy anatomy = strictured();
    anatomy.wallRetardation_s = 0.005;
    const UrethraForces forces(anatomy, {});
    const double dt = 0.001;
    double absorbed = 0.0, byTheWall = 0.0;
    EndoscopeMotion motion = randomMotion(random, forces.centreline());
    for (int n = 0; n < 1'000'000; ++n) {
        if (n % 100 == 0)
            motion = randomMotion(random, forces.centreline());
        const Vec3 v = randomVector(random, 0.2), w = randomVector(random, 5.0);
        motion.v_A = v;
        motion.w_A = w;
        motion.p_A += dt * v * 0.1; // wanders within the hundred steps
        const UrethraResponse r = forces.respond(motion);
        const double along = v.dot(motion.axis_A), spin = w.dot(motion.axis_A);
        QVERIFY(r.friction_N * along <= 0.0 && r.viscous_N * along <= 0.0 && r.torqueZ_Nm * spin <= 0.0);
        const Vec3 damped_A = r.wrench_A.force - r.lateral_A -
                              r.elastic_N / r.foot.gradientOfS_A.dot(r.foot.at.t_A) * r.foot.gradientOfS_A -
                              (r.friction_N + r.viscous_N) * motion.axis_A;
        const Vec3 across = v - along * motion.axis_A;
        QVERIFY((damped_A * across.norm() + r.wallDamped_N * across).norm() <=
                1e-9); // straight against what is left of the motion
        byTheWall += r.wallDamped_N * across.norm() * dt;
        absorbed -= (r.friction_N + r.viscous_N) * along * dt + r.torqueZ_Nm * spin * dt;
    }
    QVERIFY2(absorbed > 10.0, qPrintable(QString::number(absorbed)));
    QVERIFY2(byTheWall > 10.0, qPrintable(QString::number(byTheWall)));
}

QTEST_APPLESS_MAIN(TestUrethraForcesEnergy)
#include "test_urethra_forces_energy.moc"
