// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/study/fidelity_meter.h"

#include "core/haptic_frame.h"
#include "core/units.h"
#include "simulation/comparison/comparison_scene.h"

#include <QtTest>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

using namespace chiron;

namespace {

constexpr double kStiffness_N_per_m = 500.0, kCap_N = 3.0;

/// A hand that presses a spring again and again, each time as deep as it is told, on a device that gives
/// kCap_N and no more.
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
        sample.velocity_m_per_s = {0.0, 0.0,
                                   -0.5 * depth_m * std::sin(phase) * 2.0 * std::numbers::pi /
                                       (kStroke_ticks * core::kTickSeconds)};
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

using simulation::ComparedAttribute;

/// What a hand does at a tick, and what answers.
struct Touched {
    double displacement_m = 0.0, depth_m = 0.0;
    std::array<double, 3> velocity_m_per_s{}, force_N{};
    bool saturated = false;
};

/// 4,000 ticks of one contact with an object of this attribute.
template <class Hand> session::PlaceFidelity felt(ComparedAttribute attribute, double asked, Hand hand) {
    simulation::ComparisonParameters parameters;
    parameters.attribute = attribute;
    parameters.places = 1;
    parameters.hookReach_m = 0.006;
    parameters.object.stiffness_N_per_m = 400.0;
    parameters.object.bristleStiffness_N_per_m = 1000.0;
    session::FidelityMeter meter(parameters, {}, false);
    meter.begin({asked});
    for (int i = 0; i < 4000; ++i) {
        const Touched touched = hand(i);
        session::FidelitySample sample = sampleOf(1, 0.0, (i + 1) * std::int64_t{1'000'000});
        sample.displacement_m = touched.displacement_m;
        sample.depth_m = touched.depth_m;
        sample.velocity_m_per_s = touched.velocity_m_per_s;
        sample.commanded_N = touched.force_N;
        sample.saturated = touched.saturated;
        meter.add(sample);
    }
    return meter.finish().places.at(0);
}

bool about(double value, double expected, double share = 1e-6) {
    return std::abs(value - expected) <= share * std::abs(expected);
}

/// A little of every limit: late ticks, a force at its limit, a force off its command, one off its object, a
/// peak, a speed.
session::TrialFidelity underLimits(const psychophysics::FidelityLimits& limits) {
    simulation::ComparisonParameters parameters;
    parameters.attribute = ComparedAttribute::stiffness;
    parameters.places = 1;
    session::FidelityMeter meter(parameters, limits, false);
    meter.begin({1.1 * kStiffness_N_per_m});
    std::int64_t now_ns = 0;
    for (int i = 0; i < 1000; ++i) {
        now_ns += i % 100 == 50   ? 1'500'001
                  : i % 100 == 51 ? 1'500'000
                                  : 1'000'000; // half a millisecond is not late, more is
        const double force_N = 1.0 + std::sin(0.01 * i);
        session::FidelitySample sample = sampleOf(1, force_N, now_ns);
        sample.velocity_m_per_s = {0.02, 0.0, 0.03 * std::cos(0.07 * i)};
        sample.measures = true;
        sample.measured_N = {0.0, 0.0, force_N};
        sample.commanded_N = {0.03, 0.0, force_N + 0.04};
        sample.saturated = i % 50 == 0;
        meter.add(sample);
    }
    return meter.finish();
}

} // namespace

