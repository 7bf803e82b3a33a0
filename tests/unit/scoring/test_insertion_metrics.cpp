// SPDX-License-Identifier: GPL-3.0-or-later
// How an instrument went through its canal, against closed forms on made paths.
#include "core/contact_bits.h"
#include "insertion_traces.h"

#include <QtTest>
#include <algorithm>

using namespace chiron;
using namespace chiron::scoring;
using traces::CanalSample;
using traces::canalSession;
using traces::canalTrial;
using traces::metricOf;
using traces::ProcedureStage;
using traces::straightIn;
using traces::valueOf;
using traces::Vec3;

namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kDegree = kPi / 180.0;

bool isNear(double a, double b, double tolerance) {
    return std::abs(a - b) <= tolerance;
}

const std::vector<std::string> kOfTheCanal{
    "offset_rms",     "offset_max",     "alignment_rms",         "bend_alignment",      "trauma_events",
    "reversals",      "landmarks_seen", "inspection_travel",     "procedure_completed", "trauma_time",
    "trauma_impulse", "lateral_max",    "advance_while_turning", "curve_alignment",     "insertion_depth"};

/// Pressed aside with `lateral_N` from 1 s on for `time_s`.
SessionTrace pressed(double time_s, double lateral_N) {
    return canalSession(canalTrial(10.0, 0.001, [=](double t) {
        CanalSample sample;
        sample.s_m = 0.05;
        sample.lateral_N = t > 0.9995 && t < 0.9995 + time_s ? lateral_N : 0.1;
        return sample;
    }));
}

/// Straight in at 10 mm/s to the bend at 40 mm; there turned by 30° within 2 s, standing still or going on at
/// `while_m_per_s`, and then on.
TrialTrace turnedAtBend(double while_m_per_s) {
    const double from = 5.0, to = 7.0; // s
    TrialTrace trial = canalTrial(14.0, 0.001, [=](double t) {
        CanalSample sample;
        sample.s_m = -0.010 + 0.010 * std::min(t, from) +
                     while_m_per_s * std::clamp(t - from, 0.0, to - from) + 0.010 * std::max(0.0, t - to);
        return sample;
    });
    ToolTrace& tool = trial.tools.front();
    tool.tissueTorque_Nm.assign(tool.t_s.size(), Vec3::Zero());
    for (const double t : tool.t_s)
        tool.q_WT.emplace_back(Eigen::AngleAxisd(
            30.0 * kDegree * std::clamp((t - from) / (to - from), 0.0, 1.0), Vec3::UnitX()));
    return trial;
}

} // namespace

class TestInsertionMetrics : public QObject {
    Q_OBJECT
private slots:
    void perfectInsertion();
    void offsetOfASine();
    void alignmentOfAConstantTilt();
    void onlyInsideTheUrethra_data();
    void onlyInsideTheUrethra();
    void bendIsTenMillimetresEitherWay();
    void curveIsThirtyMillimetresPastTheBend();
    void bendIsOfTheInsertionOnly();
    void traumaAndReversalsAreCounted();
    void traumaHasTimeImpulseAndAWorstForce();
    void longOrHardTraumaIsACriticalError();
    void advanceWhileTurningIsOfTheBend();
    void pathIsMeasuredAlongTheCanal();
    void undefinedWithItsReason();
    void aTrialWithoutCanalIsNotLeftOut();
    void sessionsPoolTheirTrials();
    void pausesAreLeftOut();
    void badSeriesAreRefused();
    void catalogueTellsThem();
};

void TestInsertionMetrics::perfectInsertion() {
    const auto trace = canalSession(straightIn());
    QCOMPARE(valueOf(trace, "offset_rms"), 0.0);
    QCOMPARE(valueOf(trace, "offset_max"), 0.0);
    QCOMPARE(valueOf(trace, "alignment_rms"), 0.0);
    QCOMPARE(valueOf(trace, "bend_alignment"), 0.0);
    QCOMPARE(valueOf(trace, "trauma_events"), 0.0);
    QCOMPARE(valueOf(trace, "reversals"), 0.0);
    QCOMPARE(valueOf(trace, "insertion_depth"), 80.0);
}

