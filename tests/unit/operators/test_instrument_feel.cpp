// SPDX-License-Identifier: GPL-3.0-or-later
#include "operators/hand/instrument_feel.h"

#include "mechanisms/hand_parameters.h"

#include <QtTest>

#include <algorithm>
#include <cmath>

using namespace chiron;
using core::Vec3;

namespace {

constexpr double kTick_s = core::kTickSeconds;

} // namespace

class TestInstrumentFeel : public QObject {
    Q_OBJECT
private slots:
    /// The grip gives way by 0.15 mm, 30 times a second: its damper holds it back, and where the tip is
    /// cannot be had from its spring alone.
    void tipIsFoundBehindTheGrip() {
        const mechanisms::HandParameters hand = mechanisms::HandParameters::firm();
        operators::InstrumentFeel instrument(hand);
        const double omega = 2.0 * core::kPi * 30.0;
        double worst_m = 0.0, spring_m = 0.0;
        for (int i = 0; i < 2000; ++i) {
            const double t_s = i * kTick_s;
            const double yield_m = 0.15e-3 * std::sin(omega * t_s);
            const double force_N = hand.gripStiffness_N_per_m * yield_m +
                                   hand.gripDamping_Ns_per_m * 0.15e-3 * omega * std::cos(omega * t_s);
            const Vec3 p(0.0, 0.0, 0.004 * std::sin(5.0 * t_s));
            instrument.feel(p, Vec3(0.0, 0.0, force_N));
            if (i < 100)
                continue;
            worst_m = std::max(worst_m, std::abs(instrument.tip().z() - (p.z() + yield_m)));
            spring_m = std::max(spring_m, std::abs(force_N / hand.gripStiffness_N_per_m - yield_m));
        }
        QVERIFY2(worst_m < 20e-6, qPrintable(QString::number(worst_m)));
        QVERIFY(spring_m > 100e-6);
    }
    /// A stroke at one height moves the rod in and out of its port: friction along it turns in the middle of
    /// the stroke.
    void frictionAlongTheRodTurnsUnderThePort() {
        operators::InstrumentFeel instrument(mechanisms::HandParameters::firm());
        double before = 0.0, after = 0.0;
        for (int i = 0; i <= 160; ++i) { // from −8 to 8 mm at 0.1 m/s
            const double y_m = -0.008 + 1e-4 * i;
            instrument.feel(Vec3(0.0, y_m, 0.0), Vec3::Zero());
            (y_m < 0.0 ? before : after) = instrument.own()[2];
            if (i > 2)
                QVERIFY(std::abs(instrument.own()[4]) < 1e-6); // nothing moves up or down
        }
        QVERIFY2(before * after < 0.0 && std::abs(after) > 0.9,
                 qPrintable(QString("%1 %2").arg(before).arg(after)));
    }
};

QTEST_GUILESS_MAIN(TestInstrumentFeel)
#include "test_instrument_feel.moc"
