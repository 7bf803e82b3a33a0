// SPDX-License-Identifier: GPL-3.0-or-later
#include "traces.h"

#include "scoring/trace_builder.h"
#include "scoring/trace_csv.h"

#include "core/random.h"

#include <QtTest>
#include <bit>
#include <set>

using namespace chiron;
using namespace chiron::scoring;
using traces::sampled;
using traces::session;
using traces::Vec3;

namespace {

/// Three trials of two tools with unrounded doubles, a pause and packets read twice.
SessionTrace busySession() {
    core::Random random(21);
    SessionTrace trace;
    trace.exercise = "sphere_apex";
    trace.forceLimit_N = 1.5;
    for (int k = 0; k < 3; ++k) {
        TrialTrace trial;
        trial.trial = k;
        for (int toolIndex = 0; toolIndex < 2; ++toolIndex) {
            ToolTrace tool = sampled(
                3.0, 0.001,
                [&](double t) {
                    return Vec3(0.03 * std::sin(3 * t + k), 0.02 * std::cos(2 * t),
                                0.01 + 1e-5 * random.normal());
                },
                [&](double t) {
                    return Vec3(0.1 * random.normal(), 0.0, std::max(0.0, 2.0 * std::sin(4.0 * t)));
                });
            for (double& t : tool.t_s)
                t += 5.0 * k + 1e-8 * random.normal();
            for (std::size_t i = 1500; i < 1700; ++i)
                tool.paused[i] = 1;
            tool.t_s[40] = tool.t_s[39];
            tool.commanded_N = tool.tissue_N;
            trial.tools.push_back(std::move(tool));
        }
        trial.marked = k != 2;
        trial.timedOut = k == 2;
        trial.markInContact = true;
        trial.p_WMark_m = trial.tools[0].p_WT_m.back();
        trial.apex = ApexTruth{0.03 * random.uniform(), -0.03 * random.uniform(), 0.020};
        trace.trials.push_back(std::move(trial));
    }
    return trace;
}

std::vector<MetricRequest> everyMetric() {
    std::vector<MetricRequest> all;
    for (const MetricDefinition& metric : metricCatalogue())
        all.push_back({std::string(metric.id), metric.version});
    return all;
}

bool sameBits(const std::optional<double>& a, const std::optional<double>& b) {
    return a.has_value() == b.has_value() &&
           (!a || std::bit_cast<std::uint64_t>(*a) == std::bit_cast<std::uint64_t>(*b));
}

bool sameScores(const ScoreCard& a, const ScoreCard& b) {
    if (a.metrics.size() != b.metrics.size() || a.trials.size() != b.trials.size() || a.passed != b.passed)
        return false;
    for (std::size_t i = 0; i < a.metrics.size(); ++i)
        if (!sameBits(a.metrics[i].value, b.metrics[i].value))
            return false;
    for (std::size_t k = 0; k < a.trials.size(); ++k)
        for (std::size_t i = 0; i < a.trials[k].size(); ++i)
            if (!sameBits(a.trials[k][i].value, b.trials[k][i].value))
                return false;
    return true;
}

Gate gate(const std::string& metric, std::optional<double> minimum, std::optional<double> maximum) {
    return {metric, minimum, maximum};
}

} // namespace

class TestScoreCalculator : public QObject {
    Q_OBJECT
private slots:
    void catalogueIsComplete();
    void unknownMetricIsRefused();
    void unequalColumnsAreRefused();
    void orderAndVersionsAreKept();
    void aggregatesAreAsTheCatalogueSays();
    void gatesAreInclusive();
    void onlyCompletedSessionsPass();
    void gateOnAbsentValueDoesNotHold();
    void gatedMetricIsAdded();
    void bothEndsOfAGateCount();
    void sameTraceSameBits();
    void exportedTraceScoresTheSame();
    void storedGridsAreIdempotent();
    void repeatedPacketsChangeNothing();
};

void TestScoreCalculator::catalogueIsComplete() {
    const std::set<std::string_view> expected{"time",
                                              "path_length",
                                              "path_inefficiency",
                                              "sparc",
                                              "ldlj",
                                              "force_max",
                                              "force_mean",
                                              "force_rms",
                                              "force_p95",
                                              "force_peak_rate",
                                              "force_impulse_over_limit",
                                              "force_time_over_limit",
                                              "offset_rms",
                                              "offset_max",
                                              "alignment_rms",
                                              "bend_alignment",
                                              "trauma_events",
                                              "torque_max",
                                              "torque_rms",
                                              "reversals",
                                              "landmarks_seen",
                                              "inspection_travel",
                                              "insertion_depth",
                                              "apex_error_mean",
                                              "apex_error_sd",
                                              "apex_bias_x",
                                              "apex_bias_y",
                                              "apex_misses"};
    std::set<std::string_view> found;
    for (const MetricDefinition& metric : metricCatalogue()) {
        QVERIFY(found.insert(metric.id).second); // one version of each so far
        QVERIFY(metric.measure != nullptr);
        QVERIFY(!metric.definition.empty() && !metric.source.empty());
        QCOMPARE(findMetric(metric.id), &metric);
        QCOMPARE(findMetric(metric.id, metric.version), &metric);
        QCOMPARE(findMetric(metric.id, 99), nullptr);
    }
    QVERIFY(found == expected);
}

