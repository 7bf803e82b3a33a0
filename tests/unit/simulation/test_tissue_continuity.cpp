// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/fp_environment.h"
#include "tissue_laws.h"

#include <QtTest>

using namespace chiron;
using namespace chiron::simulation;
using namespace chiron::simulation::testing;

namespace {
constexpr double kStep = 1e-6;

TissueParameters everything(bool curved) {
    TissueParameters p;
    p.friction = 0.3;
    if (curved)
        p.shape = furrowedDome();
    p.regions = {harderRegion()};
    return p;
}

/// Force per metre that the tissue answers to a small move at constant velocity `speed`, at most, to a depth
/// of 5 mm: the potential, k (1 + gain) with at most as much again for its changes over place (the lump's
/// rise over one of its depths, the region's over one of its radii) and over depth; the balls; the bristle;
/// friction that follows the normal force; damping's fade-in, smoothstep's slope 1.5 over its depth.
double slopeBound(const TissueContact& contact, const TissueParameters& p, double speed) {
    const double gain = 1.9; // χ ≤ 0.4 + 0.23 + 0.25, the region 0.4, rounded up
    const double k = 2.0 * contact.normalStiffness_N_per_m() * (1.0 + gain) +
                     (p.lumps == LumpLaw::secondSurface ? 4.0 * 1200.0 : 0.0);
    const double damping = 2.0 * speed * 1.5 / p.dampingDepth_m;
    return (k + damping) * (1.0 + p.friction) + std::max(p.tangentAlong_N_per_m, p.tangentAcross_N_per_m);
}

struct Worst {
    double perMetre = 0.0;
    int contacts = 0;
};

/// Walks straight on in steps of 1 µm and looks at how the force changes.
Worst along(const TissueContact& contact, const Vec3& from, const Vec3& to, const Vec3& v) {
    Worst worst;
    TissueTouch touch;
    Vec3 before = contact.respond(toolAt(from, v), touch).force;
    const int steps = static_cast<int>((to - from).norm() / kStep);
    for (int i = 1; i <= steps; ++i) {
        const TissueResponse r =
            contact.respond(toolAt(from + (to - from) * (static_cast<double>(i) / steps), v), touch);
        worst.perMetre = std::max(worst.perMetre, (r.force - before).norm() / kStep);
        worst.contacts += r.inContact ? 1 : 0;
        before = r.force;
    }
    return worst;
}
} // namespace

// No edge may be felt: over each of them the force changes by at most a stated stiffness per micrometre.
class TestTissueContinuity : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { core::setModelFloatingPointEnvironment(); }
    void straightOverEveryEdge_data();
    void straightOverEveryEdge();
    void everyPushPushes();
    void jumpsThroughAThinLayer();
    void grazingRay();
    void farAway();
};

void TestTissueContinuity::straightOverEveryEdge_data() {
    QTest::addColumn<bool>("curved");
    QTest::addColumn<int>("law");
    QTest::addColumn<double>("speed");
    for (const bool curved : {false, true})
        for (const LumpLaw law : {LumpLaw::inclusion, LumpLaw::secondSurface, LumpLaw::stiffnessTimesDepth})
            for (const double speed : {0.0, 0.1})
                QTest::addRow("%s, law %d, %.1f m/s", curved ? "dome" : "pad", static_cast<int>(law), speed)
                    << curved << static_cast<int>(law) << speed;
}

// Down and up through loss of contact, across lump rims, the bump's rim (40 mm out), the furrow, the region's
// rim, and grazing.
void TestTissueContinuity::straightOverEveryEdge() {
    QFETCH(bool, curved);
    QFETCH(int, law);
    QFETCH(double, speed);
    TissueParameters p = everything(curved);
    p.lumps = static_cast<LumpLaw>(law);
    const TissueContact contact = contactOf(p);
    const double bound = slopeBound(contact, p, speed) *
                         (curved ? 1.3 : 1.0); // feet on the dome move up to 1.3 times as far as the tool
    core::Random random(21);
    int contacts = 0;
    for (int n = 0; n < 40; ++n) {
        const Vec3 from = randomUnder(random, contact, 0.045, 0.005) + Vec3(0, 0, 0.001);
        Vec3 to = randomUnder(random, contact, 0.045, 0.005) + Vec3(0, 0, 0.002);
        if (n % 4 == 0)
            to = from + Vec3(0, 0, 0.006); // out
        to = from + (to - from) * std::min(1.0, 0.02 / (to - from).norm());
        const Worst worst = along(contact, from, to, speed * (to - from).normalized());
        contacts += worst.contacts;
        QVERIFY2(worst.perMetre <= bound,
                 qPrintable(QString("%1 N/m, bound %2").arg(worst.perMetre).arg(bound)));
    }
    QVERIFY(contacts > 50000);
}

