// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact_loops.h"
#include "simulation/objects/object_contact.h"

#include <QtTest>
#include <algorithm>
#include <cmath>
#include <vector>

using namespace chiron;
using namespace chiron::simulation;
using core::Vec3;

namespace {

constexpr double kRadius = 0.020;

ContactPlace onPlane(const Vec3& p) {
    ContactPlace place;
    place.depth_m = -p.z();
    place.foot = Vec3(p.x(), p.y(), 0.0);
    place.position = p;
    return place;
}

ContactPlace onSphere(const Vec3& p) {
    ContactPlace place;
    const double r = p.norm();
    place.normal = p / r;
    place.depthGradient = -place.normal;
    place.depth_m = kRadius - r;
    place.foot = kRadius * place.normal;
    place.footScale = kRadius / r;
    place.position = p;
    return place;
}

ObjectAttributes conservative() {
    ObjectAttributes a;
    a.stiffness_N_per_m = 600.0;
    a.stiffening_per_m = 60.0;
    a.roughness_m = 60e-6;
    a.roughnessWavelength_m = 0.003;
    a.damping_Ns_per_m = 0.0;
    return a;
}

ObjectAttributes everything() {
    ObjectAttributes a = conservative();
    a.mass_kg = 0.010;
    a.recoveryTime_s = 0.2;
    a.recoveryShare = 0.5;
    a.friction = 0.3;
    a.viscosity_Ns_per_m = 2.0;
    a.damping_Ns_per_m = 2.0;
    return a;
}

Vec3 force(const ObjectContact& contact, const ContactPlace& place) {
    ObjectContactState fresh;
    return contact.respond(place, core::kTickSeconds, fresh).force;
}

/// Least work of a loop and of its reverse.
template <class Place>
double leastWork(const ObjectContact& contact, const std::vector<Vec3>& path, Place where) {
    const testing::Force law = [&](const Vec3& p) { return force(contact, where(p)); };
    const double work = testing::workIn(path, law);
    return std::min(work, -work);
}

} // namespace

class TestObjectContact : public QObject {
    Q_OBJECT
private slots:
    void pressIsTheElasticLaw();
    void forceIsMinusTheGradient();
    void loopsMakeNoEnergyOnAPlane();
    void loopsMakeNoEnergyOnASphere();
    void withoutTheLateralPartLoopsDo();
    void dissipativePartsOnlyTake();
    void frictionStaysBelowMuN();
    void neverPulls();
    void nothingStepsAtFirstContact();
    void slowSurfaceIsNotFeltUntilItIsBack();
    void leavingForgetsTheBristle();
    void roughnessReachesAboveTheSurface();
    void attributesReachTheLaw();
};

void TestObjectContact::pressIsTheElasticLaw() {
    ObjectAttributes a;
    a.stiffness_N_per_m = 300.0;
    a.stiffening_per_m = 60.0;
    const ObjectContact contact(a);
    ObjectContactState state;
    for (const double depth_m : {0.004, kCheckedContactDepth_m}) {
        const auto out = contact.respond(onPlane({0.01, 0.02, -depth_m}), core::kTickSeconds, state);
        QVERIFY((out.force - Vec3(0, 0, elasticOf(a).tension(depth_m))).norm() < 1e-12);
        QCOMPARE(out.energy_J, elasticOf(a).energy(depth_m));
        QCOMPARE(out.depth_m, depth_m);
        QVERIFY(out.inContact && out.normalForce_N > 0.0);
    }
    const auto away = contact.respond(onPlane({0.01, 0.02, 0.004}), core::kTickSeconds, state);
    QVERIFY(!away.inContact && away.force.norm() == 0.0 && away.energy_J == 0.0 &&
            away.stiffness_N_per_m == 0.0);
}

