// SPDX-License-Identifier: GPL-3.0-or-later
#include "mechanisms/attitude_sensor.h"
#include "mechanisms/fingertip_platform.h"

#include <QtTest>
#include <cmath>
#include <set>

using namespace chiron;
using core::DisplayPose;
using core::Vec3;
using mechanisms::FingerPadParameters;
using mechanisms::FingertipForceSensors;
using mechanisms::FingertipPlant;
using mechanisms::FingertipPlatform;
using mechanisms::FingertipPlatformParameters;

namespace {

struct Held {
    double mean = 0.0, least = 1e9, most = -1e9;
};
Held hold(FingertipPlatform& platform, const DisplayPose& wanted, int ticks) {
    Held held;
    for (int n = 0; n < ticks; ++n) {
        platform.tick(wanted, true);
        if (n < ticks / 2)
            continue;
        const double f = platform.truth().normalForce_N;
        held.mean += f / (ticks - ticks / 2);
        held.least = std::min(held.least, f);
        held.most = std::max(held.most, f);
    }
    return held;
}

FingertipPlatformParameters noiseless() {
    FingertipPlatformParameters p;
    p.force.gainSd = p.force.exponentSd = p.force.hysteresis = p.force.creep = p.force.noise_N =
        p.force.adcNoise_counts = 0.0;
    p.imu.bias_rad = p.imu.noise_rad = 0.0;
    return p;
}

} // namespace

class TestFingertipPlant : public QObject {
    Q_OBJECT
private slots:
    void energyOfThePassivePlantFalls();
    void withoutLossesEnergyIsKept();
    void motorsStopAtTheirLimit();
    void theConverterHasItsSteps();
    void readingsComeAtTheirRateAndLate();
    void theTripodSharesTheLoad();
    void nothingDisplayedIsNothing();
    void isStableOnSoftAndStiffPads_data();
    void isStableOnSoftAndStiffPads();
    void forceAndLeanTogetherAtTheLimits();
    void motorsOffLetGo();
    void sameSeedSameBits();
    void itsImuErrsByItself();
};

void TestFingertipPlant::energyOfThePassivePlantFalls() {
    FingertipPlatformParameters p;
    FingertipPlant plant(p);
    plant.reset({0.0012, 0.3, -0.2}); // pressed into the pad, leaning
    plant.ratesForTests() = Vec3(0.05, 4.0, -3.0);
    double before = plant.energy_J();
    const double start = before;
    for (int n = 0; n < 4000; ++n) {
        for (int step = 0; step < 8; ++step)
            plant.step(core::kTickSeconds / 8.0, Vec3::Zero());
        const double now = plant.energy_J();
        // Semi-implicit Euler lets it ripple; over a tick it must not rise by more than a hundredth of what
        // it began with.
        QVERIFY2(now <= before + 0.01 * start, qPrintable(QString("%1 %2 %3").arg(n).arg(before).arg(now)));
        before = now;
    }
    QVERIFY2(before < 0.6 * start, qPrintable(QString("%1 %2").arg(start).arg(before)));
}

// Nothing dissipates: what is left is the step's error, which falls with the step.
void TestFingertipPlant::withoutLossesEnergyIsKept() {
    const auto drift = [](int substeps) {
        FingertipPlatformParameters p;
        p.drive.friction = {};
        p.drive.gearDamping_Ns_per_m = p.drive.jointDamping_Nms_per_rad = p.pad.damping_Ns_per_m =
            p.drive.backlash_m = 0.0;
        FingertipPlant plant(p);
        plant.reset({0.0006, 0.1, -0.05});
        const double start = plant.energy_J();
        double worst = 0.0;
        for (int n = 0; n < 60 * substeps; ++n) {
            plant.step(core::kTickSeconds / substeps, Vec3::Zero());
            worst = std::max(worst, std::abs(plant.energy_J() - start));
        }
        return worst / start;
    };
    const double coarse = drift(16), fine = drift(128);
    QVERIFY2(fine < 0.05 && fine < coarse / 4.0, qPrintable(QString("%1 %2").arg(coarse).arg(fine)));
}

void TestFingertipPlant::motorsStopAtTheirLimit() {
    FingertipPlatformParameters p;
    FingertipPlant plant(p);
    for (int n = 0; n < 8000; ++n)
        plant.step(core::kTickSeconds / 8.0, Vec3::Constant(100.0));
    QVERIFY(plant.saturated());
    const double most = 3.0 * p.drive.forceLimit_N;
    QVERIFY2(plant.padForce_N() > 4.0 && plant.padForce_N() < most,
             qPrintable(QString::number(plant.padForce_N())));
}

