// SPDX-License-Identifier: GPL-3.0-or-later
#include "traces.h"

#include "core/random.h"
#include "core/units.h"

#include <QtTest>
#include <algorithm>
#include <map>

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

/// A wandering but smooth path: three incommensurable frequencies below 3 Hz.
Vec3 wander(double t) {
    return {0.03 * std::sin(2.0 * t), 0.02 * std::sin(5.1 * t + 1.0), 0.01 * std::sin(11.3 * t + 2.0)};
}

SessionTrace moved(const SessionTrace& trace, const core::Mat3& rotation, const Vec3& shift) {
    SessionTrace out = trace;
    for (auto& trial : out.trials)
        for (auto& tool : trial.tools)
            for (Vec3& p : tool.p_WT_m)
                p = rotation * p + shift;
    return out;
}

} // namespace

class TestMetrics : public QObject {
    Q_OBJECT
private slots:
    void pathOfCircle();
    void pathOfReachIsItsLength();
    void inefficiencyOfHalfCircle();
    void inefficiencyNeedsDistance();
    void pathIgnoresTranslationAndRotation();
    void smoothnessIgnoresTranslationRotationAndScale();
    void pathIgnoresTimeReversal();
    void pathScalesWithSpace();
    void stillHandTravelsLittle();
    void encoderStepsLeaveSmoothnessAlone();
    void slowTraceIsUsedAsItIs();
    void rateHardlyMatters();
    void reachIsSmootherThanShaking();
    void stillHandHasNoMovement();
    void timeStartsWithMovement();
    void timeStartsWithContactIfEarlier();
    void timeLeavesPausesOut();
    void pausedPathIsLeftOut();
    void unevenTimesAreInterpolated();
    void longGapEndsARun();
    void emptyTrialsHaveReasons();
    void everyRowIsWhole();
    void aBenchmarkStaysWithItsVersion();
};

void TestMetrics::pathOfCircle() {
    // Radius 50 mm, one turn in 4 s: far below the cut-off, so the length is 2πr to 0.1 % (edges, chord
    // length).
    const auto trace = session(sampled(4.0, 0.001, [](double t) {
        const double a = core::kPi / 2.0 * t;
        return Vec3(0.05 * std::cos(a), 0.05 * std::sin(a), 0.0);
    }));
    QVERIFY(std::abs(valueOf(trace, "path_length") / (2.0 * core::kPi * 50.0) - 1.0) < 1e-3);
}

void TestMetrics::pathOfReachIsItsLength() {
    QVERIFY(std::abs(valueOf(reachSession(), "path_length") - 100.0) < 0.1);
    QVERIFY(std::abs(valueOf(reachSession(), "path_inefficiency")) < 0.1);
}

void TestMetrics::inefficiencyOfHalfCircle() {
    const auto trace = session(sampled(2.0, 0.001, [](double t) {
        const double a = core::kPi / 2.0 * t;
        return Vec3(0.05 * std::cos(a), 0.05 * std::sin(a), 0.0);
    }));
    QVERIFY(std::abs(valueOf(trace, "path_inefficiency") - 100.0 * (core::kPi / 2.0 - 1.0)) < 0.2);
}

void TestMetrics::inefficiencyNeedsDistance() {
    const auto trace = session(sampled(5.0, 0.001, [](double t) { return reach(t, 0.0049, kX); }));
    const auto value = metricOf(trace, "path_inefficiency");
    QVERIFY(!value.value);
    QVERIFY(value.reason.find("5 mm") != std::string::npos);
    QVERIFY(metricOf(session(sampled(5.0, 0.001, [](double t) { return reach(t, 0.0051, kX); })),
                     "path_inefficiency")
                .value);
}

void TestMetrics::pathIgnoresTranslationAndRotation() {
    const auto trace = session(sampled(10.0, 0.001, wander));
    const core::Mat3 turn = Eigen::AngleAxisd(0.7, Vec3(1, 2, -0.5).normalized()).toRotationMatrix();
    const double before = valueOf(trace, "path_length");
    const double after = valueOf(moved(trace, turn, Vec3(0.2, -0.1, 0.05)), "path_length");
    // Rounding to 1 nm, low-passed: at most 1 nm a sample of 1000.
    QVERIFY(std::abs(before - after) < 1e-3);
}

