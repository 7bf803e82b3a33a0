// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact_bits.h"
#include "scoring/trace_builder.h"
#include "scoring/trace_csv.h"
#include "traces.h"

#include <QtTest>

using namespace chiron;
using namespace chiron::scoring;
using traces::metricOf;
using traces::reach;
using traces::sampled;
using traces::session;
using traces::valueOf;
using traces::Vec3;

namespace {

const Vec3 kX(1.0, 0.0, 0.0);

SessionTrace reachSession(double step_s = 0.001) {
    return session(sampled(5.0, step_s, [](double t) { return reach(t, 0.1, kX); }));
}

TrialTrace apexTrial(double x_mm, double y_mm, bool contact = true) {
    TrialTrace trial;
    trial.tools.push_back(sampled(0.2, 0.001, [=](double) { return Vec3(x_mm / 1e3, y_mm / 1e3, 0.02); }));
    trial.marked = true;
    trial.markInContact = contact;
    trial.p_WMark_m = Vec3(x_mm / 1e3, y_mm / 1e3, 0.02);
    trial.target = TargetTruth{0.010, -0.005, 0.020};
    return trial;
}

} // namespace

class TestForceAndApexMetrics : public QObject {
    Q_OBJECT
private slots:
    void forceStatisticsOfKnownSamples();
    void forceRateAndImpulse();
    void forceNeedsContact();
    void brokenTissueKeepsTheForceThatBrokeIt();
    void everyToolCounts();
    void tissueThatGaveWayIsCounted();
    void apexErrorsOfKnownMarks();
    void apexMissesAreKeptAndCounted();
    void apexWithoutMarkScoresLastPosition();
    void apexWithoutTruthHasReason();
};

void TestForceAndApexMetrics::forceStatisticsOfKnownSamples() {
    // ‖f‖ = 0, 0.02, 3, 4, 5 N at 10 ms.
    auto tool = sampled(0.04, 0.01, [](double) { return Vec3::Zero().eval(); });
    tool.tissue_N = {Vec3::Zero(), Vec3(0, 0, 0.02), Vec3(0, 3, 0), Vec3(4, 0, 0), Vec3(3, 4, 0)};
    const auto trace = session(tool);
    QCOMPARE(valueOf(trace, "force_max"), 5.0);
    QCOMPARE(valueOf(trace, "force_mean", 1), 4.0);
    QVERIFY(std::abs(valueOf(trace, "force_rms", 1) - std::sqrt((0.0004 + 9.0 + 16.0 + 25.0) / 5.0)) < 1e-12);
    QVERIFY(std::abs(valueOf(trace, "force_p95", 1) - 4.8) < 1e-12); // place 0.95·4 = 3.8 between 4 and 5
    // Over the time of touching: 10 ms each at 3 and 4 N; the last sample is held for no time.
    QVERIFY(std::abs(valueOf(trace, "force_mean") - 3.5) < 1e-12);
    QVERIFY(std::abs(valueOf(trace, "force_rms") - std::sqrt((9.0 + 16.0) / 2.0)) < 1e-12);
    QCOMPARE(valueOf(trace, "force_p95"), 4.0);
}

void TestForceAndApexMetrics::forceRateAndImpulse() {
    auto trace = session(sampled(
        1.0, 0.001, [](double) { return Vec3::Zero().eval(); },
        [](double t) { return Vec3(0.0, 0.0, t < 0.4995 ? 10.0 * t : (t < 0.7495 ? 5.0 : 1.0)); }));
    trace.forceLimit_N = 4.0;
    QVERIFY(std::abs(valueOf(trace, "force_peak_rate") - 4000.0) < 1e-6); // 5 N to 1 N in 1 ms
    // Over 4 N from t = 0.401 to 0.750 s; impulse Σ 10t·dt over 0.401…0.499 plus 5 N · 0.25 s.
    QVERIFY(std::abs(valueOf(trace, "force_time_over_limit") - 0.349) < 1e-9);
    QVERIFY(std::abs(valueOf(trace, "force_impulse_over_limit") -
                     (0.01 * 0.5 * (401 + 499) * 99 / 1000.0 + 1.25)) < 1e-9);
}