void TestInsertionMetrics::offsetOfASine() {
    // In the urethra from 1 s on; 9 whole periods of |3 mm sin| over 9 s: RMS 3/√2 mm.
    const auto trace = canalSession(straightIn(
        [](CanalSample& sample, double t) { sample.offset_m = 0.003 * std::abs(std::sin(2.0 * kPi * t)); }));
    QVERIFY(isNear(valueOf(trace, "offset_rms"), 3.0 / std::sqrt(2.0), 3.0 / 9000.0));
    QVERIFY(isNear(valueOf(trace, "offset_max"), 3.0, 1e-9));
}

void TestInsertionMetrics::alignmentOfAConstantTilt() {
    const auto trace =
        canalSession(straightIn([](CanalSample& sample, double) { sample.alignment_rad = 12.5 * kDegree; }));
    QVERIFY(isNear(valueOf(trace, "alignment_rms"), 12.5, 1e-9));
    QVERIFY(isNear(valueOf(trace, "bend_alignment"), 12.5, 1e-9));
}

void TestInsertionMetrics::onlyInsideTheUrethra_data() {
    QTest::addColumn<int>("s_nm");
    QTest::addColumn<bool>("counts");
    QTest::newRow("before the entrance") << -1 << false;
    QTest::newRow("at the entrance") << 0 << true;
    QTest::newRow("at the bladder neck") << 110'000'000 << true;
    QTest::newRow("in the bladder") << 110'000'001 << false;
}

void TestInsertionMetrics::onlyInsideTheUrethra() {
    QFETCH(int, s_nm);
    QFETCH(bool, counts);
    for (const auto stage :
         {ProcedureStage::insertion, ProcedureStage::inspection, ProcedureStage::withdrawal}) {
        const auto trace = canalSession(canalTrial(0.1, 0.001, [=](double t) {
            const bool special = t > 0.0495 && t < 0.0505; // one sample of 101
            return CanalSample{
                special ? 1e-9 * s_nm : 0.050, special ? 0.007 : 0.0, special ? 0.7 : 0.0, 0.0, 0.0, stage};
        }));
        QCOMPARE(valueOf(trace, "offset_max") > 0.0, counts);
        QCOMPARE(valueOf(trace, "alignment_rms") > 0.0, counts);
        if (counts)
            QVERIFY(isNear(valueOf(trace, "offset_rms"), 7.0 / std::sqrt(101.0), 1e-9));
    }
}

void TestInsertionMetrics::bendIsTenMillimetresEitherWay() {
    // 10° there, 40° everywhere else; the ends at exactly 30 and 50 mm belong to it.
    const auto tilted = [](std::int64_t halfWidth_nm) {
        return canalSession(canalTrial(0.4, 0.001, [=](double t) {
            const std::int64_t s_nm =
                20'000'000 + 100'000 * std::lround(t * 1e3); // 20 to 60 mm in steps of 0.1 mm
            const bool near = std::abs(s_nm - 40'000'000) <= halfWidth_nm;
            CanalSample sample;
            sample.s_m = static_cast<double>(s_nm) * 1e-9;
            sample.alignment_rad = (near ? 10.0 : 40.0) * kDegree;
            return sample;
        }));
    };
    QVERIFY(isNear(valueOf(tilted(10'000'000), "bend_alignment"), 10.0, 1e-6));
    QVERIFY(valueOf(tilted(9'950'000), "bend_alignment") > 10.5); // both ends tilted more
    QVERIFY(isNear(valueOf(tilted(12'000'000), "bend_alignment"), 10.0, 1e-6));
    QVERIFY(valueOf(tilted(10'000'000), "alignment_rms") > 20.0);
}

void TestInsertionMetrics::curveIsThirtyMillimetresPastTheBend() {
    // 10° there, 40° everywhere else; the ends at exactly 40 and 70 mm belong to it.
    const auto tilted = [](std::int64_t from_nm, std::int64_t to_nm) {
        return canalSession(canalTrial(0.6, 0.001, [=](double t) {
            const std::int64_t s_nm =
                20'000'000 + 100'000 * std::lround(t * 1e3); // 20 to 80 mm in steps of 0.1 mm
            CanalSample sample;
            sample.s_m = static_cast<double>(s_nm) * 1e-9;
            sample.alignment_rad = (s_nm >= from_nm && s_nm <= to_nm ? 10.0 : 40.0) * kDegree;
            return sample;
        }));
    };
    QVERIFY(isNear(valueOf(tilted(40'000'000, 70'000'000), "curve_alignment"), 10.0, 1e-6));
    QVERIFY(valueOf(tilted(40'100'000, 70'000'000), "curve_alignment") > 10.1);
    QVERIFY(valueOf(tilted(40'000'000, 69'900'000), "curve_alignment") > 10.1);
}

