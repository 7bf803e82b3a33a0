// SPDX-License-Identifier: GPL-3.0-or-later
// Values, symmetries and the agreement with the plain reference.
#include "core/fp_environment.h"
#include "modules/exercises/urethra_insertion/simulation/urethra_forces_sections.h"
#include "modules/exercises/urethra_insertion/simulation/urethra_insertion_parameters.h"
#include "support/urethra_reference_forces.h"
#include "urethra_states.h"

#include <QtTest>
#include <algorithm>

using namespace chiron;
using namespace chiron::simulation;
using namespace chiron::simulation::testing;
using core::Vec3;

namespace {

bool printsAs(double value, double printed, double lastDigit) {
    return std::abs(value - printed) <= 0.5 * lastDigit;
}

double difference(const Vec3& a, const Vec3& b) {
    return (a - b).norm() / (1.0 + b.norm());
}

double difference(double a, double b) {
    return std::abs(a - b) / (1.0 + std::abs(b));
}

/// The largest relative difference (1 N, 1 N·m, 1 J … as the unit where values are small) of any component.
double disagreement(const UrethraResponse& r, const chiron::testing::ReferenceResponse& p) {
    return std::max(
        {difference(r.foot.at.s_m, p.s), difference(r.foot.ex_m, p.ex), difference(r.foot.en_m, p.en),
         difference(r.phiX_rad, p.phiX), difference(r.phiY_rad, p.phiY), difference(r.normal_N, p.N),
         difference(r.friction_N, p.F1), difference(r.viscous_N, p.F2), difference(r.elastic_N, p.elastic),
         difference(r.torqueX_Nm, p.Tx), difference(r.torqueY_Nm, p.Ty), difference(r.torqueZ_Nm, p.Tz),
         difference(r.energy_J, p.U), difference(r.wallDamped_N, p.wall), difference(r.lateral_A, p.lateral),
         difference(r.wrench_A.force, p.force), difference(r.wrench_A.torque, p.torque)});
}

} // namespace

class TestUrethraForces : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { core::setModelFloatingPointEnvironment(); }
    void agreesWithThePlainReference();
    void meetsTheTableOfTheModel();
    void spinMeetsItsClosedForm();
    void mirroredPosesGiveMirroredForces();
    void rotatedSceneChangesNothing();
    void outsideTheBodyIsNothing();
    void aShortFreePartBeginsAtTheEntrance();
    void oddStatesStayFinite();
    void thinEndoscopePlaysFreely();
    void neverPullsInHarderThanFrictionHolds();
    void theShaftPivotsAtThePelvicFloor();
    void stiffnessBoundsEverySlope();
};

void TestUrethraForces::agreesWithThePlainReference() {
    core::Random random(11);
    for (const Variant& v : variants()) {
        const UrethraForces forces(v.anatomy, v.endoscope, v.settings);
        const chiron::testing::UrethraReferenceForces reference(v.anatomy, v.endoscope, v.settings);
        double worst = 0.0;
        for (int n = 0; n < 30000; ++n) {
            const double offset = n % 4 == 1 ? 0.025 : 0.006; // the free part is held only beyond 10 mm
            const auto motion = n % 4 == 0 ? randomInBladder(random, forces)
                                           : randomMotion(random, forces.centreline(), offset);
            worst = std::max(worst, disagreement(forces.respond(motion), reference.respond(motion)));
        }
        QVERIFY2(worst < 1e-9, qPrintable(QString("%1: %2").arg(v.name).arg(worst)));
        QVERIFY2(worst < 1e-12,
                 qPrintable(QString("%1: %2").arg(v.name).arg(worst))); // both kinds of section sums
    }
}

