// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/random.h"
#include "core/units.h"
#include "simulation/objects/free_body.h"
#include "simulation/objects/object_contact.h"
#include "support/passive_object.h"

#include <QtTest>
#include <algorithm>
#include <cmath>

using namespace chiron;
using namespace chiron::simulation;
using core::Vec3;

namespace {

constexpr double kTick = core::kTickSeconds;
constexpr double g = core::kStandardGravity;

/// A plane z = 0 of stiffness k and damping c under a point.
auto bed(double k, double c) {
    return [k, c](const Vec3& p, const Vec3& v) noexcept {
        BodySupport out;
        out.touching = p.z() < 0.0;
        if (out.touching)
            out.force.z() = std::max(0.0, -k * p.z() - c * v.z());
        return out;
    };
}

} // namespace

class TestLooseObjects : public QObject {
    Q_OBJECT
private slots:
    void fallsAsGalileiSays();
    void liesAtItsRestDepth();
    void landsOnceWithItsSpeed();
    void heldFollowsExactly();
    void bouncesWithoutRunningAway();
    void lyingBodyKeepsStill();
    void passiveBooksOfASpring();
    void passiveBooksFindAnActiveObject();
    void passiveBooksOverTwoTools();
    void sampledSpringMakesWhatIsSaid();
};

// ½ g t (t + h): semi-implicit Euler's own closed form, h more than Galilei's ½ g t².
void TestLooseObjects::fallsAsGalileiSays() {
    FreeBody body(0.010);
    body.place(Vec3(0.0, 0.0, 1.0));
    for (int n = 1; n <= 400; ++n) {
        body.step(kTick, bed(500.0, 1.0));
        const double t = n * kTick;
        QVERIFY(std::abs(1.0 - body.p_W().z() - 0.5 * g * t * (t + kTick)) < 1e-12);
        QVERIFY(std::abs(body.v_W().z() + g * t) < 1e-12);
    }
    QVERIFY(std::abs(1.0 - body.p_W().z() - 0.5 * g * 0.16) < 0.002);
}

void TestLooseObjects::liesAtItsRestDepth() {
    for (const double k : {100.0, 500.0, 2000.0}) {
        FreeBody body(0.010, 0.05);
        body.place(Vec3(0.0, 0.0, 0.02));
        for (int n = 0; n < 10000; ++n)
            body.step(kTick, bed(k, 0.5));
        QVERIFY2(std::abs(body.p_W().z() + 0.010 * g / k) < 1e-9,
                 qPrintable(QString::number(body.p_W().z())));
        QVERIFY(body.v_W().norm() < 1e-9 && body.touching());
    }
}

void TestLooseObjects::landsOnceWithItsSpeed() {
    FreeBody body(0.010);
    body.place(Vec3(0.0, 0.0, 0.05));
    body.hold();
    body.follow(Vec3(0.0, 0.0, 0.05), Vec3(0.1, 0.0, 0.0));
    QVERIFY(!body.step(kTick, bed(500.0, 1.0)) && body.p_W().z() == 0.05); // held: the bed does not move it
    body.release();
    int landings = 0;
    int ticks = 0;
    for (int n = 0; n < 3000; ++n) {
        const bool landed = body.step(kTick, bed(500.0, 1.0));
        landings += landed ? 1 : 0;
        if (landed)
            ticks = n;
    }
    QCOMPARE(landings, 1);
    QVERIFY(std::abs(ticks * kTick - std::sqrt(2.0 * 0.05 / g)) < 0.003);
    const double speed = std::sqrt(2.0 * g * 0.05 + 0.01); // thrown sideways with what the tool had
    QVERIFY2(std::abs(body.landingSpeed_m_per_s() - speed) < 0.02,
             qPrintable(QString::number(body.landingSpeed_m_per_s())));
    QVERIFY(std::abs(body.p_W().x() - 0.1 * 3.0) < 1e-3); // no friction here: it goes on
}

void TestLooseObjects::heldFollowsExactly() {
    FreeBody body(0.010);
    body.hold();
    core::Random random(2);
    for (int n = 0; n < 1000; ++n) {
        const Vec3 p(random.uniform(), random.uniform(), random.uniform());
        body.follow(p, Vec3::Zero());
        body.step(kTick, bed(500.0, 1.0));
        QVERIFY(body.p_W() == p && body.held());
    }
}

// On a lossless bed it bounces for ever; each landing falls into its tick by chance, ½ k (v h)² either way,
// and does not add up.
void TestLooseObjects::bouncesWithoutRunningAway() {
    FreeBody body(0.010);
    body.place(Vec3(0.0, 0.0, 0.03));
    double highestEarly = 0.0;
    double highestLate = 0.0;
    for (int n = 0; n < 20000; ++n) {
        body.step(kTick, bed(500.0, 0.0));
        (n < 5000 ? highestEarly : highestLate) =
            std::max(n < 5000 ? highestEarly : highestLate, body.p_W().z());
    }
    QVERIFY2(highestLate < 1.25 * highestEarly, qPrintable(QString::number(highestLate / highestEarly)));
    FreeBody damped(0.010);
    damped.place(Vec3(0.0, 0.0, 0.03));
    for (int n = 0; n < 5000; ++n)
        damped.step(kTick, bed(500.0, 1.0));
    QVERIFY(damped.energy_J() < 0.0 && damped.energy_J() > -0.010 * g * 0.001);
}

