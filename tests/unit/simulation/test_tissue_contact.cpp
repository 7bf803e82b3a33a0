// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/fp_environment.h"
#include "tissue_laws.h"

#include <QtTest>
#include <cstring>

using namespace chiron;
using namespace chiron::simulation;
using namespace chiron::simulation::testing;

namespace {
constexpr double kDepth = 0.004;

/// models.md §3, written out in millimetres: share by which a lump raises the normal force.
double raisedBy(double R, double h, double m, double a, double lambda, double d) {
    const double H2 = (h - lambda * d) * (h - lambda * d) + 5.0 / 3.0 * a * a;
    const double chi = 8.0 / core::kPi * a * R * R * R / (H2 * H2) * (m - 1.0) / (1.0 + 0.4 * (m - 1.0));
    return chi + 0.5 * d * chi * 4.0 * lambda * (h - lambda * d) / H2;
}
} // namespace

// P3's equations and models.md §3's numbers on the flat pad and on a furrowed dome.
class TestTissueContact : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { core::setModelFloatingPointEnvironment(); }
    void numbersOfTheModel();
    void lateralForcePointsOutward();
    void voigtByHand();
    void recastRayIsEquationOne();
    void anisotropyTurnsWithTheFrame();
    void pressedStraightDoesNotLean();
    void draggedSidewaysLeansByFriction();
    void stiffnessRisesTowardsALump();
    void nothingWhereThereIsNoLump();
    void mirrorAndRotation();
    void repeatIsIdentical();
    void secondSurfaceByHand();
    void stiffnessOfAPlainPad();
    void harderRegionByHand();
    void notFinite();
};

void TestTissueContact::numbersOfTheModel() {
    QVERIFY(std::abs(TissueContact(quietPad()).normalStiffness_N_per_m() - 226.6667) < 1e-3);
    const struct {
        double R, h, m, percent;
    } lumps[] = {{7.5, 12, 10, 45}, {7.5, 12, 3, 26}, {5, 10, 10, 24}};
    for (const auto& l : lumps) {
        const Lump lump{Vec2(0.003, -0.002), 1e-3 * l.h, 1e-3 * l.R, l.m};
        const Vec3 p(0.003, -0.002, -kDepth);
        const double with = pressAt(contactOf(quietPad(), {lump}), p).normalForce_N;
        const double without = pressAt(contactOf(quietPad(), {}), p).normalForce_N;
        QVERIFY(std::abs(100.0 * (with / without - 1.0) - l.percent) < 0.5);
        QVERIFY(std::abs(with / without - 1.0 - raisedBy(l.R, l.h, l.m, 5, 0.25, 4)) < 1e-12);
    }
}

void TestTissueContact::lateralForcePointsOutward() {
    const Lump lump{Vec2(0, 0), 0.012, 0.0075, 10.0};
    const TissueContact contact = contactOf(quietPad(), {lump});
    const double h = 0.012 - 0.25 * kDepth, b2 = 5.0 / 3.0 * 25e-6, k = contact.normalStiffness_N_per_m();
    for (const double rho : {0.001, 0.004, 0.008, 0.02}) {
        const TissueResponse r = pressAt(contact, Vec3(0.6 * rho, -0.8 * rho, -kDepth));
        const double H2 = h * h + b2, S = rho * rho + H2;
        const double strength = 8.0 / core::kPi * 0.005 * std::pow(0.0075, 3) * 9.0 / 4.6;
        const double slope = -6.0 * rho * strength * H2 / std::pow(S, 4); // ∂χ/∂ρ
        const double lateral = -0.5 * k * kDepth * kDepth * slope;
        QVERIFY(std::abs(r.force.x() - 0.6 * lateral) < 1e-12 &&
                std::abs(r.force.y() + 0.8 * lateral) < 1e-12);
        QVERIFY(lateral > 0.0);
        QVERIFY(std::abs(r.energy_J - 0.5 * k * kDepth * kDepth * (1.0 + strength * H2 / std::pow(S, 3))) <
                1e-15);
        // eq. 2 and 3
        const double fn = r.force.z();
        QVERIFY(std::abs(std::cos(r.lean_rad) - fn / r.force.norm()) < 1e-9);
        QVERIFY(std::abs(r.normalForce_N - r.force.norm() * std::cos(r.lean_rad)) < 1e-9);
    }
}

