// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact_laws.h"
#include "core/fp_environment.h"

#include <QtTest>
#include <algorithm>
#include <bit>
#include <cmath>

using namespace chiron;
using namespace chiron::simulation;
using namespace chiron::simulation::testing;
using core::Vec3;

namespace {

/// The law that models.md §2.3 rejects: of plane and ball, the one entered deeper answers.
Vec3 deeperContactWins(const HemisphereContact::Parameters& law, const Vec3& p) {
    const Vec3 fromCentre =
        p - Vec3(law.surface.centre_m.x(), law.surface.centre_m.y(), law.surface.planeHeight_m);
    const double plane = -fromCentre.z();
    const double ball = law.surface.radius_m - fromCentre.norm();
    const double depth = std::max(plane, ball);
    if (depth <= 0.0)
        return Vec3::Zero();
    const Vec3 normal = plane > ball ? Vec3(Vec3::UnitZ()) : Vec3(fromCentre.normalized());
    return law.stiffness.base_N_per_m * depth * normal;
}

} // namespace

class TestHemisphereContact : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { core::setModelFloatingPointEnvironment(); }
    void closedFormsOnPlaneAndApex();
    void zeroDepthZeroForce();
    void dampingVanishesAtRestAndAtFirstContact();
    void frictionDragsAtMuN();
    void dimpleLowersTheSurface();
    void neverPulls();
    void forceIsContinuous_data();
    void forceIsContinuous();
    void rejectedLawJumpsAtTheRim();
    void mirrorsAndTurns();
    void sameInputsSameBits();
    void proxyLiesOnTheSurface();
};

void TestHemisphereContact::closedFormsOnPlaneAndApex() {
    const auto law = plainParameters();
    const HemisphereContact contact(law);
    const core::Vec2 c = law.surface.centre_m;
    const auto flat = contact.respond({c.x() + 0.030, c.y() + 0.010, -0.002}, Vec3::Zero());
    QVERIFY((flat.force - Vec3(0, 0, 1.0)).norm() < 1e-12); // 500 N/m · 2 mm
    QVERIFY(std::abs(flat.energy_J - 0.001) < 1e-15);       // ½ · 500 · (2 mm)²
    const auto apex = contact.respond({c.x(), c.y(), 0.017}, Vec3::Zero());
    QVERIFY((apex.force - Vec3(0, 0, 1.5)).norm() < 1e-12);
    QCOMPARE(apex.stiffness_N_per_m, 500.0);
    // 45° up the flank, 1 mm deep
    const double s = 0.019 * std::sqrt(0.5);
    const auto flank = contact.respond({c.x() + s, c.y(), s}, Vec3::Zero());
    QVERIFY((flank.force - 0.5 * Vec3(std::sqrt(0.5), 0, std::sqrt(0.5))).norm() < 1e-12);
    // damper at full depth: 2 mm deep, leaving at 0.1 m/s: 1.0 − 2·0.1
    auto damped = law;
    damped.damping_Ns_per_m = 2.0;
    const auto leaving = HemisphereContact(damped).respond({c.x() + 0.030, c.y(), -0.002}, {0.3, 0.0, 0.1});
    QVERIFY((leaving.force - Vec3(0, 0, 0.8)).norm() < 1e-12);
    // at half the weighting depth, half the damper: 0.125 + ½·2·0.1
    const auto entering =
        HemisphereContact(damped).respond({c.x() + 0.030, c.y(), -0.00025}, {0.0, 0.0, -0.1});
    QVERIFY((entering.force - Vec3(0, 0, 0.225)).norm() < 1e-12);
}

void TestHemisphereContact::zeroDepthZeroForce() {
    core::Random random(1);
    const HemisphereContact contact(everything());
    for (int n = 0; n < 20000; ++n) {
        const Vec3 surface = randomSurfacePoint(random, contact.parameters().surface);
        const Vec3 outside = surface + Vec3(0, 0, random.uniform(1e-9, 0.01));
        BristleFriction bristle;
        const auto response = contact.respond(outside, randomVector(random, 2.0), bristle);
        if (contact.parameters().surface.distance(outside).signedDistance_m <= 0.0)
            continue;
        QVERIFY(!response.inContact);
        QCOMPARE(response.force, Vec3(0, 0, 0));
        QCOMPARE(response.energy_J, 0.0);
        QCOMPARE(response.surfacePoint, outside);
    }
}

void TestHemisphereContact::dampingVanishesAtRestAndAtFirstContact() {
    core::Random random(2);
    auto law = variedParameters();
    const HemisphereContact elastic(law);
    law.damping_Ns_per_m = 50.0;
    const HemisphereContact damped(law);
    for (int n = 0; n < 20000; ++n) {
        const Vec3 p = randomSurfacePoint(random, law.surface) + randomVector(random, 0.003);
        QCOMPARE(damped.respond(p, Vec3::Zero()).force, elastic.respond(p, Vec3::Zero()).force);
    }
    const auto touch =
        damped.respond({0.05, 0.03, -1e-9}, {0, 0, -1.0}); // 1 nm deep at 1 m/s: 50 N unweighted
    QVERIFY(touch.inContact);
    QVERIFY(touch.force.norm() < 50.0 * 1e-9 / 0.0005 + 2000.0 * 1e-9);
}

