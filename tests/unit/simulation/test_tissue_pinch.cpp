// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact_bits.h"
#include "core/fp_environment.h"
#include "palpation_driver.h"
#include "simulation/objects/grasp.h"
#include "simulation/palpation/tissue_pinch.h"
#include "tissue_laws.h"

#include <QtTest>
#include <algorithm>
#include <cmath>
#include <limits>

using namespace chiron;
using namespace chiron::simulation;
using namespace chiron::simulation::testing;

namespace {

constexpr double kOpen_rad = 0.9;
namespace q = palpation_quantity;

/// One hand at a tissue: contact and jaw, tick after tick.
struct Pincher {
    const TissueContact& contact;
    PinchParameters parameters;
    TissueTouch touch;
    PinchTouch pinched;
    PinchResponse now;
    TissueResponse pressed;

    PinchResponse at(const core::ToolState& tool) {
        pressed = contact.respond(tool, touch);
        return now = pinchTissue(contact, parameters, tool, pressed, pinched);
    }
    PinchResponse at(const Vec3& p_W, double jaw_rad, const core::Quat& turn = core::Quat::Identity()) {
        core::ToolState tool = toolAt(p_W);
        tool.jaw_rad = jaw_rad;
        tool.q_WT = turn;
        return at(tool);
    }
    /// In with open jaws, then closed to `jaw_rad`.
    PinchResponse squeeze(const Vec3& p_W, double jaw_rad) {
        pinched.release();
        touch.release();
        at(p_W, kOpen_rad);
        return at(p_W, jaw_rad);
    }
};

PalpationParameters pinchedPad() {
    PalpationParameters p = flatPad();
    p.pinch = PinchParameters{};
    p.yield.force_N = 12.0;
    p.catchTrials = 0;
    return p;
}

/// Into the first trial, open jaws in the air.
void begin(PalpationDriver& d) {
    d.in.tools.tools[0].jaw_rad = kOpen_rad;
    d.startRunning();
}

} // namespace

class TestTissuePinch : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { core::setModelFloatingPointEnvironment(); }
    void squeezesAsTheTissueIsStiff();
    void whatWasClosedHasNothingBetweenItsJaws();
    void aLumpBetweenTheJawsIsFirmer();
    void aFaceFeelsTheLumpsLaw();
    void outOfTheTissueThereIsNothing();
    void theHoldIsClippedByFriction();
    void theHoldMakesNoEnergy();
    void nothingJumpsWhereverTheJawCloses();
    void whatIsNoPoseSqueezesNothing();
    void closedJawsChangeNoBitOfTheExercise();
    void thePadFeelsIt();
    void eachHandHasOneJaw();
    void pinchedTooHardItTears();
    void withoutForceNothingIsSqueezed();
};

// Far from lumps, at full depth: N = k c/2, c from two jaws of 20 mm.
void TestTissuePinch::squeezesAsTheTissueIsStiff() {
    const TissueContact contact = contactOf(quietPad(), {});
    Pincher hand{contact, {}, {}, {}, {}, {}};
    const double k = contact.normalStiffness_N_per_m();
    for (const double jaw : {0.7, 0.4, 0.0}) {
        const double c = 0.040 * (std::sin(0.5 * kOpen_rad) - std::sin(0.5 * jaw));
        const PinchResponse out = hand.squeeze({0.0, 0.0, -0.005}, jaw);
        QVERIFY2(std::abs(out.compression_m - c) < 1e-15, qPrintable(QString::number(out.compression_m)));
        QVERIFY2(std::abs(out.force_N - 0.5 * k * c) < 1e-12, qPrintable(QString::number(out.force_N)));
        QCOMPARE(out.hold, Vec3(Vec3::Zero()));
        QVERIFY(!out.beyondChecked);
    }
    QVERIFY(hand.squeeze({0.0, 0.0, -0.005}, kOpen_rad + 0.3).force_N ==
            0.0); // opened wider: more comes between, nothing is squeezed
    const double half = hand.squeeze({0.0, 0.0, -0.002}, 0.4).force_N; // half of the face
    QVERIFY(std::abs(half / hand.squeeze({0.0, 0.0, -0.005}, 0.4).force_N - 0.5) < 1e-12);
}