void TestUrethraForces::meetsTheTableOfTheModel() {
    const UrethraForces forces({}, {});
    const UrethraCentreline& line = forces.centreline();
    const double L = line.length_m();
    const UrethraResponse atNeck = forces.respond(motionAt(line, {.s_m = L}));
    QVERIFY2(printsAs(atNeck.normal_N, 10.3, 0.1), qPrintable(QString::number(atNeck.normal_N)));
    EndoscopeMotion fast = motionAt(line, {.s_m = L});
    fast.v_A = 100.0 * fast.axis_A; // far beyond V₀: F1 → μN
    QVERIFY(printsAs(-forces.respond(fast).friction_N, 1.03, 0.01));
    const double expected[3][2] = {{0.001, 0.74}, {0.003, 2.05}, {0.005, 3.56}};
    for (const auto& [offset, force] : expected) {
        const double lateral =
            forces.respond(motionAt(line, {.s_m = 0.100, .ex_m = offset})).lateral_A.norm();
        QVERIFY2(printsAs(lateral, force, 0.01), qPrintable(QString::number(lateral)));
    }
    const double torque = forces.respond(motionAt(line, {.s_m = L, .pitch_rad = core::kPi / 6.0})).torqueX_Nm;
    QVERIFY2(printsAs(torque, 0.105, 0.001), qPrintable(QString::number(torque)));
    QVERIFY(forces.respond(motionAt(line, {.s_m = L, .yaw_rad = core::kPi / 6.0})).torqueY_Nm < -0.104);
    UrethraAnatomy stricture = strictured();
    stricture.changes[0].frictionFactor = 1.0;
    const UrethraForces tight(stricture, {});
    const double total = -tight.respond(fast).friction_N;
    QVERIFY2(std::abs(total - 2.7) < 0.06, qPrintable(QString::number(total)));
}

void TestUrethraForces::spinMeetsItsClosedForm() {
    const UrethraAnatomy anatomy;
    const Endoscope scope;
    const UrethraForces forces(anatomy, scope);
    const double L = forces.centreline().length_m();
    const double squeeze = scope.radius_m - anatomy.radius_m;
    const double N = anatomy.wallStiffness_N_per_m3 * 2.0 * core::kPi * anatomy.radius_m * L * squeeze *
                     (1.0 + anatomy.wallStiffening_per_m * squeeze);
    for (const double spin : {-6.0, -0.5, 0.02, 3.0})
        for (const double speed : {0.0, 0.02}) {
            EndoscopeMotion motion = motionAt(forces.centreline(), {.s_m = L + 0.011});
            motion.w_A = spin * motion.axis_A;
            motion.v_A = speed * motion.axis_A;
            const double around = spin * scope.radius_m;
            const double v0 =
                std::max({0.001, 25e-6 / 0.015, 0.1 * N / UrethraForceSettings{}.maximumDamping_Ns_per_m});
            const double closed = -anatomy.friction * N * scope.radius_m * around /
                                      std::sqrt(around * around + speed * speed + v0 * v0) -
                                  anatomy.viscosity_Ns_per_m2 * L * scope.radius_m * scope.radius_m * spin;
            const UrethraResponse r = forces.respond(motion);
            QVERIFY(std::abs(r.torqueZ_Nm - closed) < 1e-12);
            QVERIFY(std::abs(r.wrench_A.torque.dot(motion.axis_A) - closed) < 1e-12);
        }
}

void TestUrethraForces::mirroredPosesGiveMirroredForces() {
    core::Random random(12);
    const Vec3 mirror(-1.0, 1.0, 1.0);  // x → −x for vectors
    const Vec3 pseudo(1.0, -1.0, -1.0); // and what that does to turns
    for (const Variant& v : variants()) {
        const UrethraForces forces(v.anatomy, v.endoscope, v.settings);
        for (int n = 0; n < 5000; ++n) {
            const auto here =
                n % 4 == 0 ? randomInBladder(random, forces) : randomMotion(random, forces.centreline());
            EndoscopeMotion there;
            there.p_A = here.p_A.cwiseProduct(mirror);
            there.axis_A = here.axis_A.cwiseProduct(mirror);
            there.v_A = here.v_A.cwiseProduct(mirror);
            there.w_A = here.w_A.cwiseProduct(pseudo);
            const UrethraResponse a = forces.respond(here);
            const UrethraResponse b = forces.respond(there);
            QVERIFY((b.wrench_A.force - a.wrench_A.force.cwiseProduct(mirror)).norm() < 1e-13);
            QVERIFY((b.wrench_A.torque - a.wrench_A.torque.cwiseProduct(pseudo)).norm() < 1e-13);
            QVERIFY(a.energy_J == b.energy_J && a.normal_N == b.normal_N);
        }
    }
}