// Dragged over the plane 2 mm deep (1 N): first the bristle's spring, then μ N against the motion; lifting
// the tool forgets it.
void TestHemisphereContact::frictionDragsAtMuN() {
    auto law = plainParameters();
    law.friction = 0.3;
    const HemisphereContact contact(law);
    BristleFriction bristle;
    Vec3 force;
    for (int n = 0; n <= 20; ++n) {
        force = contact.respond({0.05 + n * 1e-4, 0.03, -0.002}, Vec3::Zero(), bristle).force;
        QVERIFY((force - Vec3(-std::min(0.3, n * 0.1), 0.0, 1.0)).norm() < 1e-9);
    }
    contact.respond({0.05, 0.03, 0.002}, Vec3::Zero(), bristle); // lifted: forgotten
    force = contact.respond({0.05, 0.03, -0.002}, Vec3::Zero(), bristle).force;
    QVERIFY((force - Vec3(0.0, 0.0, 1.0)).norm() < 1e-12);
}

void TestHemisphereContact::dimpleLowersTheSurface() {
    const auto law = dimpledParameters();
    const HemisphereContact contact(law);
    const core::Vec2 d = law.dimple.centre_m;
    const double surface = std::sqrt(0.020 * 0.020 - 0.010 * 0.010); // of the ball, 10 mm from its axis
    // 1 mm dimple along the normal at 30° from vertical: the ball is entered by 0.9 mm, the dimple's floor is
    // not
    const Vec3 normal = Vec3(0.5, 0.0, surface / 0.020);
    const Vec3 onBall(d.x(), d.y(), surface);
    QVERIFY(!contact.respond(onBall - 0.0005 * normal, Vec3::Zero()).inContact);
    QVERIFY(HemisphereContact(plainParameters()).respond(onBall - 0.0005 * normal, Vec3::Zero()).inContact);
    QVERIFY(contact.respond(onBall - 0.0015 * normal, Vec3::Zero()).inContact);
    // beyond its half-width nothing changes
    const Vec3 away(law.surface.centre_m.x() - 0.005, law.surface.centre_m.y(), 0.018);
    QCOMPARE(contact.respond(away, Vec3::Zero()).force,
             HemisphereContact(plainParameters()).respond(away, Vec3::Zero()).force);
}

void TestHemisphereContact::neverPulls() {
    core::Random random(3);
    int leavingFast = 0;
    for (int block = 0; block < 1000; ++block) {
        HemisphereContact::Parameters law = plainParameters();
        law.stiffness = {random.uniform(50.0, 3000.0), random.uniform(0.0, 0.99), random.uniform(0.005, 0.06),
                         core::Vec2(random.uniform(-3.0, 3.0), random.uniform(-3.0, 3.0))};
        law.dimple = {random.uniform(0.0, 0.003), random.uniform(0.002, 0.01),
                      law.surface.centre_m +
                          core::Vec2(random.uniform(-0.02, 0.02), random.uniform(-0.02, 0.02))};
        law.damping_Ns_per_m = random.uniform(0.0, 50.0);
        law.friction = random.uniform(0.0, 2.0);
        const HemisphereContact contact(law);
        BristleFriction bristle;
        for (int n = 0; n < 1000; ++n) {
            const Vec3 p =
                randomSurfacePoint(random, law.surface) + randomVector(random, n % 10 == 0 ? 0.05 : 0.004);
            const Vec3 v = randomVector(random, 5.0);
            const auto response = contact.respond(p, v, bristle);
            QVERIFY(response.force.allFinite());
            QVERIFY(response.normalForce_N >= 0.0);
            QVERIFY(response.force.dot(response.normal) >= -1e-11 * (1.0 + response.force.norm()));
            const double rubbing = bristle.stretch().norm() * law.bristleStiffness_N_per_m;
            QVERIFY(rubbing <= law.friction * response.normalForce_N * (1.0 + 1e-12));
            leavingFast += response.inContact && response.normalForce_N == 0.0 ? 1 : 0;
        }
    }
    QVERIFY(leavingFast > 10000); // the limit really was at work
}

void TestHemisphereContact::forceIsContinuous_data() {
    QTest::addColumn<int>("which");
    QTest::newRow("plain") << 0;
    QTest::newRow("varied stiffness") << 1;
    QTest::newRow("dimple") << 2;
    QTest::newRow("both") << 3;
}