// Anywhere, at any speed, with any law: the force has no part that pulls, and the shown normal force is that
// part.
void TestTissueContinuity::everyPushPushes() {
    core::Random random(22);
    for (int n = 0; n < 6; ++n) {
        TissueParameters p = everything(n % 2 == 1);
        p.lumps = static_cast<LumpLaw>(n / 2);
        for (const TissueContactLaw law : {TissueContactLaw::anchored, TissueContactLaw::p3Recast}) {
            p.contact = law;
            const TissueContact contact = contactOf(p);
            TissueTouch touch;
            for (int i = 0; i < 20000; ++i) {
                core::ToolState tool =
                    toolAt(randomUnder(random, contact, 0.04, 0.02), 2.0 * randomUnit(random));
                tool.q_WT = core::Quat(Eigen::AngleAxisd(random.uniform(-1.5, 1.5), randomUnit(random)));
                const TissueResponse r = contact.respond(tool, touch);
                QVERIFY(r.force.allFinite() && r.force.dot(r.normal) >= -1e-12 && r.normalForce_N >= 0.0);
                QVERIFY(std::abs(r.display.normalForce_N - std::max(0.0, r.force.dot(r.normal))) < 1e-12);
                QVERIFY(std::abs(r.display.pitch_rad) <= core::kPi / 6 + 1e-12 &&
                        std::abs(r.display.roll_rad) <= core::kPi / 9 + 1e-12);
            }
        }
    }
}

// A finger that is above the tissue in one tick and deep below a thin layer, or inside or under a lump, in
// the next: pushed out with the elastic force of that place, never in.
void TestTissueContinuity::jumpsThroughAThinLayer() {
    TissueParameters p;
    p.layers = {{"film", 0.0005, 40e3}, {"gland", 1.0, 17e3}};
    for (const LumpLaw law : {LumpLaw::inclusion, LumpLaw::secondSurface}) {
        p.lumps = law;
        const TissueContact contact = contactOf(p);
        for (const double depth : {0.0006, 0.004, 0.011, 0.0125, 0.018}) {
            TissueTouch jumped;
            contact.respond(toolAt(Vec3(0.001, 0, 0.002)), jumped);
            const TissueResponse a = contact.respond(toolAt(Vec3(0.001, 0, -depth)), jumped);
            QVERIFY(a.force.z() > 0.0 && a.depth_m == depth);
            QVERIFY((a.force - pressAt(contact, Vec3(0.001, 0, -depth)).force).norm() ==
                    0.0); // no memory of where it came from
        }
    }
}

// The re-cast ray turns from the normal to flat and beyond: no jump where the ray stops to count, and no more
// than its 60° at most.
void TestTissueContinuity::grazingRay() {
    TissueParameters p = quietPad();
    p.contact = TissueContactLaw::p3Recast;
    const TissueContact contact = contactOf(p, {});
    TissueTouch touch;
    Vec3 before = Vec3::Zero();
    double largest = 0.0;
    for (int i = 0; i <= 40000; ++i) {
        core::ToolState tool = toolAt(Vec3(0, 0, -0.004));
        tool.q_WT = core::Quat(Eigen::AngleAxisd(core::kPi * i / 40000, Vec3::UnitY()));
        const TissueResponse r = contact.respond(tool, touch);
        if (i > 0)
            QVERIFY2((r.force - before).norm() < 0.01, qPrintable(QString::number(i)));
        QVERIFY(std::abs(r.force.z() - contact.normalStiffness_N_per_m() * 0.004) < 1e-9);
        largest = std::max(largest, r.force.head<2>().norm());
        before = r.force;
    }
    QVERIFY(before.head<2>().norm() == 0.0 && largest < 800.0 * 0.004 * 2.0);
}

void TestTissueContinuity::farAway() {
    for (const bool curved : {false, true}) {
        const TissueContact contact = contactOf(everything(curved));
        TissueTouch touch;
        for (const Vec3& p :
             {Vec3(0, 0, 10.0), Vec3(5.0, -3.0, 0.5), Vec3(1e3, 1e3, 1e3), Vec3(0.5, 0.5, 0.001 + 0.002)}) {
            const TissueResponse r = contact.respond(toolAt(p), touch);
            QVERIFY(!r.inContact && r.force.isZero() && r.surfacePoint.allFinite() && !touch.touching);
        }
        const TissueResponse deep = contact.respond(toolAt(Vec3(0.01, 0.02, -0.3)), touch);
        QVERIFY(deep.inContact && deep.force.allFinite() && deep.force.z() > 0.0);
    }
}

QTEST_APPLESS_MAIN(TestTissueContinuity)
#include "test_tissue_continuity.moc"