void TestInsertionMetrics::bendIsOfTheInsertionOnly() {
    const auto trace = canalSession(canalTrial(1.0, 0.001, [](double) {
        CanalSample sample;
        sample.s_m = 0.040;
        sample.stage = ProcedureStage::withdrawal;
        return sample;
    }));
    QCOMPARE(metricOf(trace, "bend_alignment").reason, std::string("the tip was never at the bend"));
    QCOMPARE(valueOf(trace, "alignment_rms"), 0.0);
}

void TestInsertionMetrics::traumaAndReversalsAreCounted() {
    // 0.5 s over the limit in each of 3 s; two ways back of 4 mm.
    const auto trace = canalSession(canalTrial(3.0, 0.001, [](double t) {
        CanalSample sample;
        sample.s_m = 0.05 + 0.002 * std::cos(2.0 * kPi * t / 1.5);
        sample.lateral_N = std::fmod(t, 1.0) < 0.5 ? 2.2 : 0.3;
        return sample;
    }));
    QCOMPARE(valueOf(trace, "trauma_events"), 3.0);
    QCOMPARE(valueOf(trace, "reversals"), 2.0);
}

void TestInsertionMetrics::traumaHasTimeImpulseAndAWorstForce() {
    const auto once = pressed(6.0, 26.0); // counted once, as a touch would be
    QCOMPARE(valueOf(once, "trauma_events"), 1.0);
    QVERIFY(isNear(valueOf(once, "trauma_time"), 6.0, 0.0011));
    QVERIFY(isNear(valueOf(once, "trauma_impulse"), 156.0, 0.027));
    QCOMPARE(valueOf(once, "lateral_max"), 26.0);
    const auto below = pressed(6.0, 1.9);
    QVERIFY(valueOf(below, "trauma_time") == 0.0 && valueOf(below, "trauma_impulse") == 0.0 &&
            valueOf(below, "lateral_max") == 1.9);
    const auto twice = canalSession({pressed(0.5, 3.0).trials.front(), pressed(0.25, 2.5).trials.front()});
    QVERIFY(isNear(valueOf(twice, "trauma_time"), 0.75, 0.0021));
    QVERIFY(isNear(valueOf(twice, "trauma_impulse"), 1.5 + 0.625, 0.006));
    QCOMPARE(valueOf(twice, "lateral_max"), 3.0);
}

void TestInsertionMetrics::longOrHardTraumaIsACriticalError() {
    QCOMPARE(valueOf(pressed(6.0, 26.0), "critical_errors"), 1.0);
    QCOMPARE(valueOf(pressed(0.98, 4.0), "critical_errors"), 0.0); // a slip
    QCOMPARE(valueOf(pressed(1.02, 2.1), "critical_errors"), 1.0);
    QCOMPARE(valueOf(pressed(0.1, 4.1), "critical_errors"), 1.0);
    QCOMPARE(valueOf(pressed(0.01, 9.0), "critical_errors"), 0.0); // too short to be trauma
    auto broken = pressed(0.5, 4.5);
    auto& tool = broken.trials.front().tools.front();
    tool.contact.assign(tool.t_s.size(), 0);
    tool.contact[1200] =
        core::contact_bits::kThrough | core::contact_bits::kYielded; // within the trauma: the same error
    QCOMPARE(valueOf(broken, "critical_errors"), 1.0);
    tool.contact[5000] = core::contact_bits::kThrough | core::contact_bits::kYielded;
    QCOMPARE(valueOf(broken, "critical_errors"), 2.0);
    QCOMPARE(findMetric("critical_errors")->version, 2);
    QVERIFY(findMetric("critical_errors", 1) != nullptr);
}