void TestUrethraForces::rotatedSceneChangesNothing() {
    const UrethraForces forces({}, {});
    const AnatomyPose usual;
    AnatomyPose turned;
    const core::Quat turn(Eigen::AngleAxisd(1.1, Vec3(0.3, -0.8, 0.5).normalized()));
    turned.q_WA = turn * usual.q_WA;
    turned.p_WA = turn * usual.p_WA + Vec3(0.2, -0.1, 0.4);
    core::Random random(13);
    for (int n = 0; n < 2000; ++n) {
        const EndoscopeMotion m = randomMotion(random, forces.centreline());
        const auto felt_W = [&](const AnatomyPose& pose, const core::Quat& by, const Vec3& shift) {
            // the tool in W, carried along with the scene, then back into A as the scene would
            const Vec3 p_W = by * usual.pointToW(m.p_A) + shift;
            const auto carried = [&](const Vec3& x_A) { return pose.vectorToA(by * usual.vectorToW(x_A)); };
            const UrethraResponse r =
                forces.respond({pose.pointToA(p_W), carried(m.axis_A), carried(m.v_A), carried(m.w_A)});
            return core::Wrench{pose.vectorToW(r.wrench_A.force), pose.vectorToW(r.wrench_A.torque)};
        };
        const core::Wrench here = felt_W(usual, core::Quat::Identity(), Vec3::Zero());
        const core::Wrench there = felt_W(turned, turn, Vec3(0.2, -0.1, 0.4));
        QVERIFY((there.force - turn * here.force).norm() < 1e-10 * (1.0 + here.force.norm()));
        QVERIFY((there.torque - turn * here.torque).norm() < 1e-10);
    }
}

void TestUrethraForces::outsideTheBodyIsNothing() {
    for (const Variant& v : variants()) {
        const UrethraForces forces(v.anatomy, v.endoscope, v.settings);
        core::Random random(15);
        for (int n = 0; n < 20000; ++n) {
            EndoscopeMotion motion = randomMotion(random, forces.centreline());
            motion.p_A =
                Vec3(random.uniform(-0.2, 0.2), random.uniform(-0.2, 0.2), random.uniform(-0.2, 0.0));
            motion.axis_A = randomVector(random, 1.0).normalized();
            const UrethraResponse r = forces.respond(motion);
            if (r.foot.at.s_m > -v.endoscope.beak_m)
                continue;
            QVERIFY(r.wrench_A.force == Vec3::Zero() && r.wrench_A.torque == Vec3::Zero());
            QVERIFY(r.normal_N == 0.0 && r.friction_N == 0.0 && r.viscous_N == 0.0 && r.elastic_N == 0.0);
            QVERIFY(r.lateral_A == Vec3::Zero() && r.energy_J == 0.0 && r.torqueZ_Nm == 0.0 && !r.touching);
        }
    }
}

// The shortest free part that is allowed, s_B as long as its rounded corner: up to A no torque and no jump,
// beyond it both grow.
void TestUrethraForces::aShortFreePartBeginsAtTheEntrance() {
    UrethraAnatomy anatomy;
    anatomy.freeLength_m = anatomy.freeBlend_m = anatomy.angularCorner_m = 0.005;
    const UrethraForces forces(anatomy, {});
    const Placement tilted{.ex_m = 0.002, .en_m = 0.001, .pitch_rad = 0.5, .yaw_rad = -0.3};
    const auto at = [&](double s_m) {
        Placement here = tilted;
        here.s_m = s_m;
        return forces.respond(motionAt(forces.centreline(), here));
    };
    for (const double s : {-0.050, -0.0101, -0.0099, -0.005, -1e-9})
        QVERIFY2(at(s).wrench_A.torque == Vec3::Zero(), qPrintable(QString::number(s)));
    const double step = 1e-6;
    for (double s = -0.0105; s < 0.012; s += step * 50) {
        const UrethraResponse here = at(s), there = at(s + step);
        QVERIFY2((there.wrench_A.force - here.wrench_A.force).norm() < 0.002, qPrintable(QString::number(s)));
        QVERIFY2((there.wrench_A.torque - here.wrench_A.torque).norm() < 1e-4,
                 qPrintable(QString::number(s)));
    }
    QVERIFY(at(0.010).wrench_A.torque.norm() > 1e-3);
    UrethraAnatomy impossible =
        anatomy; // refused by content; even so there is nothing to feel before the beak is in
    impossible.angularCorner_m = 0.030;
    const UrethraForces wrong(impossible, {});
    QVERIFY(wrong.respond(motionAt(wrong.centreline(), {.s_m = -0.011, .pitch_rad = 0.5})).wrench_A.torque ==
            Vec3::Zero());
}

