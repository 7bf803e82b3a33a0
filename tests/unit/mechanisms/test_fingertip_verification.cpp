// SPDX-License-Identifier: GPL-3.0-or-later
// P3 §3 on the simulated platform, beside P3's own figures.
#include "mechanisms/fingertip_verification.h"

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
        qInfo("seed %llu: RMSE %.4f %.4f %.4f, mean %.4f N (P3 %.4f), on the pad %.4f N; angle %.2f ± %.2f deg (P3 %.2f ± %.1f), truly %.2f; latency %.1f ms",
              static_cast<unsigned long long>(seed), v->rmse_N[0], v->rmse_N[1], v->rmse_N[2], v->meanRmse_N,
              FingertipPublished::kMeanRmse_N, v->meanRmseTrue_N, v->meanError_deg, v->sdError_deg, FingertipPublished::kMeanError_deg,
              FingertipPublished::kSdError_deg, v->meanErrorTrue_deg, 1e3 * v->latency_s);
        QVERIFY(v->holds());
        for (std::size_t cycle = 0; cycle < 3; ++cycle)
            QVERIFY(v->rmse_N[cycle] < FingertipPublished::kRmse_N[cycle]);
        QVERIFY(v->meanRmseTrue_N < FingertipPublished::kMeanRmse_N && v->meanErrorTrue_deg < FingertipPublished::kMeanError_deg);
        QVERIFY(v->sdError_deg < FingertipPublished::kSdError_deg);
        QVERIFY(v->meanRmse_N > 0.004 && v->meanError_deg > 0.1); // honest noise: no figure below what a count can do
        QVERIFY(v->latency_s > 0.0 && v->latency_s < 0.05);
    }
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
        QVERIFY(std::abs(pose.referencePitch_rad) <= core::radFromDeg(30.0) && std::abs(pose.referenceRoll_rad) <= core::radFromDeg(20.0));
        sum += core::degFromRad(std::hypot(pose.referencePitch_rad - pose.measuredPitch_rad, pose.referenceRoll_rad - pose.measuredRoll_rad));
    }
    QVERIFY(std::abs(sum / 7.0 - v->meanError_deg) < 1e-12);
}

void TestFingertipVerification::sameSeedSameFigures() {
    FingertipVerificationSettings s;
    s.poses = 5;
    const auto a = verifyFingertip({}, 9, s), b = verifyFingertip({}, 9, s), c = verifyFingertip({}, 10, s);
    QVERIFY(a->meanRmse_N == b->meanRmse_N && a->meanError_deg == b->meanError_deg && a->latency_s == b->latency_s);
    QVERIFY(a->meanRmse_N != c->meanRmse_N && a->meanError_deg != c->meanError_deg);
}

void TestFingertipVerification::aWorsePlantDoesNotHold() {
    FingertipVerificationSettings s;
    s.poses = 20;
    FingertipPlatformParameters weak; // motors that cannot give 1 N through their friction
    weak.drive.forceLimit_N = 0.3;
    QVERIFY(!verifyFingertip(weak, 1, s)->holds());
    FingertipPlatformParameters crooked; // an IMU mounted 4° askew
    crooked.imu.bias_rad = 0.07;
    QVERIFY(!verifyFingertip(crooked, 1, s)->holds());
    FingertipPlatformParameters coarse; // 5 bits: 0.13 N a count
    coarse.force.adcBits = 5;
    QVERIFY(verifyFingertip(coarse, 1, s)->meanRmse_N > 2.0 * verifyFingertip({}, 1, s)->meanRmse_N);
}

void TestFingertipVerification::frictionIsFound() {
    for (const double factor : {1.0, 2.0}) {
        FingertipPlatformParameters p;
        p.drive.friction.coulomb *= factor;
        const auto found = mechanisms::identifyFingertipFriction(p);
        QVERIFY2(std::abs(found.coulomb_N / p.drive.friction.coulomb - 1.0) < 0.05, qPrintable(QString::number(found.coulomb_N)));
        QVERIFY2(std::abs(found.viscous_Ns_per_m / p.drive.friction.viscous - 1.0) < 0.1, qPrintable(QString::number(found.viscous_Ns_per_m)));
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
}

QTEST_APPLESS_MAIN(TestFingertipVerification)
#include "test_fingertip_verification.moc"
