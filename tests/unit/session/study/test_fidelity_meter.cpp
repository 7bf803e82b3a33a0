// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/study/fidelity_meter.h"

#include "core/units.h"

#include <QtTest>

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace chiron;

namespace {

constexpr double kStiffness_N_per_m = 500.0, kCap_N = 3.0;

/// A hand that presses a spring again and again, each time as deep as it is told, on a device that gives kCap_N and no more.
session::TrialFidelity pressed(double usual_m, double deepest_m) {
    simulation::ComparisonParameters place;
    place.attribute = simulation::ComparedAttribute::stiffness;
    place.places = 1;
    session::FidelityMeter meter(place, {}, false);
    meter.begin({kStiffness_N_per_m});
    session::FidelitySample sample;
    sample.phase = core::TrialPhase::running;
    sample.full = true;
    constexpr int kStroke_ticks = 400, kStrokes = 20;
    for (int i = 0; i < kStrokes * kStroke_ticks; ++i) {
        const double depth_m = i < kStroke_ticks ? deepest_m : usual_m; // the first stroke is the deep one
        const double phase = 2.0 * std::numbers::pi * i / kStroke_ticks;
        sample.now_ns += 1'000'000;
        sample.displacement_m = 0.5 * depth_m * (1.0 - std::cos(phase));
        sample.velocity_m_per_s = {0.0, 0.0, -0.5 * depth_m * std::sin(phase) * 2.0 * std::numbers::pi / (kStroke_ticks * core::kTickSeconds)};
        sample.place = sample.displacement_m > 0.0 ? 1 : 0;
        const double asked_N = kStiffness_N_per_m * sample.displacement_m;
        sample.saturated = asked_N > kCap_N;
        sample.commanded_N = {0.0, 0.0, std::min(asked_N, kCap_N)};
        meter.add(sample);
    }
    return meter.finish();
}

session::FidelityMeter meterOf() {
    simulation::ComparisonParameters parameters;
    parameters.attribute = simulation::ComparedAttribute::stiffness;
    parameters.places = 1;
    return session::FidelityMeter(parameters, {}, false);
}

/// A tick on this place (0: none), pressed with so much.
session::FidelitySample sampleOf(int place, double force_N, std::int64_t now_ns) {
    session::FidelitySample sample;
    sample.phase = core::TrialPhase::running;
    sample.full = true;
    sample.now_ns = now_ns;
    sample.place = static_cast<std::uint8_t>(place);
    sample.touched = place > 0 ? 1 : 0;
    sample.displacement_m = force_N / kStiffness_N_per_m;
    sample.commanded_N = {0.0, 0.0, force_N};
    return sample;
}

} // namespace