void TestUrethraForces::oddStatesStayFinite() {
    core::Random random(16);
    for (const Variant& v : variants()) {
        const UrethraForces forces(v.anatomy, v.endoscope, v.settings);
        for (int n = 0; n < 50000; ++n) {
            EndoscopeMotion motion;
            motion.p_A = randomVector(random, n % 2 == 0 ? 0.3 : 50.0);
            motion.axis_A = n % 10 == 0 ? Vec3(Vec3::UnitX()) : randomVector(random, 1.0).normalized();
            motion.v_A = randomVector(random, 100.0);
            motion.w_A = randomVector(random, 1000.0);
            const UrethraResponse r = forces.respond(motion);
            QVERIFY(r.wrench_A.force.allFinite() && r.wrench_A.torque.allFinite() && r.lateral_A.allFinite());
            QVERIFY(
                std::isfinite(r.energy_J + r.normal_N + r.elastic_N + r.stiffness_N_per_m + r.torqueZ_Nm));
        }
    }
}

void TestUrethraForces::thinEndoscopePlaysFreely() {
    const UrethraForces forces({}, thin());
    const double s = 0.100;
    for (const double offset : {0.0, 0.0002, 0.0004999}) { // 2.5 − 2.0 mm of play
        const UrethraResponse r = forces.respond(motionAt(forces.centreline(), {.s_m = s, .en_m = offset}));
        QVERIFY(r.normal_N == 0.0 && r.lateral_A == Vec3::Zero());
    }
    const UrethraResponse r = forces.respond(motionAt(forces.centreline(), {.s_m = s, .en_m = 0.002}));
    QVERIFY(r.normal_N > 0.0 && r.lateral_A.dot(r.foot.at.n_A) < -0.01);
}

void TestUrethraForces::neverPullsInHarderThanFrictionHolds() {
    for (const Variant& v : variants()) {
        if (v.settings.sections == ForceSections::p1Basic)
            continue; // a grid so coarse that springs 4 mm apart pull the tip from one to the next
        const UrethraForces forces(v.anatomy, v.endoscope, v.settings);
        core::Random random(17);
        const double L = forces.centreline().length_m();
        for (int n = 0; n < 20000; ++n) {
            const double s = random.uniform(-0.012, L + 0.04);
            const UrethraResponse centred = forces.respond(motionAt(forces.centreline(), {.s_m = s}));
            QVERIFY2(centred.elastic_N < 1e-9, qPrintable(QString("%1 at %2").arg(centred.elastic_N).arg(s)));
            if (v.endoscope.radius_m < v.anatomy.radius_m)
                continue; // a thin endoscope may be squeezed nowhere
            // in the stricture springs 15 times as stiff win beyond 5 mm, and so does a shaft that the pelvic
            // floor turns in
            const double offset = v.anatomy.changeCount > 0     ? 0.0035
                                  : v.anatomy.pivotSpan_m > 0.0 ? 0.005
                                                                : 0.006;
            const UrethraResponse r = forces.respond(randomMotion(random, forces.centreline(), offset));
            const double held = v.anatomy.friction * r.normal_N; // at least
            QVERIFY2(r.elastic_N < held + 1e-9, qPrintable(QString("%1, %2 N").arg(r.elastic_N).arg(held)));
        }
    }
}

