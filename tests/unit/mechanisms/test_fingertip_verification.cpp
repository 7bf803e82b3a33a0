// SPDX-License-Identifier: GPL-3.0-or-later
// P3 §3 on the simulated platform, beside P3's own figures.
#include "mechanisms/fingertip_pad_identification.h"
#include "mechanisms/fingertip_verification.h"
#include "unit/mechanisms/fingertip_most.h"

#include <QtTest>
#include <cmath>

using namespace chiron;
using mechanisms::FingertipPlatformParameters;
using mechanisms::FingertipPublished;
using mechanisms::FingertipVerificationSettings;
using mechanisms::verifyFingertip;

class TestFingertipVerification : public QObject {
    Q_OBJECT
private slots:
    void isBetterThanPublished();
    void everyFigureHasItsBound();
    void holdsOnOtherFingers();
    void sevenOtherFingersDiffer();
    void fourNewtonsAreNeverExceeded();
    void thePadIsIdentified();
    void figuresAreThoseOfTheSeries();
    void sameSeedSameFigures();
    void aWorsePlantDoesNotHold();
    void frictionIsFound();
    void stiffnessCapIsThatOfTheModels();
    void badSettingsAreRefused();
};

void TestFingertipVerification::isBetterThanPublished() {
    for (const std::uint64_t seed : {1u, 2u, 3u}) {
        const auto v = verifyFingertip({}, seed);
        QVERIFY(v.has_value());
        qInfo("seed %llu: RMSE %.4f %.4f %.4f, mean %.4f N (P3 %.4f), on the pad %.4f N; angle %.2f ± %.2f "
              "deg (P3 %.2f ± %.1f), truly %.2f; latency %.1f ms",
              static_cast<unsigned long long>(seed), v->rmse_N[0], v->rmse_N[1], v->rmse_N[2], v->meanRmse_N,
              FingertipPublished::kMeanRmse_N, v->meanRmseTrue_N, v->meanError_deg, v->sdError_deg,
              FingertipPublished::kMeanError_deg, FingertipPublished::kSdError_deg, v->meanErrorTrue_deg,
              1e3 * v->latency_s);
        QVERIFY(v->holds());
        for (std::size_t cycle = 0; cycle < 3; ++cycle)
            QVERIFY(v->rmse_N[cycle] < FingertipPublished::kRmse_N[cycle]);
        QVERIFY(v->meanRmseTrue_N < FingertipPublished::kMeanRmse_N &&
                v->meanErrorTrue_deg < FingertipPublished::kMeanError_deg);
        QVERIFY(v->sdError_deg < FingertipPublished::kSdError_deg);
        QVERIFY(v->meanRmse_N > 0.004 &&
                v->meanError_deg > 0.1); // honest noise: no figure below what a count can do
        QVERIFY(v->latency_s > 0.0 && v->latency_s < 0.05);
    }
}

/// P3's 0.0707 N and 1.95° are bettered, by the device's sensors and truly, with a tenth of overshoot and 4 N
/// at most: each figure decides alone, whatever the others are.
void TestFingertipVerification::everyFigureHasItsBound() {
    using V = mechanisms::FingertipVerification;
    struct Figure {
        double V::*figure;
        double within, beyond;
    };
    const Figure figures[] = {{&V::meanRmse_N, 0.0706, 0.0707},    {&V::meanRmseTrue_N, 0.0706, 0.0707},
                              {&V::meanError_deg, 1.94, 1.95},     {&V::meanErrorTrue_deg, 1.94, 1.95},
                              {&V::overshootOfForce, 0.10, 0.101}, {&V::largest_N, 4.0, 4.001}};
    V most;
    for (const Figure& one : figures)
        most.*one.figure = one.within;
    QVERIFY(most.holds());
    for (const Figure& one : figures)
        for (const double value : {one.beyond, std::nan("")}) {
            V v = most;
            v.*one.figure = value;
            QVERIFY2(!v.holds(), qPrintable(QString::number(value)));
        }
}

// Judged on what the pad truly got, on fingers that the platform knows by its own sensors alone. All of them,
// with several seeds: test_fingertip_fingers.
void TestFingertipVerification::holdsOnOtherFingers() {
    FingertipVerificationSettings s;
    s.poses = 10;
    for (const auto& [name, pad] : mechanisms::otherFingers({})) {
        if (name != "softest" && name != "stiffest")
            continue;
        FingertipPlatformParameters on;
        on.pad = pad;
        const auto v = verifyFingertip(on, 11, s);
        QVERIFY(v.has_value());
        QVERIFY2(v->holds() && v->largest_N > 3.3 && v->oneNewton_N < 1.15,
                 qPrintable(QString("%1: RMSE %2 N, overshoot %3 of the force; 1 N: %4 N, 4 N: %5 N")
                                .arg(QString::fromStdString(name))
                                .arg(v->meanRmseTrue_N)
                                .arg(v->overshootOfForce)
                                .arg(v->oneNewton_N)
                                .arg(v->largest_N)));
    }
    s.feedback = false; // the same must not hold without the force loop
    QVERIFY(!verifyFingertip({}, 11, s).value().holds());
    QVERIFY(!mechanisms::holdsOnAll({}));
}