void TestObjectContact::forceIsMinusTheGradient() {
    const ObjectContact contact(conservative());
    core::Random random(1);
    const auto energy = [&](const ContactPlace& place) {
        ObjectContactState fresh;
        return contact.respond(place, core::kTickSeconds, fresh).energy_J;
    };
    const double e = 1e-7;
    for (int n = 0; n < 4000; ++n) {
        const bool sphere = n % 2 == 1;
        Vec3 p(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
        p = sphere ? Vec3(p.normalized() * (kRadius - random.uniform(0.0005, kCheckedContactDepth_m)))
                   : Vec3(0.03 * p.x(), 0.03 * p.y(), -random.uniform(0.0005, kCheckedContactDepth_m));
        const auto place = [&](const Vec3& at) { return sphere ? onSphere(at) : onPlane(at); };
        Vec3 gradient;
        for (int axis = 0; axis < 3; ++axis) {
            const Vec3 step = e * Vec3::Unit(axis);
            gradient[axis] = (energy(place(p + step)) - energy(place(p - step))) / (2 * e);
        }
        QVERIFY2((force(contact, place(p)) + gradient).norm() < 1e-5,
                 qPrintable(QString::number((force(contact, place(p)) + gradient).norm())));
    }
}

// 10⁴ random closed paths and their reverses, half of them mostly inside, half in and out.
void TestObjectContact::loopsMakeNoEnergyOnAPlane() {
    core::Random random(2);
    const ObjectContact contact(conservative());
    double least = 0.0;
    for (int n = 0; n < 5000; ++n) {
        const Vec3 centre(random.uniform(-0.03, 0.03), random.uniform(-0.03, 0.03),
                          n % 2 == 0 ? -0.0015 : 0.0);
        least = std::min(least, leastWork(contact, testing::randomLoop(random, centre, 0.002, 500), onPlane));
    }
    QVERIFY2(least >= -1e-6, qPrintable(QString::number(least)));
}

void TestObjectContact::loopsMakeNoEnergyOnASphere() {
    core::Random random(3);
    const ObjectContact contact(conservative());
    double least = 0.0;
    for (int n = 0; n < 5000; ++n) {
        const Vec3 outward =
            Vec3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(0.1, 1)).normalized();
        const Vec3 centre = outward * (kRadius - (n % 2 == 0 ? 0.0015 : 0.0));
        least =
            std::min(least, leastWork(contact, testing::randomLoop(random, centre, 0.002, 500), onSphere));
    }
    QVERIFY2(least >= -1e-6, qPrintable(QString::number(least)));
}

// What P2's plain "noise on the force" does, and why the lateral part is there: pressed in on one flank of
// the micro-height and out on the other, a loop without it makes energy, one way round or the other.
void TestObjectContact::withoutTheLateralPartLoopsDo() {
    core::Random random(4);
    const ObjectContact contact(conservative());
    double least = 0.0;
    for (int n = 0; n < 200; ++n) {
        const Vec3 centre(random.uniform(-0.03, 0.03), random.uniform(-0.03, 0.03), -0.002);
        const auto path = testing::randomLoop(random, centre, 0.002, 500);
        const double work = testing::workIn(path, [&](const Vec3& p) {
            const Vec3 f = force(contact, onPlane(p));
            return Vec3(0.0, 0.0, f.z());
        });
        least = std::min({least, work, -work});
    }
    QVERIFY2(least < -20e-6, qPrintable(QString::number(least)));
}