void TestTissueContact::voigtByHand() {
    TissueParameters p;
    p.stiffness_N_per_m = 650.0;
    p.damping_Ns_per_m = Vec3(0.050, 0.045, 0.055);
    const TissueContact contact = contactOf(p, {});
    const TissueResponse r = pressAt(contact, Vec3(0.01, 0.0, -0.003), Vec3(0.1, -0.2, -0.1));
    QVERIFY((r.force - Vec3(-0.005, 0.009, 650.0 * 0.003 + 0.0055)).norm() < 1e-12);
    // Half of the damping depth: smoothstep(½) = ½.
    QVERIFY(std::abs(pressAt(contact, Vec3(0, 0, -0.0005), Vec3(0, 0, -0.1)).force.z() - (0.325 + 0.00275)) <
            1e-12);
    // Leaving however fast: never pulls, and drags nothing along.
    const TissueResponse left = pressAt(contact, Vec3(0, 0, -0.003), Vec3(0.3, 0, 80.0));
    QVERIFY(left.force.norm() == 0.0 && left.inContact && left.display.normalForce_N == 0.0);
}

void TestTissueContact::recastRayIsEquationOne() {
    TissueParameters p;
    p.contact = TissueContactLaw::p3Recast;
    p.stiffness_N_per_m = 650.0;
    p.fibreDirection = Vec3(0.6, 0.8, 0.0);
    const TissueContact contact = contactOf(p, {});
    core::ToolState tool = toolAt(Vec3(0.01, 0.02, -kDepth));
    tool.q_WT = core::Quat(Eigen::AngleAxisd(core::kPi / 6.0, Vec3::UnitY())); // the ray leans 30° towards −x
    TissueTouch touch;
    const TissueResponse r = contact.respond(tool, touch);
    const double across = kDepth * std::tan(core::kPi / 6.0); // C lies this far towards +x
    const Vec3 x(0.6, 0.8, 0.0), y(-0.8, 0.6, 0.0);
    const Vec3 expected = 800.0 * across * 0.6 * x + 700.0 * across * -0.8 * y + Vec3(0, 0, 650.0 * kDepth);
    QVERIFY2((r.force - expected).norm() < 1e-12, qPrintable(QString::number((r.force - expected).norm())));
    tool.q_WT.setIdentity(); // along the normal it is the other law
    QVERIFY((contact.respond(tool, touch).force - Vec3(0, 0, 650.0 * kDepth)).norm() < 1e-12);
}

void TestTissueContact::anisotropyTurnsWithTheFrame() {
    for (const double turn : {0.0, 0.4, 1.1, 2.5}) {
        TissueParameters p = quietPad();
        p.friction = 5.0;
        p.fibreDirection = Vec3(std::cos(turn), std::sin(turn), 0.7);
        const TissueContact contact = contactOf(p, {});
        TissueTouch touch;
        contact.respond(toolAt(Vec3(0, 0, -kDepth)), touch);
        const Vec3 moved(2e-4, -1e-4, 0.0);
        const Vec3 f = contact.respond(toolAt(Vec3(0, 0, -kDepth) + moved), touch).force;
        const Vec3 along(std::cos(turn), std::sin(turn), 0), across(-std::sin(turn), std::cos(turn), 0);
        const Vec3 expected = -800.0 * moved.dot(along) * along - 700.0 * moved.dot(across) * across;
        QVERIFY((f - expected - Vec3(0, 0, f.z())).norm() < 1e-12);
    }
    TissueParameters p; // the fibre stands on the pad: still a frame
    p.fibreDirection = Vec3(0, 0, -3.0);
    QVERIFY(pressAt(contactOf(p), Vec3(0.01, 0, -kDepth)).force.allFinite());
}

void TestTissueContact::pressedStraightDoesNotLean() {
    TissueParameters p;
    p.tangentAcross_N_per_m = p.tangentAlong_N_per_m = p.stiffness_N_per_m = 650.0;
    p.shape = furrowedDome();
    const TissueContact contact = contactOf(p, {});
    core::Random random(3);
    for (int n = 0; n < 200; ++n) {
        const Vec2 xy(random.uniform(-0.03, 0.03), random.uniform(-0.03, 0.03));
        TissueTouch touch;
        TissueResponse r;
        for (int i = 0; i <= 40; ++i)
            r = contact.respond(toolAt(under(contact, xy, 1e-4 * i)), touch);
        QVERIFY2(r.lean_rad < 1e-9 && r.inContact, qPrintable(QString::number(r.lean_rad)));
        QVERIFY(std::abs(r.normalForce_N - 650.0 * kDepth) < 1e-9);
    }
}

void TestTissueContact::draggedSidewaysLeansByFriction() {
    TissueParameters p;
    p.damping_Ns_per_m.setZero();
    for (const double mu : {0.1, 0.2, 0.5}) {
        p.friction = mu;
        const TissueContact contact = contactOf(p, {});
        for (const Vec3& way : {Vec3(1, 0, 0), Vec3(0, -1, 0), Vec3(0.6, 0.8, 0)}) {
            TissueTouch touch;
            double before = -1.0;
            for (int i = 0; i <= 400; ++i) {
                const TissueResponse r = contact.respond(toolAt(Vec3(0, 0, -kDepth) + 1e-5 * i * way), touch);
                QVERIFY(r.lean_rad >= before - 1e-12 && r.lean_rad <= std::atan(mu) + 1e-12);
                before = r.lean_rad;
            }
            QVERIFY(std::abs(before - std::atan(mu)) < 1e-9);
        }
    }
}