void TestScoreCalculator::unknownMetricIsRefused() {
    const auto trace = busySession();
    const MetricRequest unknown{"apex_luck", 0};
    const MetricRequest future{"sparc", 7};
    const auto a = calculateScore(trace, {&unknown, 1}, {}, true);
    const auto b = calculateScore(trace, {&future, 1}, {}, true);
    const Gate lost = gate("no_such", {}, 1.0);
    const auto c = calculateScore(trace, {}, {&lost, 1}, true);
    QVERIFY(!a && a.error().message.find("apex_luck") != std::string::npos);
    QVERIFY(!b && b.error().message.find("version 7") != std::string::npos);
    QVERIFY(!c && c.error().message.find("no_such") != std::string::npos);
}

void TestScoreCalculator::unequalColumnsAreRefused() {
    auto trace = busySession();
    trace.trials[1].tools[0].tissue_N.pop_back();
    const auto all = everyMetric();
    QVERIFY(!calculateScore(trace, all, {}, true));
}

void TestScoreCalculator::orderAndVersionsAreKept() {
    const std::vector<MetricRequest> requests{{"time", 1}, {"force_max", 0}, {"time", 0}, {"sparc", 1}};
    const auto card = calculateScore(busySession(), requests, {}, true);
    QVERIFY(card.has_value());
    QCOMPARE(card->metrics.size(), std::size_t{3}); // the same metric once
    QCOMPARE(card->metrics[0].id, std::string("time"));
    QCOMPARE(card->metrics[1].id, std::string("force_max"));
    QCOMPARE(card->metrics[2].id, std::string("sparc"));
    QCOMPARE(card->metrics[1].version, 1);
    QCOMPARE(card->trials.size(), std::size_t{3});
}

void TestScoreCalculator::aggregatesAreAsTheCatalogueSays() {
    const auto card = calculateScore(busySession(), everyMetric(), {}, true);
    QVERIFY(card.has_value());
    for (std::size_t i = 0; i < card->metrics.size(); ++i) {
        const auto* metric = findMetric(card->metrics[i].id);
        double sum = 0.0;
        double largest = -1e300;
        for (const auto& trial : card->trials) {
            sum += trial[i].value.value_or(0.0);
            largest = std::max(largest, trial[i].value.value_or(-1e300));
        }
        if (metric->aggregate == Aggregate::sum)
            QVERIFY(std::abs(*card->metrics[i].value - sum) < 1e-12);
        if (metric->aggregate == Aggregate::maximum)
            QCOMPARE(*card->metrics[i].value, largest);
    }
    QVERIFY(findMetric("time")->aggregate == Aggregate::sum);
    QVERIFY(findMetric("force_max")->aggregate == Aggregate::maximum);
}

void TestScoreCalculator::gatesAreInclusive() {
    const auto trace = session(sampled(
        1.0, 0.001, [](double) { return Vec3::Zero().eval(); }, [](double) { return Vec3(0.0, 0.0, 2.0); }));
    const std::vector<std::pair<Gate, bool>> cases{
        {gate("force_max", {}, 2.0), true},  {gate("force_max", {}, 1.999), false},
        {gate("force_max", 2.0, {}), true},  {gate("force_max", 2.001, {}), false},
        {gate("force_max", 1.0, 3.0), true}, {gate("force_max", 3.0, 4.0), false}};
    for (const auto& [g, passes] : cases) {
        const auto card = calculateScore(trace, {}, {&g, 1}, true);
        QVERIFY(card.has_value());
        QCOMPARE(card->passed, passes);
        QCOMPARE(card->metrics.at(0).passed.value(), passes);
    }
}

void TestScoreCalculator::onlyCompletedSessionsPass() {
    const Gate easy = gate("force_max", {}, 100.0);
    QVERIFY(calculateScore(busySession(), {}, {&easy, 1}, true)->passed);
    const auto stopped = calculateScore(busySession(), {}, {&easy, 1}, false);
    QVERIFY(!stopped->passed);
    QVERIFY(stopped->metrics[0].passed.value()); // the gate itself held
}