class TestFidelityMeter : public QObject {
    Q_OBJECT
private slots:
    void aSpringWithinTheLimitIsFound() {
        const auto fidelity = pressed(0.004, 0.004);
        QVERIFY(std::abs(fidelity.places[0].rendered / kStiffness_N_per_m - 1.0) < 1e-4);
        QCOMPARE(fidelity.saturated, 0.0);
        QVERIFY2(fidelity.outside.empty(), fidelity.outside.c_str());
    }
    /// One stroke in twenty meets the device's limit: that is told as saturation, and is not taken for a softer spring.
    void aForceAtItsLimitIsNotTheObjects() {
        const auto fidelity = pressed(0.004, 0.020);
        QVERIFY(fidelity.saturated > 0.02);
        QVERIFY(fidelity.saturated < 0.05);
        QVERIFY2(std::abs(fidelity.places[0].rendered / kStiffness_N_per_m - 1.0) < 1e-4,
                 qPrintable(QString::number(fidelity.places[0].rendered)));
        QVERIFY2(fidelity.outside.empty(), fidelity.outside.c_str());
    }
    /// A contact counts from its first tick to its last, also one that is there when the trial begins or ends.
    void contactsAreCountedFromTheFirst() {
        session::FidelityMeter meter = meterOf();
        meter.begin({kStiffness_N_per_m});
        std::int64_t now_ns = 0;
        const auto touch = [&](int place, double force_N, int ticks) {
            for (int i = 0; i < ticks; ++i)
                meter.add(sampleOf(place, force_N, now_ns += 1'000'000));
        };
        touch(1, 1.0, 10); // touched already as the trial begins
        touch(0, 0.0, 5);
        touch(1, 2.0, 1); // for one tick
        touch(0, 0.0, 5);
        touch(1, 6.0, 10); // and still as it ends
        const session::TrialFidelity fidelity = meter.finish();
        QCOMPARE(fidelity.contacts, 3);
        QCOMPARE(fidelity.places[0].contacts, 3);
        QCOMPARE(fidelity.places[0].contact_s, 0.021);
        QCOMPARE(fidelity.places[0].terminalForce_N, 3.0);
        QCOMPARE(fidelity.peakForce_N, 6.0);
    }
    /// Ticks of a pause are in no measure but their own, and touch nothing.
    void aPauseCountsForItselfAlone() {
        session::FidelityMeter meter = meterOf();
        meter.begin({kStiffness_N_per_m});
        std::int64_t now_ns = 0;
        for (int i = 0; i < 300; ++i) {
            session::FidelitySample sample = sampleOf(i < 100 ? 1 : 0, 1.0, now_ns += 1'000'000);
            sample.velocity_m_per_s = {i < 100 ? 0.02 : i < 200 ? 0.5 : 0.0, 0.0, 0.0};
            sample.paused = i >= 100 && i < 200 ? 1 : 0;
            sample.place = i < 200 ? 1 : 0;
            meter.add(sample);
        }
        const session::TrialFidelity fidelity = meter.finish();
        QCOMPARE(fidelity.duration_s, 0.2);
        QCOMPARE(fidelity.paused_s, 0.1);
        QVERIFY(std::abs(fidelity.meanSpeed_m_per_s - 0.01) < 1e-12);
        QCOMPARE(fidelity.contacts, 1);
        QCOMPARE(fidelity.lateTicks, 0.0); // nor do ticks seem to be missing
        QCOMPARE(session::pausedOf(session::fidelityJson(fidelity)), 0.1);
        QVERIFY(std::isnan(session::pausedOf(R"({"duration_s":3})"))); // stored before pauses were measured
    }
    /// On a device that renders none forces are the tissue's; what compares with what was felt is not measured.
    void whatIsShownIsNotFelt() {
        for (const bool touches : {true, false}) {
            simulation::ComparisonParameters parameters;
            parameters.attribute = simulation::ComparedAttribute::stiffness;
            parameters.places = 1;
            session::FidelityMeter meter(parameters, {}, false, true);
            meter.begin({kStiffness_N_per_m});
            for (int i = 0; i < 500; ++i) {
                session::FidelitySample sample = sampleOf(touches ? 1 : 0, 0.0, (i + 1) * std::int64_t{1'000'000});
                sample.displacement_m = 0.002 + 1e-6 * i;
                sample.tissue_N = {0.0, 0.0, kStiffness_N_per_m * sample.displacement_m};
                sample.full = false;
                sample.saturated = true;
                meter.add(sample);
            }
            const session::TrialFidelity fidelity = meter.finish();
            QVERIFY(fidelity.shown && !fidelity.measured);
            QVERIFY(std::isnan(fidelity.stiffnessError) && std::isnan(fidelity.saturated) && std::isnan(fidelity.forceErrorRms_N));
            QVERIFY(std::isnan(fidelity.places[0].rendered));
            QVERIFY2(fidelity.outside.empty(), fidelity.outside.c_str()); // it is no fault of the rendering
            if (touches) {
                const double most_N = kStiffness_N_per_m * (0.002 + 1e-6 * 499);
                QVERIFY(std::abs(fidelity.peakForce_N - most_N) < 1e-9 && std::abs(fidelity.places[0].terminalForce_N - most_N) < 1e-9);
                QCOMPARE(fidelity.contacts, 1);
            } else {
                QVERIFY(std::isnan(fidelity.peakForce_N) && std::isnan(fidelity.places[0].peakForce_N) && std::isnan(fidelity.places[0].terminalForce_N));
            }
        }
    }
    void tooMuchAtTheLimitIsSaturation() { QCOMPARE(pressed(0.010, 0.010).outside, std::string("saturation")); }
};

QTEST_APPLESS_MAIN(TestFidelityMeter)
#include "test_fidelity_meter.moc"