void TestTissueContact::stiffnessRisesTowardsALump() {
    for (const bool curved : {false, true})
        for (const double ratio : {1.5, 3.0, 10.0, 40.0}) {
            TissueParameters p = quietPad();
            if (curved)
                p.shape.bumps = {{Vec2(0, 0), Vec2(0.045, 0.045), 0.0, 0.010}};
            const TissueContact contact = contactOf(p, {{Vec2(0, 0), 0.012, 0.0075, ratio}});
            double before = 0.0;
            for (int i = 30; i >= 0; --i) { // from 15 mm to the centre, pressed along the normal
                const TissueResponse r = pressAt(contact, under(contact, Vec2(0.0005 * i, 0.0), 0.002));
                QVERIFY(r.normalForce_N / r.depth_m >
                        before); // as it is felt: the reported one bounds sideways changes, too
                before = r.normalForce_N / r.depth_m;
            }
        }
}

void TestTissueContact::nothingWhereThereIsNoLump() {
    core::Random random(9);
    for (const auto& p : {quietPad(), quietDome()})
        for (const LumpLaw law : {LumpLaw::inclusion, LumpLaw::stiffnessTimesDepth}) {
            TissueParameters with = p;
            with.lumps = law;
            std::vector<Lump> same = threeLumps();
            for (Lump& lump : same)
                lump.ratio = 1.0;
            const TissueContact none = contactOf(with, {}), own = contactOf(with, same),
                                far = contactOf(with);
            for (int n = 0; n < 500; ++n) {
                const Vec3 place = randomUnder(random, none, 0.035, 0.005);
                QVERIFY(pressAt(none, place).force == pressAt(own, place).force); // to the bit
                const Vec3 aside(place.x() + 0.25, place.y(), p.shape.planeHeight_m - kDepth);
                const Vec3 difference = pressAt(none, aside).force - pressAt(far, aside).force;
                QVERIFY2(difference.norm() < 1e-6,
                         qPrintable(QString::number(difference.norm()))); // 0.25 m away: under 1 µN
            }
        }
    // P3's second surface ends where the ball ends.
    TissueParameters p = quietPad();
    p.lumps = LumpLaw::secondSurface;
    QVERIFY(pressAt(contactOf(p), Vec3(0.0, 0.0, -0.0045)).force ==
            pressAt(contactOf(p, {}), Vec3(0.0, 0.0, -0.0045)).force);
}

void TestTissueContact::mirrorAndRotation() {
    core::Random random(12);
    for (int n = 0; n < 300; ++n) {
        const double turn = random.uniform(0.0, 6.28);
        const Eigen::AngleAxisd spin(turn, Vec3::UnitZ());
        const core::Mat3 mirror = Vec3(1.0, -1.0, 1.0).asDiagonal();
        TissueParameters p;
        p.shape.bumps = {{Vec2(0.004, 0.002), Vec2(0.04, 0.03), 0.4, 0.010}};
        p.fibreDirection = Vec3(0.9, 0.3, 0.1);
        p.regions = {harderRegion()};
        const std::vector<Lump> lumps = threeLumps();
        const auto moved = [&](const core::Mat3& by, double sign, double add) {
            TissueParameters q = p;
            const auto flat = [&](const Vec2& v) { return Vec2((by * Vec3(v.x(), v.y(), 0)).head<2>()); };
            q.shape.bumps[0].centre_m = flat(p.shape.bumps[0].centre_m);
            q.shape.bumps[0].turn_rad = sign * p.shape.bumps[0].turn_rad + add;
            q.regions[0].centre_m = flat(p.regions[0].centre_m);
            q.regions[0].turn_rad = sign * p.regions[0].turn_rad + add;
            q.fibreDirection = by * p.fibreDirection;
            std::vector<Lump> l = lumps;
            for (Lump& one : l)
                one.place_m = flat(one.place_m);
            return contactOf(q, l);
        };
        const TissueContact here = contactOf(p), turned = moved(spin.toRotationMatrix(), 1.0, turn),
                            mirrored = moved(mirror, -1.0, 0.0);
        const Vec3 at = randomUnder(random, here, 0.02, 0.005),
                   to = at + Vec3(random.uniform(-2e-4, 2e-4), random.uniform(-2e-4, 2e-4),
                                  random.uniform(-2e-4, 2e-4));
        TissueTouch a, b, c;
        here.respond(toolAt(at), a);
        turned.respond(toolAt(spin * at), b);
        mirrored.respond(toolAt(mirror * at), c);
        const Vec3 v(0.02, -0.05, -0.03);
        const TissueResponse r = here.respond(toolAt(to, v), a);
        QVERIFY((spin * r.force - turned.respond(toolAt(spin * to, spin * v), b).force).norm() < 1e-9);
        QVERIFY((mirror * r.force - mirrored.respond(toolAt(mirror * to, mirror * v), c).force).norm() <
                1e-9);
    }
}