// A tip that is aside has tilted the shaft about the floor: that costs no torque. On the line a tilt costs
// P1's torque, and force across.
void TestUrethraForces::theShaftPivotsAtThePelvicFloor() {
    UrethraAnatomy free = bentAtB();
    free.pivotSpan_m = 0.0;
    const UrethraForces held(bentAtB(), {}), loose(free, {});
    for (const double s : {0.060, 0.090, 0.120}) {
        const double lever = s - 0.040, turn = lever / (lever * lever + 0.020 * 0.020); // s_B, ℓ₀
        const UrethraResponse aside = held.respond(motionAt(
            held.centreline(),
            {.s_m = s, .ex_m = 0.002, .en_m = -0.003, .pitch_rad = -0.003 * turn, .yaw_rad = 0.002 * turn}));
        QVERIFY2(std::abs(aside.torqueX_Nm) < 1e-12 && std::abs(aside.torqueY_Nm) < 1e-12,
                 qPrintable(QString::number(aside.torqueX_Nm)));
        const UrethraResponse upright =
            held.respond(motionAt(held.centreline(), {.s_m = s, .ex_m = 0.002, .en_m = -0.003}));
        QVERIFY(upright.torqueX_Nm > 1e-4 && upright.torqueY_Nm > 1e-4 && upright.energy_J > aside.energy_J);
        const Placement tilted{.s_m = s, .pitch_rad = 0.3};
        const UrethraResponse with = held.respond(motionAt(held.centreline(), tilted)),
                              without = loose.respond(motionAt(loose.centreline(), tilted));
        QVERIFY(with.torqueX_Nm == without.torqueX_Nm && with.torqueX_Nm > 0.0);
        QVERIFY(without.lateral_A == Vec3::Zero() &&
                std::abs(with.lateral_A.dot(with.foot.at.n_A) - with.torqueX_Nm * turn) < 1e-12);
    }
}

// In whatever direction the tip moves. The bound is no looser than it has to be: within 1.2 of the steepest
// place across, where the wall's springs alone say it, and within 1.7 of the steepest place in any direction.
void TestUrethraForces::stiffnessBoundsEverySlope() {
    core::Random random(18);
    for (const Variant& v : variants()) {
        const UrethraForces forces(v.anatomy, v.endoscope, v.settings);
        const UrethraForces::Tables tables(forces.centreline(), forces.wall(), v.settings);
        double most = 0.0, mostAcross = 0.0, steepest = 0.0, across = 0.0;
        for (int n = 0; n < 40000; ++n) {
            const bool wall = n % 4 == 0, lateral = n / 4 % 2 == 1;
            EndoscopeMotion motion =
                wall ? randomInBladder(random, forces) : randomMotion(random, forces.centreline(), 0.0035);
            motion.v_A.setZero();
            const UrethraResponse here = forces.respond(motion);
            const double turn = random.uniform(0.0, 2.0 * core::kPi);
            Vec3 way = std::cos(turn) * Vec3::UnitX() + std::sin(turn) * here.foot.at.n_A;
            if (!lateral)
                way = randomVector(random, 1.0).normalized();
            const double step = 1e-7;
            EndoscopeMotion moved = motion;
            moved.p_A += step * way;
            const UrethraResponse there = forces.respond(moved);
            const double slope = (there.wrench_A.force - here.wrench_A.force).norm() / step;
            const double bound = std::max(here.stiffness_N_per_m, there.stiffness_N_per_m);
            QVERIFY2(slope <= bound * 1.0001 + 0.01,
                     qPrintable(QString("%1: %2 > %3").arg(v.name).arg(slope).arg(bound)));
            if (here.bladder_A == Vec3::Zero() && there.bladder_A == Vec3::Zero()) {
                most = std::max(most, here.stiffness_N_per_m);
                mostAcross = std::max(
                    mostAcross, sumUrethraSections(tables, here.foot.at.s_m, here.foot.ex_m, here.foot.en_m)
                                    .stiffness_N_per_m);
                steepest = std::max(steepest, slope);
                if (lateral)
                    across = std::max(across, (there.lateral_A - here.lateral_A).norm() / step);
            }
        }
        if (QString(v.name) == "normal") {
            QVERIFY2(across <= 1120.0 && mostAcross < 1.2 * across,
                     qPrintable(QString("%1, %2").arg(across).arg(mostAcross)));
            QVERIFY2(most < 1.7 * steepest, qPrintable(QString("%1, %2").arg(steepest).arg(most)));
        }
    }
}

QTEST_APPLESS_MAIN(TestUrethraForces)
#include "test_urethra_forces.moc"