void TestTissuePinch::whatWasClosedHasNothingBetweenItsJaws() {
    const TissueContact contact = contactOf(quietPad());
    Pincher hand{contact, {}, {}, {}, {}, {}};
    QCOMPARE(hand.at({0.0, 0.0, -0.004}, 0.0).force_N, 0.0);
    QCOMPARE(hand.at({0.001, 0.0, -0.006}, 0.0).force_N, 0.0);
    hand.at({0.0, 0.0, -0.004}, 0.5); // opened in there, something comes between
    QVERIFY(hand.at({0.0, 0.0, -0.004}, 0.2).force_N > 0.1);
    hand.at({0.0, 0.0, 0.001}, 0.2); // out, and in as it is
    QCOMPARE(hand.at({0.0, 0.0, -0.004}, 0.2).force_N, 0.0);
}

void TestTissuePinch::aLumpBetweenTheJawsIsFirmer() {
    const TissueContact lumpy = contactOf(quietPad(), {{Vec2(0.0, 0.0), 0.012, 0.0075, 10.0}});
    const TissueContact plain = contactOf(quietPad(), {});
    Pincher hand{lumpy, {}, {}, {}, {}, {}}, without{plain, {}, {}, {}, {}, {}};
    double before = 1e9;
    for (const double beside :
         {0.0, 0.004, 0.008, 0.012, 0.018, 0.030}) { // along y: the jaws straddle less and less of it
        const double ratio = hand.squeeze({0.0, beside, -0.006}, 0.3).force_N /
                             without.squeeze({0.0, beside, -0.006}, 0.3).force_N;
        QVERIFY2(ratio > 1.0 && ratio < before,
                 qPrintable(QString("%1: %2 after %3").arg(beside).arg(ratio).arg(before)));
        before = ratio;
    }
    const double above =
        hand.squeeze({0.0, 0.0, -0.006}, 0.3).force_N / without.squeeze({0.0, 0.0, -0.006}, 0.3).force_N;
    QVERIFY2(above > 1.1, qPrintable(QString::number(above)));
    QVERIFY(before < 1.02);
    QVERIFY(std::abs(hand.squeeze({0.003, 0.002, -0.005}, 0.3).force_N -
                     hand.squeeze({-0.003, -0.002, -0.005}, 0.3).force_N) < 1e-12);
    // A lump of the tissue's own stiffness cannot be felt, a softer one is softer.
    const TissueContact same = contactOf(quietPad(), {{Vec2(0.0, 0.0), 0.012, 0.0075, 1.0}});
    Pincher equal{same, {}, {}, {}, {}, {}};
    QCOMPARE(equal.squeeze({0.0, 0.0, -0.005}, 0.3).force_N,
             without.squeeze({0.0, 0.0, -0.005}, 0.3).force_N);
}

// Written out once more: chi = strength H²/S³ with the squeeze's direction, both faces.
void TestTissuePinch::aFaceFeelsTheLumpsLaw() {
    const TissueParameters tissue = quietPad();
    const Lump lump{Vec2(0.002, -0.001), 0.012, 0.0075, 10.0};
    const TissueContact contact = contactOf(tissue, {lump});
    Pincher hand{contact, {}, {}, {}, {}, {}};
    const double d = 0.006, jaw = 0.3, o = 0.040 * std::sin(0.5 * jaw),
                 spread2 = 5.0 / 3.0 * tissue.contactRadius_m * tissue.contactRadius_m;
    double gain = 0.0;
    for (const double side : {0.5, -0.5}) {
        const Vec3 r = Vec3(side * o, 0.0, -d + 0.002) - contact.lumpCentre_W(0);
        const double s = r.squaredNorm() + spread2;
        gain += 0.5 * lumpStrength(tissue.contactRadius_m, lump.radius_m, lump.ratio) *
                (r.x() * r.x() + spread2) / (s * s * s);
    }
    const double c = 0.040 * (std::sin(0.5 * kOpen_rad) - std::sin(0.5 * jaw));
    const double expected = 0.5 * contact.normalStiffness_N_per_m() * c * (1.0 + gain);
    QVERIFY2(std::abs(hand.squeeze({0.0, 0.0, -d}, jaw).force_N - expected) < 1e-12,
             qPrintable(QString::number(expected)));
}

void TestTissuePinch::outOfTheTissueThereIsNothing() {
    const TissueContact contact = contactOf(quietDome());
    Pincher hand{contact, {}, {}, {}, {}, {}};
    core::Random random(5);
    for (int n = 0; n < 500; ++n) {
        const Vec3 p =
            contact.surface().pointAt(Vec2(random.uniform(-0.04, 0.04), random.uniform(-0.04, 0.04))) +
            Vec3(0.0, 0.0, random.uniform(1e-6, 0.05));
        if (hand.contact.surface().nearest(p, p.head<2>()).depth_m > 0.0)
            continue;
        const PinchResponse out = hand.at(p, random.uniform(0.0, 1.6));
        QVERIFY(out.force_N == 0.0 && out.hold == Vec3::Zero() && out.energy_J == 0.0 &&
                out.stiffness_N_per_m == 0.0);
    }
}

