// SPDX-License-Identifier: GPL-3.0-or-later
#include "busy_session.h"
#include "scoring/trace_builder.h"
#include "scoring/trace_csv.h"

#include <QtTest>
#include <set>

using namespace chiron;
using namespace chiron::scoring;
using traces::busySession;
using traces::everyMetric;
using traces::sampled;
using traces::session;
using traces::Vec3;

namespace {

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
    void unfinishedTrialsAreInNoScore();
    void unfinishedTrialsComeThroughAFile();
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
                                              "curve_alignment",
                                              "trauma_time",
                                              "trauma_impulse",
                                              "lateral_max",
                                              "advance_while_turning",
                                              "torque_max",
                                              "torque_rms",
                                              "reversals",
                                              "landmarks_seen",
                                              "inspection_travel",
                                              "insertion_depth",
                                              "procedure_completed",
                                              "tension_error_rms",
                                              "tension_error_sd",
                                              "time_in_band",
                                              "retraction_time_in_band",
                                              "retraction_max",
                                              "over_stretches",
                                              "drops",
                                              "squeeze_max",
                                              "squeeze_time_over_limit",
                                              "placement_error",
                                              "weighing_correct",
                                              "weighing_correct_by_chance",
                                              "prediction_error_rms",
                                              "held_error_rms",
                                              "critical_errors",
                                              "palpation_hits",
                                              "palpation_misses",
                                              "palpation_false_alarms",
                                              "palpation_d_prime",
                                              "palpation_d_prime_low",
                                              "palpation_d_prime_high",
                                              "palpation_criterion",
                                              "palpation_roc_area",
                                              "localisation_error",
                                              "localisation_error_by_chance",
                                              "size_error",
                                              "size_error_by_chance",
                                              "hardness_order",
                                              "hardness_order_by_chance",
                                              "coverage",
                                              "force_band_time",
                                              "pressing_time",
                                              "searching_time",
                                              "apex_error_mean",
                                              "apex_error_mean_by_chance",
                                              "apex_error_sd",
                                              "apex_bias_x",
                                              "apex_bias_y",
                                              "apex_misses"};
    std::set<std::string_view> found;
    std::set<std::pair<std::string_view, int>> versions;
    for (const MetricDefinition& metric : metricCatalogue()) {
        found.insert(metric.id);
        QVERIFY(versions.insert({metric.id, metric.version}).second);
        QVERIFY(metric.version == 1 ||
                versions.contains({metric.id, metric.version - 1})); // the old ones stay
        QVERIFY(metric.measure != nullptr);
        QVERIFY(!metric.definition.empty() && !metric.source.empty());
        QVERIFY(findMetric(metric.id)->version >= metric.version);
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
    const std::vector<MetricRequest> requests{
        {"time", 1}, {"force_max", 1}, {"time", 0}, {"sparc", 1}, {"force_mean", 0}};
    const auto card = calculateScore(busySession(), requests, {}, true);
    QVERIFY(card.has_value());
    QCOMPARE(card->metrics.size(), std::size_t{4}); // the same metric once
    QCOMPARE(card->metrics[0].id, std::string("time"));
    QCOMPARE(card->metrics[1].id, std::string("force_max"));
    QCOMPARE(card->metrics[2].id, std::string("sparc"));
    QCOMPARE(card->metrics[1].version, 1);
    QCOMPARE(card->metrics[3].version, 2); // the newest
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

// A trial that was cut off changes nothing that the session scores, and has no values of its own.
void TestScoreCalculator::unfinishedTrialsAreInNoScore() {
    auto whole = busySession();
    auto cut = whole;
    whole.trials.pop_back();
    cut.trials.back().unfinished = true;
    const auto all = everyMetric();
    const auto expected = calculateScore(whole, all, {}, true);
    const auto card = calculateScore(cut, all, {}, true);
    QVERIFY(expected && card);
    QCOMPARE(card->trials.size(), std::size_t{3});
    for (std::size_t i = 0; i < all.size(); ++i) {
        QCOMPARE(card->metrics[i].value, expected->metrics[i].value);
        QVERIFY(!card->trials[2][i].value);
        QCOMPARE(card->trials[2][i].reason, std::string("the trial was not finished"));
        QCOMPARE(card->trials[1][i].value, expected->trials[1][i].value);
    }
    for (TrialTrace& trial : cut.trials)
        trial.unfinished = true;
    const Gate slow = gate("time", {}, 1e9);
    const auto none = calculateScore(cut, all, {&slow, 1}, true);
    QVERIFY(none && !none->passed);
    for (const MetricValue& metric : none->metrics) {
        QVERIFY(!metric.value);
        QCOMPARE(metric.reason, std::string("no trial was finished"));
    }
}

void TestScoreCalculator::unfinishedTrialsComeThroughAFile() {
    auto trace = busySession();
    trace.trials.back().unfinished = true;
    trace.plannedTrials = 7;
    const auto rows = readTraceCsv(writeTraceCsv(rowsOf(trace)), "made.csv");
    QVERIFY(rows);
    const auto read = buildSessionTrace(*rows, "sphere_apex");
    QVERIFY(read);
    QCOMPARE(read->plannedTrials, 7);
    QVERIFY(!read->trials.at(1).unfinished && read->trials.at(2).unfinished);
    trace.trials.back().unfinished = false; // a file without the column: all count
    const std::string without = writeTraceCsv(rowsOf(trace));
    QVERIFY(without.find("unfinished") == std::string::npos);
}

QTEST_APPLESS_MAIN(TestScoreCalculator)
#include "test_score_calculator.moc"
