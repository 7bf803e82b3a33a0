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
    void tooMuchAtTheLimitIsSaturation() { QCOMPARE(pressed(0.010, 0.010).outside, std::string("saturation")); }
};

QTEST_APPLESS_MAIN(TestFidelityMeter)
#include "test_fidelity_meter.moc"