void TestTissueContact::repeatIsIdentical() {
    TissueParameters p = quietDome();
    p.friction = 0.3;
    p.damping_Ns_per_m = Vec3(2, 2, 2);
    core::Random random(4);
    const auto loop = randomLoop(random, Vec3(0.0, 0.0, 0.010), 0.012, 3000);
    std::vector<Vec3> first;
    for (int run = 0; run < 2; ++run) {
        const TissueContact contact = contactOf(p);
        TissueTouch touch;
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const Vec3 f = contact.respond(toolAt(loop[i], Vec3(0.01, 0.02, -0.03)), touch).force;
            if (run == 0)
                first.push_back(f);
            else
                QVERIFY(std::memcmp(f.data(), first[i].data(), sizeof(double) * 3) == 0);
        }
    }
}

void TestTissueContact::secondSurfaceByHand() {
    TissueParameters p = quietPad();
    p.lumps = LumpLaw::secondSurface;
    p.stiffness_N_per_m = 650.0;
    const TissueContact contact = contactOf(p, {{Vec2(0, 0), 0.010, 0.0075, 10.0}});
    const Vec3 at(0.003, 0.0, -0.006); // 5 mm from the centre: 2.5 mm of the ball, along (0.6, 0, 0.8)
    const TissueResponse r = pressAt(contact, at);
    QVERIFY((r.force - Vec3(3.0 * 0.6, 0, 3.9 + 3.0 * 0.8)).norm() < 1e-12);
    QVERIFY(std::abs(r.energy_J - (325.0 * 36e-6 + 600.0 * 6.25e-6)) < 1e-15);
    QVERIFY(std::abs(r.lean_rad - std::atan(1.8 / 6.3)) < 1e-12 && std::abs(r.normalForce_N - 6.3) < 1e-12);
    // In the middle of the ball nothing jumps.
    QVERIFY((pressAt(contact, Vec3(1e-6, 0, -0.010)).force - pressAt(contact, Vec3(-1e-6, 0, -0.010)).force)
                .norm() < 1e-3);
}

/// The stiffness that the passivity credit reckons with: the law's own where nothing lies in a flat tissue.
void TestTissueContact::stiffnessOfAPlainPad() {
    const TissueContact contact = contactOf(quietPad(), {});
    for (const double depth_m : {0.0005, 0.002, 0.004})
        QCOMPARE(pressAt(contact, Vec3(0.003, -0.002, -depth_m)).stiffness_N_per_m,
                 contact.normalStiffness_N_per_m());
}

void TestTissueContact::harderRegionByHand() {
    TissueParameters p = quietPad();
    p.regions = {{"muscle", Vec2(0.01, 0.0), Vec2(0.010, 0.005), 0.0, 0.5}};
    const TissueContact contact = contactOf(p, {});
    const double k = contact.normalStiffness_N_per_m();
    const TissueResponse r = pressAt(contact, Vec3(0.015, 0.0, -kDepth)); // t = ½ along x
    const double u = 0.75;
    QVERIFY(std::abs(r.force.z() - k * kDepth * (1.0 + 0.5 * u * u * u)) < 1e-12);
    QVERIFY(std::abs(r.force.x() - 0.5 * k * kDepth * kDepth * 0.5 * 3.0 * u * u * 2.0 * 0.5 / 0.010) <
            1e-12);
    QVERIFY(pressAt(contact, Vec3(0.0, 0.0051, -kDepth)).force.x() == 0.0);
}

void TestTissueContact::notFinite() {
    const TissueContact contact = contactOf(quietDome());
    TissueTouch touch;
    contact.respond(toolAt(under(contact, Vec2(0, 0), 0.003)), touch);
    QVERIFY(touch.touching);
    const TissueResponse r = contact.respond(toolAt(Vec3(std::nan(""), 0, 0)), touch);
    QVERIFY(!touch.touching && !r.inContact && r.force.isZero());
    contact.respond(toolAt(under(contact, Vec2(0, 0), 0.003)), touch);
    QVERIFY(!contact.respond(toolAt(Vec3(0, 0, 0), Vec3(0, std::nan(""), 0)), touch).inContact &&
            !touch.touching);
}

QTEST_APPLESS_MAIN(TestTissueContact)
#include "test_tissue_contact.moc"