// On a real object's surface, with its friction, roughness and dent, a body that lies stays where it is.
void TestLooseObjects::lyingBodyKeepsStill() {
    ObjectAttributes organ;
    organ.stiffness_N_per_m = 227.0;
    organ.stiffening_per_m = 40.0;
    organ.recoveryTime_s = 0.5;
    organ.recoveryShare = 0.6;
    organ.roughness_m = 20e-6;
    organ.roughnessWavelength_m = 0.004;
    organ.friction = 0.15;
    const ObjectContact contact(organ);
    ObjectContactState state;
    FreeBody body(0.010, 0.05);
    body.place(Vec3(0.003, -0.002, 0.001));
    const auto support = [&](const Vec3& p, const Vec3& v) noexcept {
        ContactPlace place;
        place.depth_m = -p.z();
        place.foot = Vec3(p.x(), p.y(), 0.0);
        place.position = p;
        place.velocity = v;
        const auto out = contact.respond(place, kTick, state);
        return BodySupport{out.force, out.inContact};
    };
    for (int n = 0; n < 10000; ++n)
        body.step(kTick, support);
    const Vec3 rest = body.p_W();
    double moved = 0.0;
    for (int n = 0; n < 10000; ++n) {
        body.step(kTick, support);
        moved = std::max(moved, (body.p_W() - rest).norm());
    }
    QVERIFY2(moved < 1e-9, qPrintable(QString::number(moved)));
    // carried by the micro-height's slope: the elastic part has the weight to within what friction on that
    // slope takes
    const double depth = contact.roughness().sample({rest.x(), rest.y(), 0.0}).height_m - rest.z();
    const double carried = contact.elastic().tension(depth);
    QVERIFY2(std::abs(carried / (0.010 * g) - 1.0) < 0.01, qPrintable(QString::number(carried)));
}

void TestLooseObjects::passiveBooksOfASpring() {
    tests::PassiveObject books;
    // pressed 2 mm into 500 N/m and back, slowly: displayed −1 mJ, then 0, never made more than the sampling
    // does
    for (int n = 0; n <= 2000; ++n) {
        const double d = 0.002 * (n <= 1000 ? n : 2000 - n) / 1000.0;
        books.update(0, d > 0.0, Vec3(0, 0, -d), Vec3(0, 0, 500.0 * d), 250.0 * d * d);
        if (n == 1000) {
            QVERIFY(std::abs(books.displayed_J() + 0.001) < 2e-6);
            QCOMPARE(books.stored_J(), 0.001);
            QVERIFY(std::abs(books.contact(0).moved_m() - 0.002) < 3e-6);
        }
    }
    QVERIFY(std::abs(books.made_J()) < 3e-6 && books.worst_J() < 3e-6);
    QVERIFY(!books.contact(0).touching);
    QCOMPARE(books.stored_J(), 0.0);
}

// P2's interpolated normals in one line: pressed along one direction, let out along another, energy comes
// from nowhere.
void TestLooseObjects::passiveBooksFindAnActiveObject() {
    tests::PassiveObject books;
    for (int n = 0; n <= 2000; ++n) {
        const double d = 0.004 * (n <= 1000 ? n : 2000 - n) / 1000.0;
        const double k = n <= 1000 ? 400.0 : 1200.0; // stiffness told too late
        books.update(1, d > 0.0, Vec3(0, 0, -d), Vec3(0, 0, k * d), 0.5 * k * d * d);
    }
    QVERIFY2(std::abs(books.made_J() - 0.0064) < 5e-5,
             qPrintable(QString::number(books.made_J()))); // models.md §0: 6.4 mJ
    QVERIFY(books.worst_J() >= books.made_J());
    books.reset();
    QCOMPARE(books.made_J(), 0.0);
}

// What one tool puts into an object the other may take out: the object's books say so, the contacts' alone
// would not.
void TestLooseObjects::passiveBooksOverTwoTools() {
    tests::PassiveObject books;
    for (int n = 0; n <= 1000;
         ++n) { // a spring between two tools: the first stretches it, then the second lets it in
        const double x = 0.01 * n / 1000.0;
        books.update(0, true, Vec3(x, 0, 0), Vec3(-100.0 * x, 0, 0), 0.5 * 0.5 * 100.0 * x * x);
        books.update(1, true, Vec3::Zero(), Vec3(100.0 * x, 0, 0), 0.5 * 0.5 * 100.0 * x * x);
    }
    for (int n = 0; n <= 1000; ++n) {
        const double x = 0.01 * (1000 - n) / 1000.0;
        books.update(0, true, Vec3(0.01, 0, 0), Vec3(-100.0 * x, 0, 0), 0.25 * 100.0 * x * x);
        books.update(1, true, Vec3(0.01 - x, 0, 0), Vec3(100.0 * x, 0, 0), 0.25 * 100.0 * x * x);
    }
    QVERIFY(books.contact(1).made_J() > 0.004); // alone it seems to have made 5 mJ
    QVERIFY2(std::abs(books.made_J()) < 2e-5, qPrintable(QString::number(books.made_J())));
}

// ½ k Δx² a tick, for a sampled spring that is let out: what the supervisor's controller is there for.
void TestLooseObjects::sampledSpringMakesWhatIsSaid() {
    tests::PassiveObject books;
    const double step = 1e-4; // 0.1 m/s
    for (int n = 0; n <= 20; ++n)
        books.update(0, true, Vec3(0, 0, -n * step), Vec3(0, 0, 1000.0 * n * step),
                     500.0 * n * n * step * step);
    QVERIFY(std::abs(books.made_J() - 20 * 0.5 * 1000.0 * step * step) < 1e-12);
}

QTEST_APPLESS_MAIN(TestLooseObjects)
#include "test_loose_objects.moc"
