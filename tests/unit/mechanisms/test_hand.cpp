// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/units.h"
#include "mechanisms/gimbal_plant.h"
#include "mechanisms/hand.h"
#include "mechanisms/scripted_motion.h"

#include <QtTest>
#include <algorithm>
#include <cmath>
#include <vector>

using namespace chiron;
using core::Vec3;
using mechanisms::GimbalPlant;
using mechanisms::GimbalPlantParameters;
using mechanisms::GimbalVector;
using mechanisms::Hand;
using mechanisms::HandIntention;
using mechanisms::HandParameters;

class TestHand : public QObject {
    Q_OBJECT
private slots:
    void reactionDelaysTheIntentionOnly();
    void tremorHasItsRmsAndBand();
    void wallsAreStable_data();
    void wallsAreStable();
    void scriptedMotionIsSmooth();
};

namespace {

HandIntention goTo(const Vec3& p) {
    HandIntention wanted;
    wanted.p_DDesired = p;
    return wanted;
}

/// Device of models.md §4 and a hand, against a wall of stiffness K at z = 0, force sampled and one tick
/// late.
struct WallLoop {
    GimbalPlant plant;
    Hand hand;
    double stiffness;
    double lateForce = 0.0;

    WallLoop(const HandParameters& arm, double k) : plant(device()), hand(arm, 1, 0.15), stiffness(k) {
        plant.reset({0.0, 0.0, 0.0, 0.18});
        hand.reset(Vec3::Zero());
    }
    static GimbalPlantParameters device() {
        GimbalPlantParameters p;
        for (auto& friction : p.friction)
            friction.coulomb = 0.0; // the claim is for 0.15 kg and 0.5 N·s/m alone
        p.currentLimit_A = 100.0;   // nor may saturation calm it
        return p;
    }
    double tick(const Vec3& desired) { ///< returns the tip's height
        const double z = 0.18 - plant.counts()[3] * plant.parameters().resolution[3];
        const double now = std::max(0.0, -stiffness * z);
        plant.beginTick(GimbalVector(0.0, 0.0, 0.0, -lateForce), true);
        lateForce = now;
        hand.beginTick(goTo(desired));
        const double dt = core::kTickSeconds / 4;
        for (int i = 0; i < 4; ++i) {
            const Vec3 grip = hand.gripForceOnTool(plant.p_DT(), plant.v_DT());
            plant.integrate(dt, grip);
            hand.integrate(dt, grip);
        }
        plant.endTick();
        return plant.p_DT().z();
    }
};

/// Peak to peak of the tip in the last second of ten, pressing 8 mm below the surface of the wall.
double residualOscillation(HandParameters arm, double stiffness) {
    arm.tremorRms_m = 0.0;
    WallLoop loop(arm, stiffness);
    double low = 1.0, high = -1.0;
    for (int i = 0; i < 10000; ++i) {
        const double z = loop.tick(Vec3(0.0, 0.0, -0.008));
        if (i >= 9000) {
            low = std::min(low, z);
            high = std::max(high, z);
        }
    }
    return high - low;
}

} // namespace

void TestHand::reactionDelaysTheIntentionOnly() {
    HandParameters arm;
    arm.tremorRms_m = 0.0;
    Hand hand(arm, 1, 0.15);
    hand.reset(Vec3::Zero());
    const Vec3 goal(0.01, 0.0, 0.0);
    for (int tick = 0; tick <= 200; ++tick) {
        HandIntention wanted = goTo(goal);
        wanted.buttons = 1;
        hand.beginTick(wanted);
        QCOMPARE(hand.acting().buttons, tick >= 180 ? 1u : 0u);
        QCOMPARE(hand.acting().p_DDesired.x(), tick >= 180 ? 0.01 : 0.0);
    }
    // A push moves the arm in the very next step.
    Hand pushed(arm, 1, 0.15);
    pushed.reset(Vec3::Zero());
    pushed.beginTick(goTo(Vec3::Zero()));
    pushed.integrate(0.00025, Vec3(0.0, 0.0, -1.0));
    QVERIFY(pushed.p_D().z() > 0.0);
}