void TestScoreCalculator::gateOnAbsentValueDoesNotHold() {
    const auto trace = session(sampled(1.0, 0.001, [](double) { return Vec3::Zero().eval(); }));
    const Gate g = gate("sparc", -100.0, {});
    const auto card = calculateScore(trace, {}, {&g, 1}, true);
    QVERIFY(card.has_value() && !card->passed && !card->metrics[0].passed.value());
}

void TestScoreCalculator::gatedMetricIsAdded() {
    const MetricRequest request{"time", 0};
    const Gate g = gate("force_max", {}, 100.0);
    const auto card = calculateScore(busySession(), {&request, 1}, {&g, 1}, true);
    QCOMPARE(card->metrics.size(), std::size_t{2});
    QVERIFY(!card->metrics[0].passed.has_value());
    QVERIFY(card->metrics[1].passed.has_value());
}

void TestScoreCalculator::bothEndsOfAGateCount() {
    const std::vector<Gate> gates{gate("force_max", {}, 100.0), gate("force_max", 99.0, {})};
    const auto card = calculateScore(busySession(), {}, gates, true);
    QVERIFY(!card->passed && !card->metrics[0].passed.value());
}

void TestScoreCalculator::sameTraceSameBits() {
    const auto all = everyMetric();
    QVERIFY(sameScores(*calculateScore(busySession(), all, {}, true),
                       *calculateScore(busySession(), all, {}, true)));
}

// cli.md: the same score live and from the exported trace.
void TestScoreCalculator::exportedTraceScoresTheSame() {
    const auto all = everyMetric();
    const auto trace = busySession();
    const auto live = calculateScore(trace, all, {}, true);
    const std::string csv = writeTraceCsv(rowsOf(trace));
    const auto rows = readTraceCsv(csv, "exported.csv");
    QVERIFY2(rows.has_value(), rows ? "" : rows.error().message.c_str());
    const auto again = buildSessionTrace(*rows, "sphere_apex");
    QVERIFY(again.has_value());
    QCOMPARE(again->forceLimit_N, 1.5);
    const auto fromFile = calculateScore(*again, all, {}, true);
    QVERIFY(fromFile.has_value());
    QVERIFY(sameScores(*live, *fromFile));
    QVERIFY(writeTraceCsv(*rows) == csv);
    for (const auto& metric : live->metrics) { // the comparison above was about numbers
        const bool needsCanal =
            metric.reason == "the trace has no insertion data" || metric.reason == "the trace has no torques";
        QVERIFY2(metric.value.has_value() != needsCanal, metric.id.c_str());
    }
}

void TestScoreCalculator::storedGridsAreIdempotent() {
    core::Random random(3);
    for (int i = 0; i < 100000; ++i) {
        const double x = random.uniform(-1.0, 1.0) * std::pow(10.0, random.uniform(-9.0, 2.0));
        for (const auto& grid : {onMicroseconds, onNanometres, onMillinewtons}) {
            const double once = grid(x);
            QCOMPARE(std::bit_cast<std::uint64_t>(grid(once)), std::bit_cast<std::uint64_t>(once));
        }
        QVERIFY(std::abs(onNanometres(x) - x) <= 0.5e-9 * (1.0 + 1e-6));
    }
    QVERIFY(!std::signbit(onNanometres(-1e-12)));
}

void TestScoreCalculator::repeatedPacketsChangeNothing() {
    const auto all = everyMetric();
    auto trace = busySession();
    const auto before = calculateScore(trace, all, {}, true);
    for (auto& trial : trace.trials)
        for (auto& tool : trial.tools)
            for (std::size_t at : {std::size_t{100}, std::size_t{2000}}) {
                const auto i = static_cast<std::ptrdiff_t>(at);
                tool.t_s.insert(tool.t_s.begin() + i, tool.t_s[at - 1]);
                tool.p_WT_m.insert(tool.p_WT_m.begin() + i, Vec3(tool.p_WT_m[at - 1]));
                tool.tissue_N.insert(tool.tissue_N.begin() + i, Vec3(9.0, 9.0, 9.0));
                tool.commanded_N.insert(tool.commanded_N.begin() + i, Vec3::Zero().eval());
                tool.paused.insert(tool.paused.begin() + i, std::uint8_t{0});
            }
    QVERIFY(sameScores(*before, *calculateScore(trace, all, {}, true)));
}

QTEST_APPLESS_MAIN(TestScoreCalculator)
#include "test_score_calculator.moc"