void TestInsertionMetrics::advanceWhileTurningIsOfTheBend() {
    const auto turned = [](double speed) {
        return valueOf(canalSession(turnedAtBend(speed)), "advance_while_turning");
    };
    // A turn is seen 0.1 s before it begins and 0.1 s after it has ended, as far as it is half over there: at
    // 5°/s of 15°/s a third.
    QVERIFY2(isNear(turned(0.0), 0.0, 0.8), qPrintable(QString::number(turned(0.0))));
    QVERIFY2(isNear(turned(0.010), 20.0, 1.5), qPrintable(QString::number(turned(0.010))));
    QVERIFY(turned(0.005) > 9.0 && turned(0.005) < 12.0);
    TrialTrace late = turnedAtBend(0.010);
    insertionIn(late).bend_m = 0.005; // the same turn 35 mm behind it: no longer in the bend
    QCOMPARE(valueOf(canalSession(late), "advance_while_turning"), 0.0);
    TrialTrace out = turnedAtBend(0.010);
    for (auto& stage : insertionIn(out).stage)
        stage = static_cast<std::uint8_t>(ProcedureStage::withdrawal);
    QCOMPARE(metricOf(canalSession(out), "advance_while_turning").reason,
             std::string("the tip was never at the bend"));
}

void TestInsertionMetrics::pathIsMeasuredAlongTheCanal() {
    // In by 90 mm and out again, as an insertion goes: version 1 divides by next to nothing, version 2 by the
    // canal.
    const auto inAndOut = [](double aside_m) {
        TrialTrace trial = canalTrial(20.0, 0.001, [](double t) {
            CanalSample sample;
            sample.s_m = t < 10.0 ? 0.009 * t : 0.09 - 0.0084 * (t - 10.0);
            sample.stage = t < 10.0 ? ProcedureStage::insertion : ProcedureStage::withdrawal;
            return sample;
        });
        for (std::size_t i = 0; i < trial.tools.front().t_s.size(); ++i)
            trial.tools.front().p_WT_m[i].y() += aside_m * std::sin(2.0 * kPi * trial.tools.front().t_s[i]);
        return canalSession(trial);
    };
    QVERIFY2(std::abs(valueOf(inAndOut(0.0), "path_inefficiency")) < 0.5,
             qPrintable(QString::number(valueOf(inAndOut(0.0), "path_inefficiency"))));
    const double wavy = valueOf(inAndOut(0.001), "path_inefficiency");
    QVERIFY2(wavy > 8.0 && wavy < 15.0, qPrintable(QString::number(wavy))); // 1 mm at 1 Hz on 9 mm/s: 11 %
    QVERIFY(valueOf(inAndOut(0.0), "path_inefficiency", 1) > 1000.0);
}

void TestInsertionMetrics::undefinedWithItsReason() {
    const auto sphere =
        traces::session(traces::sampled(1.0, 0.001, [](double t) { return Vec3(t, 0.0, 0.0); }));
    for (const std::string& id : kOfTheCanal) {
        QVERIFY2(!metricOf(sphere, id).value, id.c_str());
        const bool any = id == "procedure_completed"; // not of canals alone
        QCOMPARE(metricOf(sphere, id).reason,
                 std::string(any ? "the trace has no procedure" : "the trace has no insertion data"));
    }
    const auto outside = canalSession(canalTrial(1.0, 0.001, [](double) { return CanalSample{-0.005}; }));
    for (const char* id : {"offset_rms", "offset_max", "alignment_rms"})
        QCOMPARE(metricOf(outside, id).reason, std::string("the tip was never in the urethra"));
    QCOMPARE(metricOf(outside, "inspection_travel").reason, std::string("the level has no landmarks"));
    auto asked = straightIn();
    insertionIn(asked).landmarkSeen_s = {std::numeric_limits<double>::quiet_NaN()};
    QCOMPARE(metricOf(canalSession(asked), "inspection_travel").reason,
             std::string("the inspection was not reached"));
}

void TestInsertionMetrics::aTrialWithoutCanalIsNotLeftOut() {
    auto blind = straightIn();
    blind.own.reset();
    const auto trace = canalSession({straightIn(), blind});
    for (const char* id :
         {"offset_rms", "offset_max", "alignment_rms", "bend_alignment", "trauma_events", "reversals"})
        QCOMPARE(metricOf(trace, id).reason, std::string("the trace has no insertion data"));
}