void TestHand::tremorHasItsRmsAndBand() {
    HandParameters arm;
    Hand hand(arm, 7, 0.0);
    hand.reset(Vec3::Zero());
    std::vector<double> x;
    for (int tick = 0; tick < 40000; ++tick) {
        hand.beginTick(goTo(Vec3::Zero()));
        for (int i = 0; i < 4; ++i)
            hand.integrate(0.00025, Vec3::Zero());
        if (tick >= 2000)
            x.push_back(hand.p_D().x());
    }
    double sum = 0.0;
    for (double value : x)
        sum += value * value;
    const double rms = std::sqrt(sum / static_cast<double>(x.size()));
    // Semi-implicit Euler at 4 kHz follows 10 Hz within a few per cent.
    QVERIFY2(std::abs(rms - 0.1e-3) < 0.01e-3, qPrintable(QString::number(rms)));
    const auto power =
        [&](double frequency) { // of one frequency, averaged over eight half-overlapping windows
            double total = 0.0;
            for (std::size_t start = 0; start + 8000 <= x.size(); start += 4000) {
                double re = 0.0, im = 0.0;
                for (std::size_t i = 0; i < 8000; ++i) {
                    const double window =
                        0.5 - 0.5 * std::cos(2.0 * core::kPi * static_cast<double>(i) / 8000.0);
                    const double angle = 2.0 * core::kPi * frequency * static_cast<double>(i) * 1e-3;
                    re += window * x[start + i] * std::cos(angle);
                    im += window * x[start + i] * std::sin(angle);
                }
                total += re * re + im * im;
            }
            return total;
        };
    double inside = 0.0, outside = 0.0;
    for (double f = 0.25; f < 40.0; f += 0.125)
        (f >= 7.75 && f <= 12.25 ? inside : outside) += power(f);
    QVERIFY2(outside < 0.01 * inside, qPrintable(QString::number(outside / inside)));
}

void TestHand::wallsAreStable_data() {
    QTest::addColumn<QString>("arm");
    QTest::addColumn<double>("stiffness");
    QTest::addColumn<bool>("stable");
    for (double k : {500.0, 1000.0, 2000.0}) {
        QTest::addRow("default %g", k) << "default" << k << true;
        QTest::addRow("firm %g", k) << "firm" << k << true;
    }
    QTest::addRow("light 2000") << "light" << 2000.0 << true;
    QTest::addRow("light, rigid grip 1000") << "light, rigid grip" << 1000.0 << true;
    QTest::addRow("light, rigid grip 2000") << "light, rigid grip" << 2000.0 << false;
}

// models.md §4: with one tick of delay default and firm are stable on walls of 500–2000 N/m, light
// limit-cycles at 2000. The last holds only where the hand moves as one with the device (0.25 kg, 2.5 N·s/m:
// K < b/(T/2 + t_d) = 1670 N/m, devices.md §6). Through the grip of 2 kN/m and 10 N·s/m the light hand is
// stable at 2000 as well: the grip's own damping works on the device. Both are tested. Stable: what is left
// is the encoder's grid (25 µm a count).
void TestHand::wallsAreStable() {
    QFETCH(QString, arm);
    QFETCH(double, stiffness);
    QFETCH(bool, stable);
    HandParameters parameters;
    if (arm == "firm")
        parameters = HandParameters::firm();
    if (arm.startsWith("light"))
        parameters = HandParameters::light();
    if (arm.endsWith("rigid grip"))
        parameters.gripStiffness_N_per_m = 20000.0;
    const double left = residualOscillation(parameters, stiffness);
    qInfo("%s arm, %g N/m: %g um", qPrintable(arm), stiffness, 1e6 * left);
    QVERIFY2(stable ? left < 100e-6 : left > 500e-6, qPrintable(QString::number(left)));
}

void TestHand::scriptedMotionIsSmooth() {
    mechanisms::ScriptedMotion motion(Vec3(0.01, 0.0, 0.03),
                                      {{Vec3(0.02, 0.0, 0.0), 0.5, 0.0}, {Vec3(0.0, 0.01, 0.0), 1.25, 1.0}});
    mechanisms::HandPerception seen;
    for (int i = 0; i < 2000; ++i) {
        seen.time_s = i * 1e-3;
        const auto here = motion.decide(seen);
        seen.time_s += 1e-6;
        const auto next = motion.decide(seen);
        QVERIFY(((next.p_DDesired - here.p_DDesired) / 1e-6 - here.v_DDesired).norm() < 1e-5);
    }
}

QTEST_APPLESS_MAIN(TestHand)
#include "test_hand.moc"