void TestTissuePinch::theHoldIsClippedByFriction() {
    const TissueContact contact = contactOf(quietPad(), {});
    Pincher hand{contact, {}, {}, {}, {}, {}};
    const double n = hand.squeeze({0.0, 0.0, -0.006}, 0.2).force_N;
    const double k = contact.tangentStiffness_N_per_m(), most = 2.0 * hand.parameters.friction * n;
    hand.at({0.0005, 0.0, -0.006}, 0.2);
    QVERIFY2((hand.now.hold - Vec3(-0.0005 * k, 0.0, 0.0)).norm() < 1e-12,
             qPrintable(QString::number(hand.now.hold.x())));
    for (int i = 0; i < 50; ++i)
        hand.at({0.0005 + 0.0002 * i, 0.0, -0.006}, 0.2);
    QVERIFY(std::abs(hand.now.hold.norm() - most) < 1e-12);
    QVERIFY(hand.now.hold.x() < 0.0);
    hand.at(toolAt(
        {0.010, 0.0, -0.006})); // lets go: the jaw stands at 0, which squeezes more, so open it instead
    hand.at({0.010, 0.0, -0.006}, kOpen_rad);
    QCOMPARE(hand.now.hold, Vec3(Vec3::Zero()));
}

// With jaws that stand still the work of the hand never falls behind what is held by more than a microjoule.
void TestTissuePinch::theHoldMakesNoEnergy() {
    core::Random random(31);
    double worst = 0.0;
    for (int loop = 0; loop < 60; ++loop) {
        const TissueContact contact = contactOf(loop % 2 == 0 ? quietPad() : quietDome());
        Pincher hand{contact, {}, {}, {}, {}, {}};
        const Vec3 start =
            under(contact, Vec2(random.uniform(-0.02, 0.02), random.uniform(-0.02, 0.02)), 0.006);
        hand.squeeze(start, random.uniform(0.0, 0.5));
        const double jaw = 0.3;
        hand.at(start, jaw);
        double work = 0.0;
        Vec3 p = start, force = hand.now.hold;
        const double rest = hand.now.energy_J;
        Vec3 goal = start;
        for (int n = 0; n < 4000; ++n) {
            if (n % 200 == 0)
                goal = n < 3800 ? under(contact,
                                        Vec2(start.head<2>() + Vec2(random.uniform(-0.008, 0.008),
                                                                    random.uniform(-0.008, 0.008))),
                                        random.uniform(0.002, 0.009))
                                : start;
            const Vec3 next = p + 0.02 * (goal - p);
            const PinchResponse out = hand.at(next, jaw);
            work -= 0.5 * (force + out.hold).dot(next - p);
            force = out.hold;
            p = next;
            worst = std::min(worst, work - (out.energy_J - rest));
        }
    }
    QVERIFY2(worst > -1e-6, qPrintable(QString::number(1e6 * worst) + " uJ"));
}