void TestFingertipVerification::sevenOtherFingersDiffer() {
    const mechanisms::FingerPad assumed(mechanisms::FingerPadParameters{});
    const auto fingers = mechanisms::otherFingers({});
    QCOMPARE(fingers.size(), std::size_t(7));
    double least = 1e9, most = 0.0; // force where the one that is assumed gives 1 N
    for (const auto& finger : fingers) {
        const double force =
            mechanisms::FingerPad(finger.pad).elasticForce(assumed.depthOf(1.0) - finger.pad.surface_m);
        least = std::min(least, force);
        most = std::max(most, force);
    }
    QVERIFY2(least < 0.7 && most > 1.8, qPrintable(QString("%1 %2 N").arg(least).arg(most)));
}

// Whatever is asked, also far beyond the limit, of fingers that were identified; and of one twice as stiff
// that was not.
void TestFingertipVerification::fourNewtonsAreNeverExceeded() {
    for (const double stiffness : {0.5, 1.0, 2.0}) {
        for (const bool identified : {true, false}) {
            FingertipPlatformParameters p;
            p.pad.stiffness_N_per_m *= stiffness;
            if (identified)
                p = mechanisms::worn(p, 31).value();
            const double most = mechanisms::tests::mostOf(p, 31);
            QVERIFY2(
                most > 3.2 && most <= 4.0,
                qPrintable(QString("stiffness x %1, %2: %3 N").arg(stiffness).arg(identified).arg(most)));
        }
    }
}

void TestFingertipVerification::thePadIsIdentified() {
    const mechanisms::FingerPadParameters nominal;
    for (const double stiffness : {0.5, 1.0, 2.0}) {
        FingertipPlatformParameters p;
        p.pad.stiffness_N_per_m *= stiffness;
        p.pad.surface_m = -0.0007;
        const auto found = mechanisms::identifyPad(p, 3);
        QVERIFY(found.has_value());
        const mechanisms::FingerPad real(p.pad), known(*found);
        for (const double force :
             {0.5, 1.0, 2.0, 3.0}) { // where the real one gives it, the identified one does within a tenth
            const double there = known.elasticForce(real.depthOf(force) + p.pad.surface_m - found->surface_m);
            QVERIFY2(std::abs(there / force - 1.0) < 0.1,
                     qPrintable(QString("x %1, %2 N: %3").arg(stiffness).arg(force).arg(there)));
        }
    }
    FingertipPlatformParameters nobody; // a finger beyond the travel
    nobody.pad.surface_m = 0.02;
    const auto none = mechanisms::identifyPad(nobody, 1);
    QVERIFY(!none && none.error().code == core::ErrorCode::badInput &&
            none.error().message.find("no finger") != std::string::npos);
    QVERIFY(!mechanisms::fitPad({}, 2.0, nominal).has_value());
    std::vector<mechanisms::PadReading> exact; // without noise it is found to the last digits
    for (int n = 1; n < 100; ++n)
        exact.push_back({0.0002 + 1e-5 * n, mechanisms::FingerPad(nominal).elasticForce(1e-5 * n)});
    const auto fitted = mechanisms::fitPad(exact, 2.0, nominal);
    QVERIFY(fitted.has_value());
    QVERIFY(std::abs(fitted->stiffness_N_per_m / nominal.stiffness_N_per_m - 1.0) < 1e-4 &&
            std::abs(fitted->surface_m - 0.0002) < 1e-7);
}

void TestFingertipVerification::figuresAreThoseOfTheSeries() {
    FingertipVerificationSettings s;
    s.poses = 7;
    s.frequency_Hz = 1.0;
    const auto v = verifyFingertip({}, 4, s);
    QVERIFY(v.has_value());
    QCOMPARE(v->series.time_s.size(), std::size_t(3000));
    double sum2 = 0.0, largest = 0.0;
    for (std::size_t i = 1000; i < 2000; ++i) {
        const double e = v->series.reference_N[i] - v->series.measured_N[i];
        sum2 += e * e;
        largest = std::max(largest, v->series.reference_N[i]);
    }
    QVERIFY(std::abs(std::sqrt(sum2 / 1000.0) - v->rmse_N[1]) < 1e-12);
    QVERIFY(std::abs(largest - 1.0) < 1e-9);
    QVERIFY(std::abs((v->rmse_N[0] + v->rmse_N[1] + v->rmse_N[2]) / 3.0 - v->meanRmse_N) < 1e-12);
    QCOMPARE(v->poses.size(), std::size_t(7)); // N_s terms, not one more
    double sum = 0.0;
    for (const auto& pose : v->poses) {
        QVERIFY(std::abs(pose.referencePitch_rad) <= core::radFromDeg(30.0) &&
                std::abs(pose.referenceRoll_rad) <= core::radFromDeg(20.0));
        sum += core::degFromRad(std::hypot(pose.referencePitch_rad - pose.measuredPitch_rad,
                                           pose.referenceRoll_rad - pose.measuredRoll_rad));
    }
    QVERIFY(std::abs(sum / 7.0 - v->meanError_deg) < 1e-12);
}