void TestMetrics::smoothnessIgnoresTranslationRotationAndScale() {
    const auto trace = session(sampled(10.0, 0.001, wander));
    const core::Mat3 turn = Eigen::AngleAxisd(0.7, Vec3(1, 2, -0.5).normalized()).toRotationMatrix();
    for (const char* id : {"sparc", "ldlj"}) {
        const double before = valueOf(trace, id);
        QVERIFY(before < 0.0);
        QVERIFY(std::abs(before - valueOf(moved(trace, turn, Vec3(0.2, -0.1, 0.05)), id)) < 1e-3);
        QVERIFY(std::abs(before - valueOf(moved(trace, 2.0 * core::Mat3::Identity(), Vec3::Zero()), id)) <
                1e-3);
    }
}

void TestMetrics::pathIgnoresTimeReversal() {
    auto forward =
        sampled(10.0, 0.001, wander); // 10 s: whole decimated samples, so that both see the same instants
    auto backward = forward;
    std::reverse(backward.p_WT_m.begin(), backward.p_WT_m.end());
    const double a = valueOf(session(forward), "path_length");
    const double b = valueOf(session(backward), "path_length");
    QVERIFY2(std::abs(a - b) < 1e-6 * a, qPrintable(QString("%1 %2").arg(a, 0, 'g', 12).arg(b, 0, 'g', 12)));
}

void TestMetrics::pathScalesWithSpace() {
    const auto trace = session(sampled(10.0, 0.001, wander));
    const double one = valueOf(trace, "path_length");
    const double three = valueOf(moved(trace, 3.0 * core::Mat3::Identity(), Vec3::Zero()), "path_length");
    QVERIFY(std::abs(three / one - 3.0) < 1e-6);
}

// models.md §6: unfiltered 10 µm steps "travel" 0.95 m a minute. White noise of one step's uniform
// distribution at 1 kHz leaves 40 Hz of 1000 Hz's power at most, at a tenth of the samples.
void TestMetrics::stillHandTravelsLittle() {
    core::Random random(5);
    const auto noisy = [&](double) {
        Vec3 p = Vec3::Zero();
        for (int axis = 0; axis < 3; ++axis)
            p[axis] = 10e-6 * std::floor(random.uniform() * 2.0);
        return p;
    };
    const auto trace = session(sampled(60.0, 0.001, noisy));
    double raw_mm = 0.0;
    const auto& p = trace.trials[0].tools[0].p_WT_m;
    for (std::size_t i = 1; i < p.size(); ++i)
        raw_mm += 1e3 * (p[i] - p[i - 1]).norm();
    QVERIFY(raw_mm > 500.0);
    // σ of the filtered position ≤ 5 µm·√(2·20/1000)·√3 a step of two independent samples, 6000 of them.
    const double bound_mm = 6000.0 * 5e-3 * std::sqrt(40.0 / 1000.0) * std::sqrt(3.0) * std::sqrt(2.0);
    QVERIFY(valueOf(trace, "path_length") < bound_mm);
    QVERIFY(!metricOf(trace, "sparc").value);
}

// The same table says −4.3 truly and −22 with 10 µm steps, unfiltered: filtered, the steps must not show.
void TestMetrics::encoderStepsLeaveSmoothnessAlone() {
    const auto clean = reachSession();
    auto stepped = clean;
    for (Vec3& p : stepped.trials[0].tools[0].p_WT_m)
        p = (p / 10e-6).array().round().matrix() * 10e-6;
    QVERIFY(std::abs(valueOf(clean, "ldlj") - valueOf(stepped, "ldlj")) < 0.1);
    QVERIFY(std::abs(valueOf(clean, "sparc") - valueOf(stepped, "sparc")) < 0.02);
}

// At 50 Hz there is no filter: a zig-zag keeps its full length.
void TestMetrics::slowTraceIsUsedAsItIs() {
    const auto zigzag = [](double t) {
        return Vec3(0.001 * (static_cast<int>(std::lround(t / 0.02)) % 2), 0.0, 0.0);
    };
    QVERIFY(std::abs(valueOf(session(sampled(2.0, 0.02, zigzag)), "path_length") - 100.0) < 1e-6);
    const auto at100 = [](double t) {
        return Vec3(0.001 * (static_cast<int>(std::lround(t / 0.01)) % 2), 0.0, 0.0);
    };
    QVERIFY(std::abs(valueOf(session(sampled(2.0, 0.01, at100)), "path_length") - 200.0) < 1e-6);
}