// A hand at up to 0.3 m/s and 3 rad/s whose jaw opens and closes at 4 rad/s, through, over and below the
// tissue.
void TestTissuePinch::nothingJumpsWhereverTheJawCloses() {
    core::Random random(32);
    double most = 0.0, overSqueeze = 0.0, overHold = 0.0;
    int squeezed = 0;
    for (int path = 0; path < 60; ++path) {
        const TissueContact contact = contactOf(path % 2 == 0 ? quietPad() : quietDome());
        Pincher hand{contact, {}, {}, {}, {}, {}};
        Vec3 p(0.0, 0.0, 0.03), goal = p;
        core::Quat turn = core::Quat::Identity(), wanted = turn;
        double jaw = 1.2, wantedJaw = jaw;
        PinchResponse before = hand.at(p, jaw, turn);
        for (int n = 0; n < 4000; ++n) {
            if (n % 150 == 0)
                goal = Vec3(random.uniform(-0.03, 0.03), random.uniform(-0.03, 0.03),
                            random.uniform(-0.02, 0.02));
            if (n % 250 == 0)
                wantedJaw = random.below(2) == 0 ? 0.0 : random.uniform(0.3, 1.6);
            if (n % 300 == 0)
                wanted = core::Quat(Eigen::AngleAxisd(random.uniform(0.0, 1.5), randomUnit(random)));
            const Vec3 way = goal - p;
            const Vec3 step = way.norm() > 0.0003 ? Vec3(way * (0.0003 / way.norm())) : way;
            p += step;
            const double angle = turn.angularDistance(wanted);
            turn = angle > 0.003 ? turn.slerp(0.003 / angle, wanted) : wanted;
            jaw += std::clamp(wantedJaw - jaw, -0.004, 0.004);
            const PinchResponse now = hand.at(p, jaw, turn);
            QVERIFY(std::isfinite(now.force_N) && now.force_N >= 0.0 && now.hold.allFinite());
            QVERIFY(now.hold.norm() <= 2.0 * hand.parameters.friction * now.force_N + 1e-12);
            const double steep = std::max(now.squeezeStiffness_N_per_m, before.squeezeStiffness_N_per_m);
            // By itself the jaw moves its faces by 40 um a tick, and a turn of 3 mrad by as much again.
            const double byJaw = 0.5 * contact.normalStiffness_N_per_m() * 80e-6 * (1.0 + 6.0);
            overSqueeze = std::max(overSqueeze, std::abs(now.force_N - before.force_N) -
                                                    2.0 * steep * step.norm() - byJaw);
            overHold = std::max(
                overHold, (now.hold - before.hold).norm() -
                              2.0 * std::max(now.stiffness_N_per_m, before.stiffness_N_per_m) * step.norm() -
                              2.0 * hand.parameters.friction * byJaw);
            most = std::max(most, now.force_N);
            squeezed += now.force_N > 0.5 ? 1 : 0;
            before = now;
        }
    }
    qInfo("squeezed in %d ticks, up to %.1f N; over the bound %.3f N, the hold %.3f N", squeezed, most,
          overSqueeze, overHold);
    QVERIFY(squeezed > 5000 && most > 2.0);
    QVERIFY2(overSqueeze <= 0.02 && overHold <= 0.02,
             qPrintable(QString("%1 %2").arg(overSqueeze).arg(overHold)));
}

void TestTissuePinch::whatIsNoPoseSqueezesNothing() {
    const TissueContact contact = contactOf(quietPad());
    Pincher hand{contact, {}, {}, {}, {}, {}};
    hand.squeeze({0.0, 0.0, -0.005}, 0.2);
    QCOMPARE(hand.at({0.0, 0.0, -0.005}, std::nan("")).force_N, 0.0);
    QCOMPARE(hand.at({0.0, 0.0, std::nan("")}, 0.2).force_N, 0.0);
    QVERIFY(std::isfinite(hand.at({0.0, 0.0, -0.005}, 1e300).force_N));
    QVERIFY(std::isfinite(hand.at({0.0, 0.0, -0.005}, -1e300).force_N));
    QVERIFY(std::isfinite(hand.at({0.0, 0.0, -3.0}, 0.1).force_N)); // as deep as a room
    // Jaws that lie along the normal squeeze too.
    const core::Quat along(Eigen::AngleAxisd(0.5 * core::kPi, Vec3::UnitY()));
    hand.pinched.release();
    hand.at({0.0, 0.0, -0.005}, kOpen_rad, along);
    QVERIFY(std::isfinite(hand.at({0.0, 0.0, -0.005}, 0.2, along).force_N));
}

// Nobody had opened a jaw before: with it closed every force is what it was, bit for bit.
void TestTissuePinch::closedJawsChangeNoBitOfTheExercise() {
    PalpationParameters with = pinchedPad(), without = with;
    without.pinch.reset();
    PalpationDriver a(with), b(without);
    core::Random random(33);
    a.startRunning();
    b.startRunning();
    for (int n = 0; n < 3000; ++n) {
        const double t = 1e-3 * n;
        for (PalpationDriver* d : {&a, &b})
            d->at(0, 0.02 * std::sin(2.0 * t), 0.02 * std::cos(1.3 * t), 0.004 * std::cos(7.0 * t));
        a.tick();
        b.tick();
        QVERIFY(a.force() == b.force() && a.out.display[0].normalForce_N == b.out.display[0].normalForce_N);
        QVERIFY(a.out.storedEnergy_J == b.out.storedEnergy_J &&
                a.out.contactStiffness_N_per_m == b.out.contactStiffness_N_per_m &&
                a.out.contact[0] == b.out.contact[0]);
        QCOMPARE(a.out.quantities[q::kSqueeze], 0.0);
    }
}

