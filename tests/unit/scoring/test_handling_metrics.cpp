// SPDX-License-Identifier: GPL-3.0-or-later
#include "scoring/metric_catalogue.h"
#include "scoring/score_calculator.h"

#include <QtTest>
#include <cmath>

using namespace chiron;
using namespace chiron::scoring;

namespace {

bool isNear(double a, double b, double tolerance) {
    return std::abs(a - b) <= tolerance;
}

/// Two objects for a second at 1 kHz: the first rests at 3, 4 mm from the target, the second 50 mm away; the
/// squeeze is a ramp to 2 N. `held` (its number + 1, 0: none) is held from 0.2 to 0.8 s.
TrialTrace handled(double task = 0.0, double heaviest = 0.0, bool completed = true, double held = 1.0) {
    TrialTrace trial;
    ToolTrace tool;
    QuantityTrace squeeze{"squeeze_N", {}};
    QuantityTrace holding{"held", {}};
    std::vector<QuantityTrace> bodies;
    for (const char* id : {"body_0_x_m", "body_0_y_m", "body_1_x_m", "body_1_y_m"})
        bodies.push_back({id, {}});
    const double places[] = {0.013, 0.024, 0.060, 0.020};
    for (int i = 0; i <= 1000; ++i) {
        tool.t_s.push_back(1e-3 * i);
        tool.p_WT_m.push_back(core::Vec3(1e-5 * i, 0.0, 0.0));
        tool.tissue_N.push_back(core::Vec3::Zero());
        tool.paused.push_back(0);
        squeeze.values.push_back(0.002 * i);
        holding.values.push_back(i >= 200 && i < 800 ? held : 0.0);
        for (std::size_t k = 0; k < 4; ++k)
            bodies[k].values.push_back(i < 1000 ? 0.5 : places[k]); // only where they lie in the end counts
    }
    trial.tools.push_back(std::move(tool));
    trial.quantities.push_back(std::move(squeeze));
    trial.quantities.insert(trial.quantities.end(), bodies.begin(), bodies.end());
    trial.quantities.push_back(std::move(holding));
    trial.truth = {{"target_x_m", 0.010},    {"target_y_m", 0.020}, {"target_radius_m", 0.014},
                   {"squeeze_limit_N", 1.5}, {"task", task},        {"objects", 2.0},
                   {"heaviest", heaviest}};
    trial.completed = completed;
    return trial;
}

SessionTrace session(std::vector<TrialTrace> trials) {
    SessionTrace trace;
    trace.exercise = "object_handling";
    for (std::size_t i = 0; i < trials.size(); ++i)
        trials[i].trial = static_cast<int>(i);
    trace.trials = std::move(trials);
    return trace;
}

Measurement metricOf(const SessionTrace& trace, const std::string& id, int version = 1) {
    const std::vector<MetricRequest> wanted{{id, version}};
    const auto card = calculateScore(trace, wanted, {}, true);
    if (!card)
        return Measurement{std::nullopt, card.error().message};
    const auto& metric = card->metrics.front();
    return {metric.value, metric.reason};
}

double valueOf(const SessionTrace& trace, const std::string& id) {
    return metricOf(trace, id).value.value_or(std::nan(""));
}

} // namespace

/// Metrics of object handling on traces that were made up.
class TestHandlingMetrics : public QObject {
    Q_OBJECT
private slots:
    void squeeze() {
        QVERIFY(isNear(valueOf(session({handled()}), "squeeze_max"), 2.0, 1e-12));
        QVERIFY(isNear(valueOf(session({handled()}), "squeeze_time_over_limit"), 0.249,
                       1e-9)); // samples 751..999, each a millisecond
        auto paused = handled();
        for (int i = 900; i <= 1000; ++i)
            paused.tools[0].paused[static_cast<std::size_t>(i)] = 1;
        QVERIFY(isNear(valueOf(session({paused}), "squeeze_max"), 1.798, 1e-12));
        QVERIFY(isNear(valueOf(session({paused}), "squeeze_time_over_limit"), 0.149, 1e-9));
        QVERIFY(isNear(valueOf(session({handled(), paused}), "squeeze_max"), 2.0, 1e-12));
        QVERIFY(isNear(valueOf(session({handled(), paused}), "squeeze_time_over_limit"), 0.398, 1e-9));
    }

    void placement() {
        QVERIFY(isNear(valueOf(session({handled()}), "placement_error"), 5.0, 1e-9));
        auto other = handled();
        other.quantities[1].values.back() = 0.010; // right over the middle in x: 4 mm
        QVERIFY(isNear(valueOf(session({handled(), other}), "placement_error"), 4.5, 1e-9));
        QVERIFY(isNear(valueOf(session({handled(0.0, 0.0, false)}), "placement_error"), 5.0,
                       1e-9)); // time ended it: all the same
    }