// P3: 10 bits, about 4 mN a count at small force, coarser above: V = x/(1+x).
void TestFingertipPlant::theConverterHasItsSteps() {
    FingertipForceSensors sensors(noiseless().force, 1);
    QCOMPARE(sensors.fullScale(), 1023);
    QVERIFY(std::abs(sensors.resolution_N(0.0) - 4.0 / 1024.0) < 1e-12);
    QVERIFY(std::abs(sensors.resolution_N(4.0) - 4.0 * sensors.resolution_N(0.0)) < 1e-12);
    std::set<int> seen;
    double worst = 0.0, least = 1e9;
    double last = -1.0;
    for (int n = 0; n < 8000; ++n) {
        const double force = 4.0 * n / 8000.0;
        if (!sensors.tick(force, {0.0, 0.0}))
            continue;
        seen.insert(sensors.counts()[0]);
        worst = std::max(worst, std::abs(sensors.force_N() - force));
        if (last >= 0.0 && sensors.force_N() != last)
            least = std::min(least, std::abs(sensors.force_N() - last));
        last = sensors.force_N();
    }
    QVERIFY2(least > 3.5e-3, qPrintable(QString::number(least))); // no finer than a count
    QVERIFY2(worst < 0.06, qPrintable(QString::number(worst)));   // delay of the ramp and three half counts
    QVERIFY(*seen.rbegin() < 512 && seen.size() > 150); // a third of 4 N and the preload: well below half
    FingertipForceSensors clipped(noiseless().force, 1);
    for (int n = 0; n < 10; ++n)
        clipped.tick(1e12, {0.0, 0.0});
    QCOMPARE(clipped.counts()[0], 1023);
    QVERIFY(std::isfinite(clipped.force_N()));
}

void TestFingertipPlant::readingsComeAtTheirRateAndLate() {
    FingertipPlatformParameters p = noiseless();
    p.force.period_ticks = 5;
    p.force.delay_ticks = 7;
    FingertipForceSensors sensors(p.force, 1);
    int readings = 0;
    int seenAt = -1;
    for (int n = 0; n < 1000; ++n) {
        readings += sensors.tick(n >= 500 ? 1.0 : 0.0, {0.0, 0.0}) ? 1 : 0;
        if (seenAt < 0 && sensors.force_N() > 0.5)
            seenAt = n;
    }
    QCOMPARE(readings, 200);
    QVERIFY2(seenAt >= 507 && seenAt <= 511, qPrintable(QString::number(seenAt)));
    mechanisms::FingertipImu imu(noiseless().imu, 1);
    int changes = 0;
    double before = 0.0;
    for (int n = 0; n < 1000; ++n) {
        imu.tick({0.0, 0.0001 * n, 0.0});
        changes += imu.pitch_rad() != before ? 1 : 0;
        before = imu.pitch_rad();
    }
    QCOMPARE(changes, 99); // 100 Hz, the first reads zero
}

void TestFingertipPlant::theTripodSharesTheLoad() {
    FingertipForceSensors sensors(noiseless().force, 1);
    const auto at = [&](double x, double y) {
        for (int n = 0; n < 40; ++n)
            sensors.tick(1.0, {x, y});
        return sensors.force_N();
    };
    constexpr double kSixHalfCounts_N = 0.015; // three readings and three tares
    QVERIFY(std::abs(at(0.0, 0.0) - 1.0) < kSixHalfCounts_N);
    QVERIFY(std::abs(at(0.002, -0.001) - 1.0) < kSixHalfCounts_N); // wherever it is pressed
    QVERIFY(sensors.counts()[2] > sensors.counts()[1]);
    QVERIFY(std::abs(at(-0.02, 0.0) - 1.0) < 0.02); // beyond the edge too
}

void TestFingertipPlant::nothingDisplayedIsNothing() {
    FingertipPlatform platform({}, 1);
    const Held held = hold(platform, {0.0, 0.0, 0.0}, 3000);
    QCOMPARE(held.most, 0.0);
    QVERIFY(std::abs(platform.truth().pitch_rad) < 0.01 && std::abs(platform.truth().roll_rad) < 0.01);
    QVERIFY(platform.plant().pose().z_m < 0.0); // stands off
}

void TestFingertipPlant::isStableOnSoftAndStiffPads_data() {
    QTest::addColumn<double>("stiffness");
    QTest::addColumn<double>("hardening");
    QTest::addColumn<double>("damping");
    for (const auto& [name, pad] :
         {std::pair{"soft", FingerPadParameters::soft()}, std::pair{"as measured", FingerPadParameters{}},
          std::pair{"stiff", FingerPadParameters::stiff()}})
        QTest::newRow(name) << pad.stiffness_N_per_m << pad.hardening_per_m << pad.damping_Ns_per_m;
}