void TestTissuePinch::thePadFeelsIt() {
    PalpationDriver d(pinchedPad());
    begin(d);
    d.at(0, 0.030, 0.030, -0.004);
    d.ticks(20);
    const double pressed = d.out.display[0].normalForce_N;
    QCOMPARE(d.out.quantities[q::kSqueeze], 0.0);
    d.in.tools.tools[0].jaw_rad = 0.6;
    d.tick();
    const double squeeze = d.out.quantities[q::kSqueeze];
    QVERIFY2(squeeze > 1.0, qPrintable(QString::number(squeeze)));
    QVERIFY(std::abs(d.out.display[0].normalForce_N - pressed - squeeze) < 1e-12);
    QCOMPARE(d.out.cues.exercise.of<simulation::PalpationCues>().squeeze_N[0], squeeze);
    QVERIFY(d.out.cues.exercise.of<simulation::PalpationCues>().squeezeShown);
    d.at(0, 0.030, 0.030, 0.010); // out of it
    d.tick();
    QCOMPARE(d.out.quantities[q::kSqueeze], 0.0);
    QCOMPARE(d.out.display[0].normalForce_N, 0.0);
}

void TestTissuePinch::eachHandHasOneJaw() {
    PalpationParameters p = pinchedPad();
    p.hands = p.fingers = 2;
    PalpationDriver d(p);
    d.startRunning();
    for (int finger = 0; finger < 4; ++finger) {
        d.at(finger, 0.014 * finger - 0.02, 0.02, -0.004);
        d.in.tools.tools[static_cast<std::size_t>(finger)].jaw_rad = kOpen_rad;
    }
    d.ticks(5);
    std::array<double, 4> pressed{};
    for (std::size_t i = 0; i < 4; ++i) {
        pressed[i] = d.out.display[i].normalForce_N;
        d.in.tools.tools[i].jaw_rad = i < 2 ? 0.6 : 0.5; // both fingers of a hand report one lever
    }
    d.tick();
    QVERIFY(d.out.quantities[q::kSqueeze] > 0.5 &&
            d.out.quantities[q::kSqueeze + 1] > d.out.quantities[q::kSqueeze]);
    QVERIFY(d.out.display[0].normalForce_N > pressed[0] + 0.5 &&
            d.out.display[2].normalForce_N > pressed[2] + 0.5);
    QVERIFY(std::abs(d.out.display[1].normalForce_N - pressed[1]) < 1e-9 &&
            std::abs(d.out.display[3].normalForce_N - pressed[3]) < 1e-9);
}

// Beyond the level's yield force the tissue between the jaws tears: told once, gone in the level's time,
// whole again once the jaws are open.
void TestTissuePinch::pinchedTooHardItTears() {
    PalpationParameters p = pinchedPad();
    p.yield.force_N = 4.0;
    p.maximumForce_N = 3.0;
    PalpationDriver d(p);
    begin(d);
    d.at(0, 0.030, 0.030, -0.004);
    d.ticks(5);
    int yielded = 0, toTorn = -1;
    double most = 0.0, steepest = 0.0, before = 0.0;
    for (int n = 0; n < 400; ++n) {
        d.in.tools.tools[0].jaw_rad = std::max(0.0, kOpen_rad - 0.004 * n);
        d.tick();
        const double now = d.out.quantities[q::kSqueeze];
        yielded += (d.out.contact[0] & core::contact_bits::kYielded) != 0 ? 1 : 0;
        most = std::max(most, now);
        steepest = std::max(steepest, std::abs(now - before));
        before = now;
        if (toTorn < 0 && (d.out.contact[0] & core::contact_bits::kThrough) != 0)
            toTorn = n;
    }
    QCOMPARE(yielded, 1);
    QVERIFY2(most <= 4.0 && most > 3.8, qPrintable(QString::number(most)));
    QCOMPARE(before, 0.0);
    QVERIFY2(steepest <= 1.5 * 4.0 / 20.0 + 0.1, qPrintable(QString::number(steepest)));
    d.in.tools.tools[0].jaw_rad = 1.4; // wide open: something else comes between
    d.tick();
    QCOMPARE(d.out.contact[0] & core::contact_bits::kThrough, 0);
    d.in.tools.tools[0].jaw_rad = 1.3;
    d.tick();
    QVERIFY(d.out.quantities[q::kSqueeze] > 0.1);
}

void TestTissuePinch::withoutForceNothingIsSqueezed() {
    PalpationParameters p = pinchedPad();
    p.control.forceOff = true;
    PalpationDriver d(p);
    begin(d);
    d.at(0, 0.0, 0.0, -0.004);
    d.ticks(5);
    d.in.tools.tools[0].jaw_rad = 0.2;
    d.ticks(5);
    QCOMPARE(d.out.quantities[q::kSqueeze], 0.0);
    QCOMPARE(d.out.display[0].normalForce_N, 0.0);
}

QTEST_APPLESS_MAIN(TestTissuePinch)
#include "test_tissue_pinch.moc"