// With everything on, what the hand puts in over any path is at least what is stored: here the real path,
// tick by tick, with the force answered to each step.
void TestObjectContact::dissipativePartsOnlyTake() {
    core::Random random(5);
    double made = 0.0;
    double lost = 0.0;
    for (int n = 0; n < 300; ++n) {
        ObjectAttributes a = everything();
        a.roughness_m = 0.0; // conservative in the small-step limit only, and these steps are as a hand's
        const ObjectContact contact(a);
        const Vec3 centre(random.uniform(-0.03, 0.03), random.uniform(-0.03, 0.03), -0.001);
        const auto path = testing::randomLoop(random, centre, 0.003, 1000); // a second
        ObjectContactState state;
        double work = 0.0;
        double energy = 0.0;
        double held = 0.0;
        for (std::size_t i = 1; i < path.size(); ++i) {
            ContactPlace place = onPlane(path[i]);
            place.velocity = (path[i] - path[i - 1]) / core::kTickSeconds;
            const auto out = contact.respond(place, core::kTickSeconds, state);
            if (i > 1) // the first tick only begins
                work -= out.force.dot(path[i] - path[i - 1]);
            energy = out.energy_J;
            held = 0.5 * a.bristleStiffness_N_per_m * state.bristle.stretch().squaredNorm();
        }
        // a path that begins inside starts with what it stores there
        ObjectContactState fresh;
        const double before = contact.respond(onPlane(path[1]), core::kTickSeconds, fresh).energy_J;
        made = std::min(made, work + before - energy - held);
        lost += work + before - energy;
    }
    QVERIFY2(made >= -1e-6, qPrintable(QString::number(made)));
    QVERIFY2(lost > 0.05, qPrintable(QString::number(lost)));
}

void TestObjectContact::frictionStaysBelowMuN() {
    core::Random random(6);
    const ObjectContact contact(everything());
    for (int run = 0; run < 200; ++run) {
        ObjectContactState state;
        Vec3 p(0.0, 0.0, -0.001);
        for (int n = 0; n < 1000; ++n) {
            const Vec3 step =
                4e-4 * Vec3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
            p += step;
            p.z() = std::clamp(p.z(), -0.005, 0.001);
            ContactPlace place = run % 2 == 0 ? onPlane(p) : onSphere(p + Vec3(0, 0, kRadius));
            place.velocity = step / core::kTickSeconds;
            const auto out = contact.respond(place, core::kTickSeconds, state);
            QVERIFY(out.friction.norm() <= 0.3 * out.normalForce_N * (1 + 1e-12) + 1e-15);
            QVERIFY(std::abs(out.friction.dot(out.normal)) < 1e-12);
            QVERIFY((out.force - out.normalForce_N * out.normal - out.friction - out.viscous).norm() < 1e-12);
            QVERIFY(out.viscous.dot(place.velocity) <= 1e-15);
        }
    }
}

void TestObjectContact::neverPulls() {
    core::Random random(7);
    const ObjectContact contact(everything());
    ObjectContactState state;
    for (int n = 0; n < 100000; ++n) {
        ContactPlace place = onPlane(
            {random.uniform(-0.05, 0.05), random.uniform(-0.05, 0.05), random.uniform(-0.006, 0.003)});
        place.velocity = 0.5 * Vec3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
        const auto out = contact.respond(place, core::kTickSeconds, state);
        QVERIFY(out.normalForce_N >= 0.0 && out.force.dot(out.normal) >= -1e-12);
        QVERIFY(std::abs(out.normal.norm() - 1.0) < 1e-12);
    }
}

void TestObjectContact::nothingStepsAtFirstContact() {
    const ObjectContact contact(everything());
    ObjectContactState state;
    double before = 0.0;
    for (double z = 0.0005; z > -0.002; z -= 1e-6) { // sinking at 1 m/s, sliding at 0.5
        ContactPlace place = onPlane({0.01, 0.02, z});
        place.velocity = Vec3(0.5, 0.0, -1.0);
        const double now = contact.respond(place, 1e-6, state).force.norm();
        QVERIFY2(std::abs(now - before) < 0.02, qPrintable(QString("%1 %2").arg(z).arg(now - before)));
        before = now;
    }
    QVERIFY(before > 1.0);
}