void TestMetrics::rateHardlyMatters() {
    const double at1000 = valueOf(session(sampled(10.0, 0.001, wander)), "path_length");
    for (const double step_s : {0.0005, 0.002, 0.004, 0.008, 0.01})
        QVERIFY(std::abs(valueOf(session(sampled(10.0, step_s, wander)), "path_length") / at1000 - 1.0) <
                0.01);
}

// The same way in the same time, but in surges: four a second, never standing still in between.
void TestMetrics::reachIsSmootherThanShaking() {
    const auto surging = session(sampled(
        5.0, 0.001, [](double t) { return reach(t + 0.03 * std::sin(2.0 * core::kPi * 4.0 * t), 0.1, kX); }));
    for (const char* id : {"sparc", "ldlj"})
        QVERIFY(valueOf(reachSession(), id) > valueOf(surging, id) + 0.1);
}

void TestMetrics::stillHandHasNoMovement() {
    const auto trace = session(sampled(5.0, 0.001, [](double) { return Vec3(0.01, 0.0, 0.0); }));
    for (const char* id : {"sparc", "ldlj", "time"}) {
        const auto value = metricOf(trace, id);
        QVERIFY(!value.value);
        QVERIFY(value.reason.find("movement") != std::string::npos);
    }
    QCOMPARE(valueOf(trace, "path_length"), 0.0);
}

void TestMetrics::timeStartsWithMovement() {
    // 100 mm minimum-jerk reach in 1 s passes 5 mm/s at τ: 100·30τ²(1−τ)² = 5, τ = 0.0425 s. End 5 s.
    const double time_s = valueOf(reachSession(), "time");
    QVERIFY2(std::abs(time_s - (5.0 - 3.0425)) < 0.02, qPrintable(QString::number(time_s)));
}

void TestMetrics::timeStartsWithContactIfEarlier() {
    const auto force = [](double t) { return Vec3(0.0, 0.0, t > 0.9995 && t < 2.0 ? 0.021 : 0.019); };
    auto trace = session(sampled(
        5.0, 0.001, [](double t) { return reach(t, 0.1, kX); }, force));
    QVERIFY(std::abs(valueOf(trace, "time") - 4.0) < 1e-9);
}

void TestMetrics::timeLeavesPausesOut() {
    auto tool = sampled(5.0, 0.001, [](double t) { return reach(t, 0.1, kX); });
    const double whole_s = valueOf(session(tool), "time");
    for (std::size_t i = 4200; i < 4700; ++i)
        tool.paused[i] = 1;
    QVERIFY(std::abs(whole_s - valueOf(session(tool), "time") - 0.5) < 1e-9);
}

void TestMetrics::pausedPathIsLeftOut() {
    // Half the reach, then a second's pause in which the hand comes back, then the same half again.
    auto tool = sampled(
        3.0, 0.001,
        [](double t) {
            if (t < 1.0)
                return Vec3(0.05 * t, 0.0, 0.0);
            return t < 2.0 ? Vec3(0.05 * (2.0 - t), 0.0, 0.0) : Vec3(0.05 * (t - 2.0), 0.0, 0.0);
        },
        [](double t) { return Vec3(0.0, 0.0, t >= 1.0 && t < 2.0 ? 9.0 : 1.0); });
    for (std::size_t i = 1000; i < 2000; ++i)
        tool.paused[i] = 1;
    const auto trace = session(tool);
    QVERIFY(std::abs(valueOf(trace, "path_length") - 100.0) < 1.5); // a decimated step at each end
    QVERIFY(std::abs(valueOf(trace, "path_inefficiency")) < 1.0);
    QCOMPARE(valueOf(trace, "force_max"), 1.0);
}

