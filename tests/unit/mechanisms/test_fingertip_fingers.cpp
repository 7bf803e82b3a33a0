// SPDX-License-Identifier: GPL-3.0-or-later
// The fingertip platform on all the simulated fingers, with several seeds (CHIRON_SOAK times as many), judged
// on what the pad truly got.
#include "mechanisms/fingertip_pad_identification.h"
#include "mechanisms/fingertip_verification.h"
#include "unit/mechanisms/fingertip_most.h"

#include <QtTest>
#include <cmath>

using namespace chiron;
using mechanisms::FingertipPlatformParameters;
using mechanisms::FingertipVerification;
using mechanisms::FingertipVerificationSettings;

namespace {

int soak() {
    return std::max(1, qEnvironmentVariableIntValue("CHIRON_SOAK"));
}

QString told(std::uint64_t seed, const std::string& finger, const FingertipVerification& v) {
    return QString("seed %1, %2: RMSE %3 N, gain %4, phase %5 deg, angle %6 deg, overshoot %7 of the step, "
                   "%8 of the force; 1 N: %9 N, 4 N: ")
               .arg(seed)
               .arg(QString::fromStdString(finger))
               .arg(v.meanRmseTrue_N)
               .arg(v.gain)
               .arg(v.phase_deg)
               .arg(v.meanErrorTrue_deg)
               .arg(v.overshoot)
               .arg(v.overshootOfForce)
               .arg(v.oneNewton_N) +
           QString::number(v.largest_N);
}

} // namespace

class TestFingertipFingers : public QObject {
    Q_OBJECT
private slots:
    void holdsOnEveryFinger();
    void withoutFeedbackItHoldsOnNone();
    void fourNewtonsAreNeverExceeded();
};

void TestFingertipFingers::holdsOnEveryFinger() {
    FingertipVerificationSettings s;
    s.poses = 10;
    for (int n = 0; n < 5 * soak(); ++n) {
        const std::uint64_t seed = 1000 + static_cast<std::uint64_t>(n);
        auto fingers = mechanisms::verifyFingertipOnFingers({}, seed, s);
        QVERIFY(fingers.has_value());
        QCOMPARE(fingers->size(), std::size_t(7));
        QVERIFY(mechanisms::holdsOnAll(*fingers));
        fingers->push_back({"assumed", mechanisms::verifyFingertip({}, seed, s).value()});
        for (const auto& [name, v] : *fingers) {
            QVERIFY2(v.holds() && v.largest_N > 3.3 && v.oneNewton_N < 1.15, qPrintable(told(seed, name, v)));
            QVERIFY2(std::abs(v.gain - 1.0) < 0.08 && std::abs(v.phase_deg) < 5.0 && v.staticError < 0.1,
                     qPrintable(told(seed, name, v)));
        }
    }
}

void TestFingertipFingers::withoutFeedbackItHoldsOnNone() {
    FingertipVerificationSettings s;
    s.poses = 2;
    s.feedback = false;
    for (const std::uint64_t seed : {21u, 22u}) {
        QVERIFY(!mechanisms::verifyFingertip({}, seed, s).value().holds());
        const auto fingers = mechanisms::verifyFingertipOnFingers({}, seed, s);
        QVERIFY(fingers.has_value());
        for (const auto& [name, v] : *fingers)
            QVERIFY2(!v.holds(), qPrintable(told(seed, name, v)));
    }
}

// Of fingers that were identified, and of one twice as stiff that was not.
void TestFingertipFingers::fourNewtonsAreNeverExceeded() {
    for (int n = 0; n < 20 * soak(); ++n) {
        const std::uint64_t seed =
            n < 3 ? 31 + static_cast<std::uint64_t>(n) : 2000 + static_cast<std::uint64_t>(n);
        for (const double stiffness : {0.5, 1.0, 2.0}) {
            for (const bool identified : {true, false}) {
                FingertipPlatformParameters p;
                p.pad.stiffness_N_per_m *= stiffness;
                if (identified)
                    p = mechanisms::worn(p, seed).value();
                const double most = mechanisms::tests::mostOf(p, seed);
                QVERIFY2(most > 3.2 && most <= 4.0, qPrintable(QString("seed %1, stiffness x %2, %3: %4 N")
                                                                   .arg(seed)
                                                                   .arg(stiffness)
                                                                   .arg(identified)
                                                                   .arg(most)));
            }
        }
    }
}

QTEST_APPLESS_MAIN(TestFingertipFingers)
#include "test_fingertip_fingers.moc"