void TestObjectContact::slowSurfaceIsNotFeltUntilItIsBack() {
    ObjectAttributes a = everything();
    a.roughness_m = 0.0;
    const ObjectContact contact(a);
    ObjectContactState state;
    for (int n = 0; n < 3000; ++n)
        contact.respond(onPlane({0, 0, -0.005}), core::kTickSeconds, state);
    const auto left = contact.respond(onPlane({0, 0, 0.001}), core::kTickSeconds, state);
    QVERIFY(left.force.norm() == 0.0 && left.surface_m > 0.001 && left.energy_J > 0.0);
    ObjectContactState copy = state;
    ContactPlace shallow = onPlane({0, 0, -0.5 * left.surface_m});
    shallow.velocity = Vec3(0.1, 0.0, -0.1);
    const auto nothing = contact.respond(shallow, core::kTickSeconds, copy);
    QVERIFY(nothing.force.norm() == 0.0); // neither pushed nor rubbed nor dragged by what is not there
    for (int n = 0; n < 3000; ++n)
        contact.respond(onPlane({0, 0, 0.001}), core::kTickSeconds, state);
    QVERIFY(contact.respond(shallow, core::kTickSeconds, state).force.z() > 0.0);
}

void TestObjectContact::leavingForgetsTheBristle() {
    ObjectAttributes a;
    a.friction = 0.5;
    const ObjectContact contact(a);
    ObjectContactState state;
    contact.respond(onPlane({0, 0, -0.002}), core::kTickSeconds, state);
    QVERIFY(contact.respond(onPlane({1e-4, 0, -0.002}), core::kTickSeconds, state).friction.x() < -0.09);
    contact.respond(onPlane({1e-4, 0, 0.002}), core::kTickSeconds, state);
    QCOMPARE(contact.respond(onPlane({0.05, 0, -0.002}), core::kTickSeconds, state).friction.norm(), 0.0);
}

// A hill is met before the rest surface is, a valley after it.
void TestObjectContact::roughnessReachesAboveTheSurface() {
    const ObjectContact contact(conservative());
    core::Random random(8);
    int hills = 0;
    for (int n = 0; n < 2000; ++n) {
        ObjectContactState state;
        const double x = random.uniform(-0.05, 0.05);
        const double h = contact.roughness().sample({x, 0, 0}).height_m;
        const auto out = contact.respond(onPlane({x, 0, 20e-6}), core::kTickSeconds, state);
        QCOMPARE(out.inContact, h > 20e-6);
        hills += out.inContact ? 1 : 0;
        QVERIFY(!contact.respond(onPlane({x, 0, contact.reach_m()}), core::kTickSeconds, state).inContact);
    }
    QVERIFY(hills > 500 && hills < 1000); // P(N(0,1) > 1/3) = 37 %
}

void TestObjectContact::attributesReachTheLaw() {
    const auto answer = [](const ObjectAttributes& a) {
        const ObjectContact contact(a);
        ObjectContactState state;
        contact.respond(onPlane({0.0, 0.0, -0.002}), core::kTickSeconds, state);
        ContactPlace place = onPlane({0.0002, 0.0, -0.003});
        place.velocity = Vec3(0.05, 0.0, -0.05);
        return contact.respond(place, core::kTickSeconds, state).force;
    };
    const Vec3 plain = answer(ObjectAttributes{});
    const auto changed = [&](auto change) {
        ObjectAttributes a;
        change(a);
        return (answer(a) - plain).norm() > 1e-6;
    };
    QVERIFY(changed([](auto& a) { a.stiffness_N_per_m = 400; }));
    QVERIFY(changed([](auto& a) { a.stiffening_per_m = 50; }));
    QVERIFY(changed([](auto& a) {
        a.recoveryTime_s = 0.2;
        a.recoveryShare = 0.5;
    }));
    QVERIFY(changed([](auto& a) { a.roughness_m = 2e-5; }));
    QVERIFY(changed([](auto& a) { a.friction = 0.2; }));
    QVERIFY(changed([](auto& a) { a.viscosity_Ns_per_m = 1; }));
    QVERIFY(changed([](auto& a) { a.damping_Ns_per_m = 3; }));
    QVERIFY2(!changed([](auto& a) { a.mass_kg = 1; }), "weight acts while it is lifted, not on a touch");
}

QTEST_APPLESS_MAIN(TestObjectContact)
#include "test_object_contact.moc"