    void weighing() {
        QCOMPARE(valueOf(session({handled(1.0, 0.0)}), "weighing_correct"), 100.0);
        QCOMPARE(valueOf(session({handled(1.0, 1.0)}), "weighing_correct"),
                 0.0); // the lighter one lies there
        QCOMPARE(valueOf(session({handled(1.0, 0.0, false)}), "weighing_correct"), 0.0);
        QCOMPARE(
            valueOf(session({handled(1.0, 0.0), handled(1.0, 1.0), handled(1.0, 0.0), handled(1.0, 0.0)}),
                    "weighing_correct"),
            75.0);
        QCOMPARE(metricOf(session({handled(0.0)}), "weighing_correct").reason,
                 std::string("no weighing was asked for"));
    }

    void chanceOfWeighing() {
        QCOMPARE(valueOf(session({handled(1.0, 0.0), handled(1.0, 1.0)}), "weighing_correct_by_chance"),
                 50.0); // two objects
        auto four = handled(1.0, 0.0);
        for (NamedValue& value : four.truth)
            value.value = value.id == "objects" ? 4.0 : value.value;
        QCOMPARE(valueOf(session({handled(1.0, 0.0), four}), "weighing_correct_by_chance"), 37.5);
    }

    /// One of four that the level asks for is a quarter, however many were begun.
    void completedOfThoseAskedFor() {
        SessionTrace trace = session({handled(), handled(0.0, 0.0, false)});
        QCOMPARE(*metricOf(trace, "procedure_completed", 2).value,
                 50.0); // how many were asked for is not known
        trace.plannedTrials = 4;
        QCOMPARE(*metricOf(trace, "procedure_completed", 2).value, 25.0);
        QCOMPARE(*metricOf(trace, "procedure_completed", 1).value, 50.0); // as it was
        trace.trials.back().unfinished = true;
        QCOMPARE(*metricOf(trace, "procedure_completed", 2).value, 25.0);
        const std::vector<MetricRequest> wanted{{"procedure_completed", 2}};
        QCOMPARE(*calculateScore(trace, wanted, {}, true)->trials.front().front().value,
                 100.0); // of a trial: that trial
    }

    /// The answer is what was held last, not what happens to lie nearest to the target.
    void theLastHeldIsTheAnswer() {
        QCOMPARE(valueOf(session({handled(1.0, 1.0, true, 2.0)}), "weighing_correct"), 100.0);
        QCOMPARE(valueOf(session({handled(1.0, 0.0, true, 2.0)}), "weighing_correct"),
                 0.0); // though the heaviest lies nearer
        QVERIFY(isNear(valueOf(session({handled(0.0, 0.0, true, 2.0)}), "placement_error"), 50.0, 1e-9));
        auto both = handled(1.0, 1.0, true, 2.0);
        both.quantities.back().values[50] = 1.0; // the other one was tried before
        QCOMPARE(valueOf(session({both}), "weighing_correct"), 100.0);
        both.quantities.back().values[900] = 1.0; // and taken again after
        QCOMPARE(valueOf(session({both}), "weighing_correct"), 0.0);
        // nothing was ever held: no answer, and the placement is that of the nearest
        QCOMPARE(valueOf(session({handled(1.0, 0.0, true, 0.0)}), "weighing_correct"), 0.0);
        QVERIFY(isNear(valueOf(session({handled(0.0, 0.0, false, 0.0)}), "placement_error"), 5.0, 1e-9));
        auto unknown = handled();
        unknown.quantities.pop_back();
        QCOMPARE(metricOf(session({unknown}), "placement_error").reason,
                 std::string("the trace has no objects and target"));
    }

    void completed() {
        QCOMPARE(valueOf(session({handled(), handled(0.0, 0.0, false)}), "procedure_completed"), 50.0);
    }

    void undefinedWithItsReason() {
        auto bare = handled();
        bare.quantities.clear();
        QCOMPARE(metricOf(session({handled(), bare}), "squeeze_max").reason,
                 std::string("the trace has no squeeze"));
        QCOMPARE(metricOf(session({bare}), "placement_error").reason,
                 std::string("the trace has no objects and target"));
        QCOMPARE(metricOf(session({bare}), "procedure_completed").reason,
                 std::string("the trace has no procedure"));
        auto unlimited = handled();
        unlimited.truth.clear();
        QCOMPARE(metricOf(session({unlimited}), "squeeze_time_over_limit").reason,
                 std::string("the trace has no squeeze limit"));
    }
};

QTEST_APPLESS_MAIN(TestHandlingMetrics)
#include "test_handling_metrics.moc"