void TestHemisphereContact::forceIsContinuous() {
    QFETCH(int, which);
    auto law = which == 0   ? plainParameters()
               : which == 1 ? variedParameters()
               : which == 2 ? dimpledParameters()
                            : everything();
    law.friction = 0.0;
    const HemisphereContact contact(law);
    core::Random random(4);
    const double step = 1e-5; // 0.01 mm
    const double deepest = 0.010;
    const double slope = forceSlopeBound(law, deepest);
    int acrossTheRim = 0;
    int compared = 0;
    for (int n = 0; n < 400000; ++n) {
        const Vec3 p =
            randomSurfacePoint(random, law.surface) + randomVector(random, n % 2 == 0 ? 0.0005 : 0.006);
        const Vec3 q = p + randomVector(random, 1.0).normalized() * step;
        const auto a = contact.respond(p, Vec3::Zero());
        const auto b = contact.respond(q, Vec3::Zero());
        const double geometric = -law.surface.distance(p).signedDistance_m;
        if (geometric > deepest - step)
            continue;
        QVERIFY2((a.force - b.force).norm() <= slope * step + 1e-12,
                 qPrintable(QString("%1 N at %2 mm").arg((a.force - b.force).norm()).arg(1e3 * geometric)));
        compared += a.inContact ? 1 : 0;
        const bool sides = (p.z() < law.surface.planeHeight_m) != (q.z() < law.surface.planeHeight_m);
        acrossTheRim += sides && a.depth_m > 0.0005 ? 1 : 0;
    }
    QVERIFY(compared > 50000);
    QVERIFY(acrossTheRim > 10);
}

void TestHemisphereContact::rejectedLawJumpsAtTheRim() {
    auto law = plainParameters();
    law.stiffness.base_N_per_m = 1000.0;
    const double rho =
        std::sqrt(0.019 * 0.019 - 0.001 * 0.001); // 1 mm under the plane and 1 mm inside the ball
    const Vec3 onBisector(law.surface.centre_m.x() + rho, law.surface.centre_m.y(), -0.001);
    const Vec3 aside(1e-8, 0.0, 0.0);
    const double rejected =
        (deeperContactWins(law, onBisector + aside) - deeperContactWins(law, onBisector - aside)).norm();
    QVERIFY2(std::abs(rejected - 1.45) < 0.005, qPrintable(QString::number(rejected)));
    const Force ours = elasticForce(law);
    QVERIFY((ours(onBisector + aside) - ours(onBisector - aside)).norm() <= 1000.0 * 2.0e-8 + 1e-12);
}

void TestHemisphereContact::mirrorsAndTurns() {
    auto law = plainParameters();
    law.damping_Ns_per_m = 2.0;
    law.friction = 0.4;
    law.surface.centre_m.setZero();
    const HemisphereContact contact(law);
    core::Random random(8);
    for (int n = 0; n < 20000; ++n) {
        const Vec3 p = randomSurfacePoint(random, law.surface) + randomVector(random, 0.003);
        const Vec3 next = p + randomVector(random, 0.0002);
        const Vec3 v = randomVector(random, 0.3);
        const auto answer = [&](const core::Mat3& map) {
            BristleFriction bristle;
            contact.respond(map * p, map * v, bristle);
            return contact.respond(map * next, map * v, bristle).force;
        };
        const Vec3 straight = answer(core::Mat3::Identity());
        const core::Mat3 mirror = Vec3(-1, 1, 1).asDiagonal();
        QVERIFY((answer(mirror) - mirror * straight).norm() == 0.0); // exact: only signs change
        const core::Mat3 turn = Eigen::AngleAxisd(random.uniform(0.0, 6.0), Vec3::UnitZ()).toRotationMatrix();
        QVERIFY((answer(turn) - turn * straight).norm() < 1e-10);
    }
}

void TestHemisphereContact::sameInputsSameBits() {
    const auto run = [] {
        const HemisphereContact contact(everything());
        core::Random random(9);
        BristleFriction bristle;
        std::uint64_t digest = 0;
        for (int n = 0; n < 50000; ++n) {
            const Vec3 p =
                randomSurfacePoint(random, contact.parameters().surface) + randomVector(random, 0.003);
            const Vec3 f = contact.respond(p, randomVector(random, 1.0), bristle).force;
            for (int axis = 0; axis < 3; ++axis)
                digest = std::rotl(digest, 7) ^ std::bit_cast<std::uint64_t>(f[axis]);
        }
        return digest;
    };
    QCOMPARE(run(), run());
}

void TestHemisphereContact::proxyLiesOnTheSurface() {
    const HemisphereContact plain(plainParameters());
    const HemisphereContact dimpled(dimpledParameters());
    core::Random random(10);
    for (int n = 0; n < 20000; ++n) {
        const Vec3 p = randomSurfacePoint(random, plain.parameters().surface) + randomVector(random, 0.003);
        const auto r = plain.respond(p, Vec3::Zero());
        if (r.inContact)
            QVERIFY(std::abs(plain.parameters().surface.distance(r.surfacePoint).signedDistance_m) < 1e-12);
        const auto d = dimpled.respond(p, Vec3::Zero());
        if (d.inContact) // first order: within slope (0.26) × sideways travel (≤ depth) of the dimple's floor
            QVERIFY(dimpled.respond(d.surfacePoint, Vec3::Zero()).depth_m <= 0.26 * d.depth_m + 1e-12);
    }
}

QTEST_APPLESS_MAIN(TestHemisphereContact)
#include "test_hemisphere_contact.moc"