void TestMetrics::unevenTimesAreInterpolated() {
    auto whole = sampled(10.0, 0.001, wander);
    ToolTrace thinned;
    core::Random random(9);
    for (std::size_t i = 0; i < whole.t_s.size(); ++i)
        if (i == 0 || random.uniform() > 0.2) {
            thinned.t_s.push_back(whole.t_s[i]);
            thinned.p_WT_m.push_back(whole.p_WT_m[i]);
            thinned.tissue_N.push_back(whole.tissue_N[i]);
            thinned.paused.push_back(0);
        }
    const double a = valueOf(session(whole), "path_length");
    QVERIFY(std::abs(valueOf(session(thinned), "path_length") / a - 1.0) < 1e-3);
}

void TestMetrics::longGapEndsARun() {
    auto tool = sampled(2.0, 0.001, [](double t) { return Vec3(t < 1.0 ? 0.0 : 0.5, 0.0, 0.0); });
    for (std::size_t i = 1000; i < tool.t_s.size(); ++i)
        tool.t_s[i] += 3.0;
    QVERIFY(valueOf(session(tool), "path_length") < 1e-6); // nobody knows what happened in those 3 s
}

void TestMetrics::everyRowIsWhole() {
    std::map<std::string_view, const MetricDefinition*> last;
    for (const MetricDefinition& metric : metricCatalogue()) {
        const char* id = metric.id.data();
        QVERIFY2(
            QRegularExpression(QStringLiteral("^[a-z][a-z0-9_]*$")).match(QString::fromLatin1(id)).hasMatch(),
            id);
        for (const std::string_view text : {metric.title, metric.meaning, metric.definition, metric.source})
            QVERIFY2(!text.empty() && text.front() != ' ' && text.back() != ' ', id);
        QVERIFY2(metric.wholly.empty() || (metric.unit == "%" && metric.wholly.back() != '.'), id);
        QVERIFY2(metric.meaning.back() == '.' && metric.title.back() != '.', id);
        QVERIFY2(metric.measure != nullptr, id);
        QVERIFY2(metric.chance.metric.empty() || findMetric(metric.chance.metric) != nullptr, id);
        QVERIFY2(!metric.published ||
                     (metric.published->low < metric.published->high && !metric.published->source.empty()),
                 id);
        const MetricDefinition*& before = last[metric.id];
        QVERIFY2(metric.version == (before ? before->version + 1 : 1), id);
        // A new version measures anew; what people call it and what it is counted in stay.
        QVERIFY2(!before || (metric.title == before->title && metric.meaning == before->meaning &&
                             metric.wholly == before->wholly && metric.unit == before->unit &&
                             metric.measure != before->measure),
                 id);
        before = &metric;
    }
    for (const char* force : {"force_max", "force_mean", "force_rms", "force_p95", "force_time_over_limit",
                              "force_impulse_over_limit"}) {
        QVERIFY2(findMetric(force, 1)->tools == MetricTools::first &&
                     findMetric(force, 2)->tools == MetricTools::all,
                 force); // as their definitions say
        QCOMPARE(toString(findMetric(force)->tools), std::string_view("all"));
    }
    QVERIFY(last.size() > 60);
}

/// A benchmark belongs to the version that measures what was published.
void TestMetrics::aBenchmarkStaysWithItsVersion() {
    const auto& published = findMetric("apex_error_mean", 1)->published;
    QVERIFY(published && std::abs(published->low - 2.9) < 1e-12 && std::abs(published->high - 25.5) < 1e-12);
    QVERIFY(!findMetric("apex_error_mean", 2)->published); // counts misses differently
}

void TestMetrics::emptyTrialsHaveReasons() {
    SessionTrace empty;
    SessionTrace noTools;
    noTools.trials.emplace_back();
    const auto oneSample = session(sampled(0.0, 0.001, [](double) { return Vec3::Zero().eval(); }));
    for (const SessionTrace& trace : {empty, noTools, oneSample})
        for (const MetricDefinition& metric : metricCatalogue()) {
            const auto value = metricOf(trace, std::string(metric.id));
            QVERIFY2(value.value.has_value() || !value.reason.empty(), metric.id.data());
            QVERIFY2(!value.value || std::isfinite(*value.value), metric.id.data());
        }
}

QTEST_APPLESS_MAIN(TestMetrics)
#include "test_metrics.moc"