void TestFingertipVerification::sameSeedSameFigures() {
    FingertipVerificationSettings s;
    s.poses = 5;
    const auto a = verifyFingertip({}, 9, s), b = verifyFingertip({}, 9, s), c = verifyFingertip({}, 10, s);
    QVERIFY(a->meanRmse_N == b->meanRmse_N && a->meanError_deg == b->meanError_deg &&
            a->latency_s == b->latency_s);
    QVERIFY(a->meanRmse_N != c->meanRmse_N && a->meanError_deg != c->meanError_deg);
}

void TestFingertipVerification::aWorsePlantDoesNotHold() {
    FingertipVerificationSettings s;
    s.poses = 20;
    FingertipPlatformParameters
        weak; // motors that cannot give 1 N through their friction: the finger is not even identified
    weak.drive.forceLimit_N = 0.3;
    const auto tooWeak = verifyFingertip(weak, 1, s);
    QVERIFY(!tooWeak && tooWeak.error().code == core::ErrorCode::badInput);
    QVERIFY2(tooWeak.error().message.find("motors") != std::string::npos, tooWeak.error().message.c_str());
    FingertipPlatformParameters crooked; // an IMU mounted some 5° askew
    crooked.imu.bias_rad = 0.2;
    QVERIFY(!verifyFingertip(crooked, 1, s).value().holds());
    // The converter alone: the finger keeps still, whose movement would hide it. At 7 bits (0.03 N a count)
    // the sensors' own figure is twice as bad; at 5 (0.13 N) a finger cannot be told from its readings, and
    // nothing is displayed on it.
    s.fingerMoves_m = 0.0;
    s.poses = 1;
    for (const std::uint64_t seed : {1u, 2u}) {
        FingertipPlatformParameters coarse;
        coarse.force.adcBits = 7;
        const double fine_N = verifyFingertip({}, seed, s).value().meanRmse_N,
                     coarse_N = verifyFingertip(coarse, seed, s).value().meanRmse_N;
        QVERIFY2(coarse_N > 2.0 * fine_N,
                 qPrintable(QString("seed %1: %2, %3 N").arg(seed).arg(fine_N).arg(coarse_N)));
        coarse.force.adcBits = 5;
        const auto refused = verifyFingertip(coarse, seed, s);
        QVERIFY(!refused && refused.error().code == core::ErrorCode::badInput);
    }
}

void TestFingertipVerification::frictionIsFound() {
    for (const double factor : {1.0, 2.0}) {
        FingertipPlatformParameters p;
        p.drive.friction.coulomb *= factor;
        const auto found = mechanisms::identifyFingertipFriction(p);
        QVERIFY2(std::abs(found.coulomb_N / p.drive.friction.coulomb - 1.0) < 0.05,
                 qPrintable(QString::number(found.coulomb_N)));
        QVERIFY2(std::abs(found.viscous_Ns_per_m / p.drive.friction.viscous - 1.0) < 0.1,
                 qPrintable(QString::number(found.viscous_Ns_per_m)));
    }
}

// devices.md §6: at b = 2 N·s/m 4,000 N/m without delay, 800 at 2 ms.
void TestFingertipVerification::stiffnessCapIsThatOfTheModels() {
    QVERIFY(std::abs(mechanisms::stiffnessCap_N_per_m(2.0, 0.001, 0.0) - 4000.0) < 1e-9);
    QVERIFY(std::abs(mechanisms::stiffnessCap_N_per_m(2.0, 0.001, 0.002) - 800.0) < 1e-9);
}

void TestFingertipVerification::badSettingsAreRefused() {
    const auto refused = [](auto change) {
        FingertipVerificationSettings s;
        change(s);
        const auto v = verifyFingertip({}, 1, s);
        return !v && v.error().code == core::ErrorCode::badInput;
    };
    QVERIFY(refused([](auto& s) { s.frequency_Hz = 0.0; }));
    QVERIFY(refused([](auto& s) { s.frequency_Hz = std::nan(""); }));
    QVERIFY(refused([](auto& s) { s.peak_N = 4.1; }));
    QVERIFY(refused([](auto& s) { s.poses = 0; }));
    QVERIFY(refused([](auto& s) { s.settle_s = 0.0; }));
    QVERIFY(refused([](auto& s) { s.fingerMoves_m = -0.0001; }));
    QVERIFY(refused([](auto& s) { s.fingerMoves_m = 0.0011; }));
}

QTEST_APPLESS_MAIN(TestFingertipVerification)
#include "test_fingertip_verification.moc"