class TestFidelityMeter : public QObject {
    Q_OBJECT
private slots:
    /// What a trial says of itself comes back from where it is stored, a tick of 0 too; what it does not say
    /// stays unsaid.
    void circumstancesComeBack() {
        session::TrialFidelity told;
        told.circumstances = {"de", session::TrialCircumstances::kMaskingNoise, 0};
        const session::TrialCircumstances back = session::circumstancesOf(session::fidelityJson(told));
        QVERIFY(back.language == "de" && back.masking == session::TrialCircumstances::kMaskingNoise);
        QVERIFY(back.answerTick == std::optional<std::uint64_t>(0));
        QVERIFY(!session::circumstancesOf(session::fidelityJson({})).answerTick);
    }
    /// A tick of a session as the meter takes it, everything at its place.
    void aFrameBecomesASample() {
        namespace q = simulation::comparison_quantity;
        core::HapticFrame frame{};
        frame.header.index = 1234;
        frame.header.now_ns = 5'000'000'123;
        frame.header.events = core::event_bits::kContactBegan;
        frame.header.guards = core::guard_bits::kSlew;
        frame.header.trial = 3;
        frame.header.phase = core::TrialPhase::running;
        frame.header.force = core::ForceState::on;
        frame.header.paused = 1;
        for (std::size_t i = 0; i < frame.header.quantities.size(); ++i)
            frame.header.quantities[i] = 1.0 + static_cast<double>(i);
        for (std::size_t i = 0; i < 6; ++i) {
            const double k = static_cast<double>(i);
            frame.tool[0].commanded[i] = 10.0 + k;
            frame.tool[0].measured[i] = 20.0 + k;
            frame.tool[0].tissue[i] = 30.0 + k;
        }
        const auto whole = [](std::size_t quantity) { return static_cast<int>(quantity) + 1; };
        const session::FidelitySample sample = session::fidelitySampleOf(frame);
        QVERIFY(sample.tick == 1234 && sample.now_ns == 5'000'000'123 && sample.trial == 3);
        QVERIFY(sample.events == core::event_bits::kContactBegan && sample.guards == core::guard_bits::kSlew);
        QVERIFY(sample.phase == core::TrialPhase::running && sample.paused == 1);
        QVERIFY(sample.full && !sample.measures && !sample.saturated);
        QCOMPARE(int(sample.place), whole(q::kPlace));
        QCOMPARE(int(sample.touched), whole(q::kTouched));
        QCOMPARE(int(sample.candidate), whole(q::kCandidate));
        QCOMPARE(int(sample.arrangement), whole(q::kArrangement));
        QCOMPARE(int(sample.answer), whole(q::kAnswer));
        QCOMPARE(sample.displacement_m, double(whole(q::kDisplacement)));
        QCOMPARE(sample.depth_m, double(whole(q::kDepth)));
        for (std::size_t i = 0; i < 3; ++i) {
            const double k = static_cast<double>(i);
            QCOMPARE(sample.velocity_m_per_s[i], whole(q::kVelocity) + k);
            QCOMPARE(sample.commanded_N[i], 10.0 + k);
            QCOMPARE(sample.measured_N[i], 20.0 + k);
            QCOMPARE(sample.tissue_N[i], 30.0 + k);
        }
        const auto saturated = [](core::HapticFrame of) { return session::fidelitySampleOf(of).saturated; };
        core::HapticFrame capped = frame, weak = frame, arming = frame, measuring = frame;
        capped.header.guards |= core::guard_bits::kCap;         // by the supervisor
        weak.tool[0].status |= core::sample_status::kSaturated; // by the device
        QVERIFY(saturated(capped) && saturated(weak));
        arming.header.force = core::ForceState::arming;
        QVERIFY(!session::fidelitySampleOf(arming).full);
        measuring.tool[0].status |= core::sample_status::kMeasuredForce;
        QVERIFY(session::fidelitySampleOf(measuring).measures);
    }
    /// Each place counts for itself, the last one, too.
    void everyPlaceIsCounted() {
        simulation::ComparisonParameters parameters;
        parameters.attribute = ComparedAttribute::stiffness;
        parameters.places = 3;
        session::FidelityMeter meter(parameters, {}, false);
        meter.begin({kStiffness_N_per_m, kStiffness_N_per_m, kStiffness_N_per_m});
        std::int64_t now_ns = 0;
        for (int place = 1; place <= 3; ++place) {
            for (int i = 0; i < 10 * place; ++i)
                meter.add(sampleOf(place, place, now_ns += 1'000'000));
            meter.add(sampleOf(0, 0.0, now_ns += 1'000'000));
        }
        const session::TrialFidelity fidelity = meter.finish();
        QCOMPARE(fidelity.contacts, 3);
        QCOMPARE(fidelity.places.size(), std::size_t{3});
        for (std::size_t i = 0; i < 3; ++i) {
            const double k = static_cast<double>(i + 1);
            QCOMPARE(fidelity.places[i].contacts, 1);
            QCOMPARE(fidelity.places[i].contact_s, 0.010 * k);
            QCOMPARE(fidelity.places[i].peakForce_N, k);
            QCOMPARE(fidelity.places[i].terminalForce_N, k);
        }
    }
    void aSpringWithinTheLimitIsFound() {
        const auto fidelity = pressed(0.004, 0.004);
        QVERIFY(std::abs(fidelity.places[0].rendered / kStiffness_N_per_m - 1.0) < 1e-4);
        QCOMPARE(fidelity.saturated, 0.0);
        QVERIFY2(fidelity.outside.empty(), fidelity.outside.c_str());
    }
    /// One stroke in twenty meets the device's limit: that is told as saturation, and is not taken for a
    /// softer spring.
    void aForceAtItsLimitIsNotTheObjects() {
        const auto fidelity = pressed(0.004, 0.020);
        QVERIFY(fidelity.saturated > 0.02);
        QVERIFY(fidelity.saturated < 0.05);
        QVERIFY2(std::abs(fidelity.places[0].rendered / kStiffness_N_per_m - 1.0) < 1e-4,
                 qPrintable(QString::number(fidelity.places[0].rendered)));
        QVERIFY2(fidelity.outside.empty(), fidelity.outside.c_str());
    }
    /// A contact counts from its first tick to its last, also one that is there when the trial begins or
    /// ends.
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
    /// On a device that renders none forces are the tissue's; what compares with what was felt is not
    /// measured.
    void whatIsShownIsNotFelt() {
        for (const bool touches : {true, false}) {
            simulation::ComparisonParameters parameters;
            parameters.attribute = simulation::ComparedAttribute::stiffness;
            parameters.places = 1;
            session::FidelityMeter meter(parameters, {}, false, true);
            meter.begin({kStiffness_N_per_m});
            for (int i = 0; i < 500; ++i) {
                session::FidelitySample sample =
                    sampleOf(touches ? 1 : 0, 0.0, (i + 1) * std::int64_t{1'000'000});
                sample.displacement_m = 0.002 + 1e-6 * i;
                sample.tissue_N = {0.0, 0.0, kStiffness_N_per_m * sample.displacement_m};
                sample.full = false;
                sample.saturated = true;
                meter.add(sample);
            }
            const session::TrialFidelity fidelity = meter.finish();
            QVERIFY(fidelity.shown && !fidelity.measured);
            QVERIFY(std::isnan(fidelity.stiffnessError) && std::isnan(fidelity.saturated) &&
                    std::isnan(fidelity.forceErrorRms_N));
            QVERIFY(std::isnan(fidelity.places[0].rendered));
            QVERIFY2(fidelity.outside.empty(), fidelity.outside.c_str()); // it is no fault of the rendering
            if (touches) {
                const double most_N = kStiffness_N_per_m * (0.002 + 1e-6 * 499);
                QVERIFY(std::abs(fidelity.peakForce_N - most_N) < 1e-9 &&
                        std::abs(fidelity.places[0].terminalForce_N - most_N) < 1e-9);
                QCOMPARE(fidelity.contacts, 1);
            } else {
                QVERIFY(std::isnan(fidelity.peakForce_N) && std::isnan(fidelity.places[0].peakForce_N) &&
                        std::isnan(fidelity.places[0].terminalForce_N));
            }
        }
    }
    /// Each attribute is found exactly from the ticks that speak of it, whatever the force is at the others.
    void eachLawIsFoundWhereItSpeaks() {
        const double nonsense_N = 9.0;
        const auto speed = [](int i) { return 0.020 + 0.015 * std::sin(0.011 * i); };
        const auto along = [](int i) { return std::array{std::cos(0.003 * i), std::sin(0.003 * i)}; };

        const auto spring = felt(ComparedAttribute::stiffness, 500.0, [&](int i) {
            const double d_m = 0.002 + 0.0018 * std::sin(0.011 * i), v = 0.05 * std::cos(0.037 * i);
            return Touched{
                d_m, 0.0, {0.0, 0.0, v}, {0.0, 0.0, d_m > 0.0005 ? 500.0 * d_m + 0.3 + 4.0 * v : nonsense_N}};
        });
        QVERIFY2(about(spring.rendered, 500.0), qPrintable(QString::number(spring.rendered)));

        const auto object = felt(ComparedAttribute::mass, 0.25, [&](int i) {
            const double d_m = 0.008 + 0.004 * std::sin(0.011 * i);
            return Touched{
                d_m, 0.0, {}, {0.0, 0.0, d_m > 0.008 ? -0.25 * core::kStandardGravity : -nonsense_N}};
        });
        QVERIFY2(about(object.rendered, 0.25), qPrintable(QString::number(object.rendered)));

        const auto rough = felt(ComparedAttribute::roughness, 0.0002, [&](int i) {
            const double d_m = 0.001 + 0.0005 * std::sin(0.017 * i), v = 0.02 * std::cos(0.037 * i),
                         s = speed(i);
            return Touched{
                0.0,
                d_m,
                {s * along(i)[0], s * along(i)[1], v},
                {0.0, 0.0,
                 s > 0.010 ? 300.0 * d_m + 0.2 + 2.0 * v + (i % 2 == 0 ? 0.08 : -0.08) : nonsense_N}};
        });
        QVERIFY2(about(rough.rendered, 0.08 / 400.0, 0.01), qPrintable(QString::number(rough.rendered)));
        QVERIFY(std::isnan(rough.standardError));

        const auto viscous = felt(ComparedAttribute::viscosity, 12.0, [&](int i) {
            const double s = speed(i), depth_m = i % 5 == 0 ? 0.0004 : 0.002;
            const double back_N = s > 0.010 && depth_m > 0.0005 ? 12.0 * s + 0.4 : nonsense_N;
            return Touched{0.0,
                           depth_m,
                           {s * along(i)[0], s * along(i)[1], 0.0},
                           {-back_N * along(i)[0], -back_N * along(i)[1], 1.0}};
        });
        QVERIFY2(about(viscous.rendered, 12.0), qPrintable(QString::number(viscous.rendered)));

        // What yields slowly: of the 33 times that are tried, from 5 ms to 5 s, the one that it has; a force
        // at its limit says nothing of it.
        for (const int which : {0, 9, 20, 32}) {
            const double time_s = 0.005 * std::pow(1000.0, which / 32.0),
                         share = 1.0 - std::exp(-core::kTickSeconds / time_s);
            double dent_m = 0.0;
            const auto yielding = felt(ComparedAttribute::deformation, time_s, [&](int i) {
                const double d_m = 0.003 + 0.001 * std::sin(0.02 * i) + (i % 700 < 350 ? 0.001 : 0.0);
                const double force_N = 200.0 * d_m + 150.0 * (d_m - dent_m) + 0.1;
                dent_m += (d_m - dent_m) * share;
                return Touched{0.0, d_m, {}, {0.0, 0.0, i % 7 == 0 ? nonsense_N : force_N}, i % 7 == 0};
            });
            QVERIFY2(about(yielding.rendered, time_s),
                     qPrintable(QStringLiteral("%1: %2").arg(time_s).arg(yielding.rendered)));
        }
    }
    /// Dry friction says itself once the bristles are bent over: after a turn so far as a trail of 1.5 times
    /// their length and half a millisecond takes to turn, and only of what is dragged faster than a hand
    /// trembles.
    void frictionIsOfWhatSlides() {
        constexpr double mu = 0.5, per_m = 0.001 * 0.041;
        const auto dragged = felt(ComparedAttribute::friction, mu, [&](int i) {
            const int stroke = i / 400, at = i % 400;
            const bool slow = stroke % 4 == 3; // 15 mm/s
            const double direction = stroke % 2 == 0 ? 1.0 : -1.0, v = slow ? 0.015 : 0.041;
            const double pressed_N = at < 150 || at >= 300 ? 2.0 : 2.0 + std::sin(0.05 * (at - 150));
            const double trail_m = 0.0005 + 1.5 * mu * 2.0 / 1000.0; // 2 mm
            const double way_m = (at + 1) * per_m;
            const bool bent = way_m > (stroke == 0 ? 1.0 : 2.0) * trail_m + 1e-9;
            return Touched{0.0,
                           0.001,
                           {v * direction, 0.0, 0.0},
                           {slow || !bent ? 0.3 : -mu * pressed_N * direction, 0.0, pressed_N}};
        });
        QVERIFY2(about(dragged.rendered, mu), qPrintable(QString::number(dragged.rendered)));
    }
    /// A trial is within a limit up to the limit itself; the first that is passed is named, in their order.
    void aMeasureAtItsLimitIsWithinIt() {
        psychophysics::FidelityLimits wide;
        wide.lateTicks = wide.saturated = wide.forceErrorRms_N = wide.stiffnessError = wide.peakForce_N =
            wide.meanSpeed_m_per_s = 1e9;
        const session::TrialFidelity f = underLimits(wide);
        QVERIFY2(f.outside.empty(), f.outside.c_str());
        QCOMPARE(f.lateTicks, 0.010);
        QVERIFY(about(f.worstLateness_us, 500.001));
        QCOMPARE(f.saturated, 0.020);
        QVERIFY(about(f.forceErrorRms_N, 0.05) && f.measured);
        QVERIFY(about(f.stiffnessError, 1.0 - 1.0 / 1.1, 1e-3));
        QCOMPARE(f.duration_s, 1.0);
        const psychophysics::FidelityLimits exact{f.forceErrorRms_N, f.stiffnessError, f.lateTicks,
                                                  f.saturated,       f.peakForce_N,    f.meanSpeed_m_per_s};
        QVERIFY2(underLimits(exact).outside.empty(), underLimits(exact).outside.c_str());
        const std::vector<std::pair<double psychophysics::FidelityLimits::*, std::string>> ordered{
            {&psychophysics::FidelityLimits::meanSpeed_m_per_s, "speed"},
            {&psychophysics::FidelityLimits::peakForce_N, "peak_force"},
            {&psychophysics::FidelityLimits::stiffnessError, "stiffness_error"},
            {&psychophysics::FidelityLimits::forceErrorRms_N, "force_error"},
            {&psychophysics::FidelityLimits::saturated, "saturation"},
            {&psychophysics::FidelityLimits::lateTicks, "late_ticks"}};
        psychophysics::FidelityLimits closer = exact;
        for (const auto& [limit, word] : ordered) { // each is named before those that were passed already
            closer.*limit = std::nextafter(exact.*limit, 0.0);
            QCOMPARE(underLimits(closer).outside, word);
        }
    }
    /// From a share of the limit on, until the hand has clearly eased; not out of contact or of a trial.
    void theLimitIsNearBeforeItIsReached() {
        session::FidelityMeter meter = meterOf(); // 4 N
        std::int64_t now_ns = 0;
        const auto near = [&](int place, double force_N) {
            meter.add(sampleOf(place, force_N, now_ns += 1'000'000));
            return meter.nearForceLimit();
        };
        QVERIFY(!near(1, 3.1));
        QVERIFY(near(1, 3.3));
        QVERIFY(near(1, 2.9));
        QVERIFY(!near(1, 2.7));
        QVERIFY(!near(1, 2.9));
        QVERIFY(near(1, 5.0));
        QVERIFY(!near(0, 5.0));
        QVERIFY(near(1, 5.0));
        session::FidelitySample after = sampleOf(1, 5.0, now_ns += 1'000'000);
        after.phase = core::TrialPhase::between;
        meter.add(after);
        QVERIFY(!meter.nearForceLimit());
    }

    /// What a participant is told must not change with the object that is touched.
    void whatWasNearStaysUntilTheTrialEnds() {
        simulation::ComparisonParameters parameters;
        parameters.places = 2;
        session::FidelityMeter meter(parameters, {}, false); // 4 N
        const std::vector<double> asked{kStiffness_N_per_m, kStiffness_N_per_m};
        meter.begin(asked);
        std::int64_t now_ns = 0;
        const auto came = [&](int place, double force_N) {
            meter.add(sampleOf(place, force_N, now_ns += 1'000'000));
            return meter.cameNearForceLimit();
        };
        QVERIFY(!came(1, 3.1));
        QVERIFY(!came(0, 3.3)); // of no object
        QVERIFY(came(1, 3.3));
        QVERIFY(came(0, 0.0));
        QVERIFY(came(2, 0.5) && !meter.nearForceLimit());
        session::FidelitySample paused = sampleOf(2, 0.5, now_ns += 1'000'000);
        paused.paused = 1;
        meter.add(paused);
        QVERIFY(meter.cameNearForceLimit());
        meter.begin(asked);
        QVERIFY(!meter.cameNearForceLimit());
        QVERIFY(!came(2, 0.5));
    }

    /// Where every place is to be touched, one that was not is the reason, before all others.
    void untouchedPlacesAreTold() {
        for (const int touched : {0b11, 0b01, 0b10}) {
            for (const bool mustTouchAll : {true, false}) {
                simulation::ComparisonParameters parameters;
                parameters.places = 2;
                session::FidelityMeter meter(parameters, {}, mustTouchAll);
                meter.begin({kStiffness_N_per_m, kStiffness_N_per_m});
                session::FidelitySample sample = sampleOf(0, 0.0, 1'000'000);
                for (const int bit : {1, 2}) { // one after the other
                    sample.touched = static_cast<std::uint8_t>(touched & bit);
                    sample.now_ns += 1'000'000;
                    meter.add(sample);
                }
                QCOMPARE(meter.finish().outside,
                         mustTouchAll && touched != 0b11 ? std::string("untouched") : std::string());
            }
        }
    }
    void tooMuchAtTheLimitIsSaturation() {
        QCOMPARE(pressed(0.010, 0.010).outside, std::string("saturation"));
    }
};

QTEST_APPLESS_MAIN(TestFidelityMeter)
#include "test_fidelity_meter.moc"
