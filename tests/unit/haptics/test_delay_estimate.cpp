// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/delay_estimate.h"

#include "core/random.h"
#include "core/units.h"

#include <QtTest>

#include <algorithm>
#include <cmath>
#include <complex>

using namespace chiron;
using haptics::DelayRecord;

namespace {

struct Truth {
    double delay_s = 0.0;
    double mass_kg = 0.2, damping_Ns_per_m = 3.0, stiffness_N_per_m = 400.0;
    double noise_m = 0.0, resolution_m = 0.0;
    double amplitude_N = 0.4;
    int bursts = 6;
};

/// What a mass on a spring and a damper answers, by its frequency response, so many seconds late and half a
/// tick for the hold.
DelayRecord answered(const Truth& truth) {
    DelayRecord record;
    record.reserve(truth.bursts);
    auto random = core::Random::stream(7, "noise");
    for (int n = 0; n < truth.bursts * DelayRecord::kWindow_ticks; ++n) {
        double f = 0.0, x = 0.0;
        for (std::size_t i = 0; i < DelayRecord::kFrequencies_Hz.size(); ++i) {
            const double w = 2.0 * core::kPi * DelayRecord::kFrequencies_Hz[i];
            const std::complex<double> in =
                std::polar(truth.amplitude_N, w * n * core::kTickSeconds + static_cast<double>(i * i));
            const std::complex<double> stiffness(truth.stiffness_N_per_m - truth.mass_kg * w * w,
                                                 truth.damping_Ns_per_m * w);
            f += in.real();
            x += (in / stiffness * std::polar(1.0, -w * (truth.delay_s + 0.5 * core::kTickSeconds))).real();
        }
        x += truth.noise_m * random.normal();
        record.place(truth.resolution_m > 0.0 ? truth.resolution_m * std::round(x / truth.resolution_m) : x);
        record.force(f, true);
    }
    return record;
}

core::ErrorCode codeOf(const DelayRecord& record) {
    const auto found = haptics::estimateDelay(record);
    return found ? core::ErrorCode::cancelled : found.error().code; // nothing else is cancelled here
}

} // namespace

class TestDelayEstimate : public QObject {
    Q_OBJECT
private slots:
    void delayOfAMassIsExact_data() {
        QTest::addColumn<double>("ms");
        for (const double ms : {0.0, 0.37, 1.0, 2.5, 8.0, 20.0})
            QTest::addRow("%g ms", ms) << ms;
    }
    void delayOfAMassIsExact() {
        QFETCH(double, ms);
        for (const double mass_kg : {0.05, 0.2, 1.5}) {
            const auto found = haptics::estimateDelay(answered({.delay_s = 1e-3 * ms, .mass_kg = mass_kg}));
            QVERIFY2(found, found ? "" : found.error().message.c_str());
            QVERIFY2(std::abs(1e3 * found->delay_s - ms) < 0.002,
                     qPrintable(QString::number(1e3 * found->delay_s)));
            QVERIFY(std::abs(found->mass_kg / mass_kg - 1.0) < 0.01);
            QCOMPARE(found->bursts, 6);
        }
    }
    /// Counts of 25 µm and a trembling hand: still a tenth of a millisecond, and it says how sure it is.
    void noiseAndCoarseCountsCostLittle() {
        const auto found =
            haptics::estimateDelay(answered({.delay_s = 0.002, .noise_m = 30e-6, .resolution_m = 25e-6}));
        QVERIFY2(found, found ? "" : found.error().message.c_str());
        QVERIFY(found->standardError_s > 1e-6);
        QVERIFY2(std::abs(found->delay_s - 0.002) < std::max(0.0001, 4.0 * found->standardError_s),
                 qPrintable(QString::number(found->delay_s)));
    }
    void whatIsNoAnswerIsRefused() {
        QCOMPARE(codeOf(answered({.noise_m = 0.02})), core::ErrorCode::doesNotHold); // drowned
        QCOMPARE(codeOf(answered({.delay_s = 0.03})),
                 core::ErrorCode::doesNotHold); // later than any device that renders
        QCOMPARE(codeOf(answered({.mass_kg = -0.2})), core::ErrorCode::doesNotHold); // the wrong way round
        QCOMPARE(codeOf(answered({.amplitude_N = 0.001})), core::ErrorCode::doesNotHold); // not armed
        QCOMPARE(codeOf(answered({.mass_kg = 1e9, .resolution_m = 1e-6})),
                 core::ErrorCode::doesNotHold); // clamped
        QCOMPARE(codeOf(answered({.bursts = 2})), core::ErrorCode::badInput);
        QCOMPARE(codeOf(answered({.noise_m = 1e-6, .bursts = 3})), core::ErrorCode::cancelled); // enough
        QCOMPARE(codeOf(DelayRecord{}), core::ErrorCode::badInput);
        QCOMPARE(codeOf(answered({.noise_m = std::nan("")})), core::ErrorCode::badInput);
    }
    /// A burst in which ticks were left out does not count; the gap between two bursts is none.
    void burstsWithGapsAreLeftOut() {
        DelayRecord record = answered({.delay_s = 0.001});
        const std::vector<double> force = record.force_N;
        record.forces = 0;
        for (std::size_t n = 0; n < force.size(); ++n)
            record.force(force[n], n != 1500 && n != 4000);
        const auto found = haptics::estimateDelay(record);
        QVERIFY(found);
        QCOMPARE(found->bursts, 5);
        QVERIFY(std::abs(found->delay_s - 0.001) < 2e-6);
    }
    void aFullRecordTakesNoMore() {
        DelayRecord record = answered({});
        const std::size_t places = record.places;
        record.place(1.0);
        record.force(1.0, false);
        QCOMPARE(record.places, places);
        QCOMPARE(record.forces, places);
    }
    /// Room that is set aside again holds nothing of what was measured before.
    void aRecordBeginsAnew() {
        DelayRecord record = answered({.bursts = 3});
        record.broken[1] = 1;
        record.damped = 7;
        record.reserve(4);
        QCOMPARE(record.places, std::size_t{0});
        QCOMPARE(record.forces, std::size_t{0});
        QCOMPARE(record.damped, 0);
        QCOMPARE(record.broken, std::vector<std::uint8_t>(4, 0));
        QCOMPARE(codeOf(record), core::ErrorCode::badInput); // nothing was measured yet
        const auto full = answered({.delay_s = 0.001, .noise_m = 1e-6, .bursts = 4});
        for (std::size_t n = 0; n < full.places; ++n) {
            record.place(full.place_m[n]);
            record.force(full.force_N[n], true);
        }
        const auto found = haptics::estimateDelay(record);
        QVERIFY2(found, found ? "" : found.error().message.c_str());
        QCOMPARE(found->bursts, 4);
    }
};

QTEST_APPLESS_MAIN(TestDelayEstimate)
#include "test_delay_estimate.moc"