void TestForceAndApexMetrics::forceNeedsContact() {
    const auto trace = reachSession();
    QVERIFY(!metricOf(trace, "force_mean").value);
    QCOMPARE(metricOf(trace, "force_mean").reason, std::string("no contact"));
    QCOMPARE(valueOf(trace, "force_max"), 0.0);
    QCOMPARE(valueOf(trace, "force_impulse_over_limit"), 0.0);
}

// 3 N, then through at 6 N: until the tool is out (10 ms of 2 N falling, 20 ms of none) the load is 6 N.
// Unbroken tissue scores as before.
void TestForceAndApexMetrics::brokenTissueKeepsTheForceThatBrokeIt() {
    using namespace core::contact_bits;
    auto tool = sampled(0.06, 0.01, [](double) { return Vec3::Zero().eval(); });
    tool.tissue_N = {Vec3(0, 0, 3), Vec3(0, 0, 6), Vec3(0, 0, 2), Vec3::Zero(),
                     Vec3::Zero(),  Vec3::Zero(),  Vec3::Zero()};
    tool.contact = {0, kYielded | kThrough, kThrough, kThrough, kThrough, 0, 0};
    auto trace = session(tool);
    trace.forceLimit_N = 4.0;
    QVERIFY(std::abs(valueOf(trace, "force_time_over_limit") - 0.04) < 1e-12);
    QVERIFY(std::abs(valueOf(trace, "force_time_over_limit", 1) - 0.01) < 1e-12);
    QVERIFY(std::abs(valueOf(trace, "force_impulse_over_limit") - 0.24) < 1e-12);
    QVERIFY(std::abs(valueOf(trace, "force_mean") - (3.0 + 4.0 * 6.0) / 5.0) < 1e-12);
    QVERIFY(std::abs(valueOf(trace, "force_rms") - std::sqrt((9.0 + 4.0 * 36.0) / 5.0)) < 1e-12);
    QCOMPARE(valueOf(trace, "force_p95"), 6.0);
    QCOMPARE(valueOf(trace, "force_max"), 6.0);
    trace.trials.front().tools.front().contact.assign(7, 0);
    QCOMPARE(valueOf(trace, "force_time_over_limit"), valueOf(trace, "force_time_over_limit", 1));
    QCOMPARE(valueOf(trace, "force_impulse_over_limit"), valueOf(trace, "force_impulse_over_limit", 1));
}

void TestForceAndApexMetrics::everyToolCounts() {
    const auto nowhere = [](double) { return Vec3::Zero().eval(); };
    auto trace = session(sampled(0.05, 0.01, nowhere, [](double) { return Vec3(0.0, 0.0, 1.0); }));
    trace.forceLimit_N = 4.0;
    trace.trials.front().tools.push_back(
        sampled(0.05, 0.01, nowhere, [](double) { return Vec3(0.0, 5.0, 0.0); }));
    QCOMPARE(valueOf(trace, "force_max"), 5.0);
    QVERIFY(std::abs(valueOf(trace, "force_time_over_limit") - 0.05) < 1e-12);
    QVERIFY(std::abs(valueOf(trace, "force_impulse_over_limit") - 0.25) < 1e-12);
    QVERIFY(std::abs(valueOf(trace, "force_mean") - 3.0) < 1e-12);
    QCOMPARE(valueOf(trace, "force_time_over_limit", 1), 0.0);
}