// The controller goes on believing in the pad that it measured.
void TestFingertipPlant::isStableOnSoftAndStiffPads() {
    QFETCH(double, stiffness);
    QFETCH(double, hardening);
    QFETCH(double, damping);
    FingertipPlatformParameters p;
    p.pad.stiffness_N_per_m = stiffness;
    p.pad.hardening_per_m = hardening;
    p.pad.damping_Ns_per_m = damping;
    FingertipPlatform platform(p, 3);
    for (const double force : {0.1, 0.5, 2.0, 3.4}) {
        const Held held = hold(platform, {force, 0.2, -0.1}, 3000);
        QVERIFY2(std::abs(held.mean - force) < 0.01 + 0.03 * force,
                 qPrintable(QString("%1 N: %2").arg(force).arg(held.mean)));
        QVERIFY2(held.most - held.least < 0.04 + 0.12 * force,
                 qPrintable(QString("%1 N: %2..%3").arg(force).arg(held.least).arg(held.most)));
    }
}

void TestFingertipPlant::forceAndLeanTogetherAtTheLimits() {
    FingertipPlatform platform({}, 1);
    for (const double side : {1.0, -1.0}) {
        const DisplayPose wanted{4.0, side * core::radFromDeg(30.0), -side * core::radFromDeg(20.0)};
        const Held held = hold(platform, wanted, 3000);
        // A limit is a limit at the pad: what the sensors cannot know of the force is left below 4 N.
        QVERIFY2(held.most <= 4.0 && held.mean > 3.3,
                 qPrintable(QString("%1, at most %2").arg(held.mean).arg(held.most)));
        QVERIFY(std::abs(platform.truth().pitch_rad - wanted.pitch_rad) < 0.02 &&
                std::abs(platform.truth().roll_rad - wanted.roll_rad) < 0.02);
    }
}

void TestFingertipPlant::motorsOffLetGo() {
    FingertipPlatform platform({}, 1);
    hold(platform, {3.0, 0.2, 0.0}, 1500);
    for (int n = 0; n < 300; ++n)
        platform.tick({3.0, 0.2, 0.0}, false); // what is asked for does not matter
    // The gears are driven back by the pad until friction holds: 0.25 N on each of three drives.
    QVERIFY2(platform.truth().normalForce_N < 0.9,
             qPrintable(QString::number(platform.truth().normalForce_N)));
    const Held again = hold(platform, {1.0, 0.0, 0.0}, 1500);
    QVERIFY(std::abs(again.mean - 1.0) < 0.05);
}

void TestFingertipPlant::sameSeedSameBits() {
    FingertipPlatform a({}, 5), b({}, 5), c({}, 6);
    bool differs = false;
    for (int n = 0; n < 2000; ++n) {
        const DisplayPose wanted{1.0 + 0.5 * std::sin(0.01 * n), 0.2, 0.0};
        for (FingertipPlatform* platform : {&a, &b, &c})
            platform->tick(wanted, true);
        QVERIFY(a.truth().normalForce_N == b.truth().normalForce_N &&
                a.sensedForce_N() == b.sensedForce_N() && a.sensedPitch_rad() == b.sensedPitch_rad());
        differs = differs || a.sensedForce_N() != c.sensedForce_N();
    }
    QVERIFY(differs);
    a.reset();
    FingertipPlatform fresh({}, 5);
    for (int n = 0; n < 500; ++n) {
        a.tick({1.0, 0.1, 0.1}, true);
        fresh.tick({1.0, 0.1, 0.1}, true);
        QVERIFY(a.truth().normalForce_N == fresh.truth().normalForce_N &&
                a.sensedForce_N() == fresh.sensedForce_N());
    }
}

/// A device gives both of its IMUs, on the platform and on the handle, the same seed. What calibration left
/// of the one says nothing of the other: over 400 devices a correlation has a standard deviation of 0.05.
void TestFingertipPlant::itsImuErrsByItself() {
    constexpr std::uint64_t kDevices = 400;
    for (const int axis : {0, 1}) {
        double both = 0.0, ofHandle = 0.0, ofPlatform = 0.0;
        for (std::uint64_t seed = 0; seed < kDevices; ++seed) {
            const double handle = mechanisms::AttitudeSensor({}, seed).rate_T()[axis]; // at rest: its bias
            const mechanisms::FingertipImu imu({}, seed);
            const double platform = axis == 0 ? imu.pitch_rad() : imu.roll_rad();
            both += handle * platform;
            ofHandle += handle * handle;
            ofPlatform += platform * platform;
        }
        const double correlation = both / std::sqrt(ofHandle * ofPlatform);
        QVERIFY2(std::abs(correlation) < 0.2, qPrintable(QString::number(correlation)));
    }
}

QTEST_APPLESS_MAIN(TestFingertipPlant)
#include "test_fingertip_plant.moc"