void TestInsertionMetrics::sessionsPoolTheirTrials() {
    const auto with = [](double duration_s, double offset_m, double alignment_rad, double lateral_N) {
        return canalTrial(duration_s, 0.001, [=](double) {
            return CanalSample{0.040, offset_m, alignment_rad, lateral_N, 0.0, ProcedureStage::insertion};
        });
    };
    // 1001 and 3001 samples.
    const auto trace = canalSession({with(1.0, 0.002, 0.1, 2.5), with(3.0, 0.004, 0.3, 2.5)});
    QVERIFY(isNear(valueOf(trace, "offset_rms"), std::sqrt((1001.0 * 4.0 + 3001.0 * 16.0) / 4002.0), 1e-9));
    QCOMPARE(valueOf(trace, "offset_max"), 4.0);
    const double angle = std::sqrt((1001.0 * 0.01 + 3001.0 * 0.09) / 4002.0) / kDegree;
    QVERIFY(isNear(valueOf(trace, "alignment_rms"), angle, 1e-6));
    QVERIFY(isNear(valueOf(trace, "bend_alignment"), angle, 1e-6));
    QCOMPARE(valueOf(trace, "trauma_events"), 2.0); // each trial begins anew
}

void TestInsertionMetrics::pausesAreLeftOut() {
    auto trial = canalTrial(3.0, 0.001, [](double t) {
        const bool wild = t > 0.9995 && t < 1.9995;
        return CanalSample{
            wild ? 0.070 : 0.040,     wild ? 0.009 : 0.001, wild ? 1.0 : 0.1, wild ? 3.9 : 0.0, 0.0,
            ProcedureStage::insertion};
    });
    const auto whole = canalSession(trial);
    QCOMPARE(valueOf(whole, "trauma_events"), 1.0);
    QCOMPARE(valueOf(whole, "reversals"), 1.0);
    QCOMPARE(valueOf(whole, "insertion_depth"), 70.0);
    for (std::size_t i = 1000; i < 2000; ++i)
        trial.tools[0].paused[i] = 1;
    const auto trace = canalSession(trial);
    QVERIFY(isNear(valueOf(trace, "offset_rms"), 1.0, 1e-9));
    QCOMPARE(valueOf(trace, "offset_max"), 1.0);
    QVERIFY(isNear(valueOf(trace, "alignment_rms"), 0.1 / kDegree, 1e-6));
    QCOMPARE(valueOf(trace, "trauma_events"), 0.0);
    QCOMPARE(valueOf(trace, "reversals"), 0.0);
    QCOMPARE(valueOf(trace, "insertion_depth"), 40.0);
}

void TestInsertionMetrics::badSeriesAreRefused() {
    const auto refused = [](const TrialTrace& trial) {
        const MetricRequest request{"offset_rms", 0};
        const auto card = calculateScore(canalSession(trial), {&request, 1}, {}, true);
        return !card && card.error().code == core::ErrorCode::badInput;
    };
    QVERIFY(!refused(straightIn()));
    auto trial = straightIn();
    insertionIn(trial).stage.pop_back();
    QVERIFY(refused(trial));
    trial = straightIn();
    insertionIn(trial).lateral_N.push_back(0.0);
    QVERIFY(refused(trial));
    trial = straightIn();
    trial.tools[0].tissueTorque_Nm.resize(3, Vec3::Zero());
    QVERIFY(refused(trial));
    trial = straightIn();
    insertionIn(trial).landmarkSeen_s.assign(kMostLandmarks + 1, 1.0);
    QVERIFY(refused(trial));
    trial = straightIn();
    trial.tools.clear();
    QVERIFY(refused(trial));
    trial = straightIn();
    insertionIn(trial).offset_m[5000] =
        std::numeric_limits<double>::quiet_NaN(); // the whole sample is left out
    QCOMPARE(valueOf(canalSession(trial), "offset_rms"), 0.0);
}

void TestInsertionMetrics::catalogueTellsThem() {
    auto ids = kOfTheCanal;
    ids.insert(ids.end(), {"torque_max", "torque_rms"});
    for (const std::string& id : ids) {
        const MetricDefinition* metric = findMetric(id);
        QVERIFY2(metric != nullptr, id.c_str());
        QCOMPARE(metric->version, id == "procedure_completed" ? 2 : 1);
        QVERIFY(!metric->unit.empty() && !metric->definition.empty() && !metric->source.empty());
        const bool more = id == "landmarks_seen" || id == "insertion_depth" || id == "procedure_completed";
        QVERIFY(metric->direction == (more ? Direction::higherIsBetter : Direction::lowerIsBetter));
    }
    QVERIFY(findMetric("trauma_events")->wrench == MetricWrench::tissue);
}

QTEST_APPLESS_MAIN(TestInsertionMetrics)
#include "test_insertion_metrics.moc"