// Twice under the first tool, once under the second; what gave way before the trial is none of its own; a
// file tells the same.
void TestForceAndApexMetrics::tissueThatGaveWayIsCounted() {
    using namespace core::contact_bits;
    const auto still = [](double) { return Vec3(0.0, 0.0, 0.01); };
    auto first = sampled(0.009, 0.001, still);
    auto second = sampled(0.009, 0.001, still);
    constexpr auto kNow = static_cast<std::uint8_t>(kYielded | kThrough);
    first.contact = {kThrough, kThrough, 0, kBeyondChecked, kNow,
                     kThrough, 0,        0, kThrough,       kThrough}; // the last without its first tick
    second.contact = {kNow, kThrough, kThrough, 0, 0, 0, 0, 0, 0, 0};
    auto trace = session(first);
    trace.trials.front().tools.push_back(second);
    QCOMPARE(valueOf(trace, "critical_errors"), 3.0);
    const auto rows = readTraceCsv(writeTraceCsv(rowsOf(trace)), "again.csv");
    QVERIFY2(rows.has_value(), rows ? "" : rows.error().message.c_str());
    const auto again = buildSessionTrace(*rows, trace.exercise, 4.0);
    QVERIFY(again.has_value());
    QCOMPARE(again->trials.front().tools[0].contact, first.contact);
    QCOMPARE(valueOf(*again, "critical_errors"), 3.0);
    QCOMPARE(valueOf(reachSession(), "critical_errors"), 0.0); // a file without the column
}

void TestForceAndApexMetrics::apexErrorsOfKnownMarks() {
    SessionTrace trace;
    // Truth (10, −5), R 20: errors (+10 %, −20 %) and (−30 %, 0 %).
    trace.trials = {apexTrial(12.0, -9.0), apexTrial(4.0, -5.0)};
    trace.trials[1].trial = 1;
    const double mean = (10.0 + 20.0 + 30.0 + 0.0) / 4.0;
    QVERIFY(std::abs(valueOf(trace, "apex_error_mean") - mean) < 1e-9);
    QVERIFY(std::abs(valueOf(trace, "apex_error_sd") - std::sqrt((25.0 + 25.0 + 225.0 + 225.0) / 3.0)) <
            1e-9);
    QVERIFY(std::abs(valueOf(trace, "apex_bias_x") + 10.0) < 1e-9);
    QVERIFY(std::abs(valueOf(trace, "apex_bias_y") + 10.0) < 1e-9);
    QCOMPARE(valueOf(trace, "apex_misses"), 0.0);
}

void TestForceAndApexMetrics::apexMissesAreKeptAndCounted() {
    SessionTrace trace;
    trace.trials = {apexTrial(10.0, -5.0), apexTrial(10.0, -5.0, false), apexTrial(10.0, 25.0),
                    apexTrial(10.0, 15.0)};
    QCOMPARE(valueOf(trace, "apex_misses"), 2.0); // out of contact; 30 mm away; exactly R is no miss
    QVERIFY(std::abs(valueOf(trace, "apex_error_mean", 1) - (150.0 + 100.0) / 8.0) < 1e-9);
    // A miss counts with R at least on each axis: 0, 0; 100, 100; 100, 150; 0, 100.
    QVERIFY(std::abs(valueOf(trace, "apex_error_mean") - (100.0 + 100.0 + 100.0 + 150.0 + 100.0) / 8.0) <
            1e-9);
}

void TestForceAndApexMetrics::apexWithoutMarkScoresLastPosition() {
    SessionTrace trace;
    trace.trials = {apexTrial(12.0, -5.0)};
    trace.trials[0].marked = false;
    trace.trials[0].timedOut = true;
    trace.trials[0].p_WMark_m = Vec3::Zero();
    QVERIFY(std::abs(valueOf(trace, "apex_bias_x") - 10.0) < 1e-9);
    QCOMPARE(valueOf(trace, "apex_misses"), 1.0);
}

void TestForceAndApexMetrics::apexWithoutTruthHasReason() {
    SessionTrace trace;
    trace.trials = {apexTrial(12.0, -5.0), apexTrial(12.0, -5.0)};
    trace.trials[1].target.reset();
    for (const char* id : {"apex_error_mean", "apex_error_sd", "apex_bias_x", "apex_bias_y", "apex_misses"}) {
        QVERIFY(!metricOf(trace, id).value); // no silent leaving out of a trial
        QVERIFY(metricOf(trace, id).reason.find("not known") != std::string::npos);
    }
}

QTEST_APPLESS_MAIN(TestForceAndApexMetrics)
#include "test_force_and_apex_metrics.moc"
