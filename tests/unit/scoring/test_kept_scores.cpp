// SPDX-License-Identifier: GPL-3.0-or-later
// Every metric in every version of trials that were drawn so that much happens in them, often just at a limit, and of the same trials with
// something lacking, against what was kept. Hand-made cases show that metrics are right; stored scores stay comparable only where none of them changes.
#include "support/kept_figures.h"

#include "insertion_traces.h"
#include "palpation_traces.h"

#include "core/contact_bits.h"
#include "core/random.h"
#include "scoring/detection/finding_errors.h"
#include "scoring/detection/palpation_answer.h"
#include "scoring/detection/roc_curve.h"
#include "scoring/force_facts.h"
#include "scoring/insertion_events.h"
#include "scoring/insertion_moments.h"
#include "scoring/metric_catalogue.h"
#include "scoring/score_calculator.h"
#include "scoring/smoothness.h"
#include "scoring/trace_builder.h"
#include "scoring/trace_columns.h"
#include "scoring/trace_csv.h"

#include <QtTest>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

using namespace chiron;
using namespace chiron::scoring;
using core::Vec3;
using tests::Figures;

namespace {

const QString kFile = QStringLiteral(CHIRON_SOURCE_DIR "/tests/unit/scoring/kept_scores.txt");
constexpr int kSamples = 2400; ///< at 500 Hz

/// One of these for some time, then another: what is drawn stays long enough to count.
class Stretches {
public:
    Stretches(std::uint64_t seed, std::vector<double> values, int least, int most) : m_random(seed), m_values(std::move(values)), m_least(least), m_most(most) {}
    double next() {
        if (m_left-- <= 0) {
            m_value = m_values[m_random.below(m_values.size())];
            m_left = m_least + static_cast<int>(m_random.below(static_cast<std::uint64_t>(m_most - m_least + 1)));
        }
        return m_value;
    }

private:
    core::Random m_random;
    std::vector<double> m_values;
    int m_least, m_most, m_left = 0;
    double m_value = 0.0;
};

/// Moves, rests, presses, pauses.
ToolTrace tool(std::uint64_t seed) {
    ToolTrace trace;
    core::Random random(seed);
    Stretches speed(seed + 1, {0.0, 0.004, 0.005, 0.02, 0.06, -0.03}, 40, 260), force(seed + 2, {0.0, 0.01, 0.02, 0.03, 0.5, 0.8, 1.4, 1.5, 1.501, 2.5, 4.0, 4.2}, 5, 120);
    Stretches bits(seed + 3, {0.0, 0.0, 0.0, 1.0, 2.0, 4.0, 6.0}, 30, 200), pause(seed + 4, {0.0, 0.0, 0.0, 0.0, 1.0}, 100, 240);
    double x = 0.0, t = 0.3;
    for (int i = 0; i < kSamples; ++i) {
        t += i % 700 == 650 ? 0.4 : 0.002;
        x += 0.002 * speed.next();
        const double f = force.next();
        trace.t_s.push_back(t);
        trace.p_WT_m.push_back(Vec3(x, 0.01 * std::sin(2.0 * t), 0.002 * std::cos(5.0 * t) + 1e-5 * random.normal()));
        trace.tissue_N.push_back(f * Vec3(0.0, 0.6, 0.8));
        trace.commanded_N.push_back(std::min(f, 2.0) * Vec3(0.0, 0.6, 0.8));
        trace.measured_N.push_back(std::min(f, 2.1) * Vec3(0.1, 0.6, 0.8));
        trace.tissueTorque_Nm.push_back(Vec3(0.0, 0.002 * f, -0.001 * f));
        trace.q_WT.push_back(core::Quat::Identity());
        trace.contact.push_back(static_cast<std::uint8_t>(bits.next()));
        trace.paused.push_back(pause.next() > 0.5 ? 1 : 0);
    }
    return trace;
}

InsertionSeries canal(std::uint64_t seed, const std::vector<double>& t_s) {
    InsertionSeries series;
    Stretches lateral(seed, {0.0, 0.4, 1.59, 1.6, 1.61, 2.0, 2.001, 2.5, 3.9, 4.0, 4.1}, 4, 90), offset(seed + 1, {0.0, 0.0004, 0.002, 0.0031}, 10, 100), turned(seed + 2, {0.0, 0.05, 0.2, 0.4}, 10, 100);
    Stretches twist(seed + 3, {0.0, 0.001, 0.0043}, 10, 100), back(seed + 4, {0.00006, 0.00006, 0.00006, 0.00009, -0.00005, -0.00002}, 8, 40);
    double s = -0.004;
    for (std::size_t i = 0; i < t_s.size(); ++i) {
        s = std::min(s + back.next(), 0.115);
        const int stage = s < 0.0 ? 0 : i < 1700 ? 1 : i < 2000 ? 2 : i < 2300 ? 3 : 4;
        series.s_m.push_back(std::round(1e6 * s) / 1e6);
        series.offset_m.push_back(offset.next());
        series.alignment_rad.push_back(turned.next());
        series.lateral_N.push_back(lateral.next());
        series.axialTorque_Nm.push_back(twist.next());
        series.stage.push_back(static_cast<std::uint8_t>(stage));
    }
    series.length_m = 0.110;
    series.bend_m = 0.040;
    series.goal_m = 0.080;
    series.lateralLimit_N = 2.0;
    series.landmarkSeen_s = {t_s[1800], std::numeric_limits<double>::quiet_NaN(), t_s[1900], t_s[1799]};
    return series;
}

void addDrawn(TrialTrace& trial, const char* id, std::uint64_t seed, std::vector<double> values, int least = 20, int most = 200) {
    Stretches drawn(seed, std::move(values), least, most);
    QuantityTrace quantity{id, {}};
    for (int i = 0; i < kSamples; ++i)
        quantity.values.push_back(drawn.next());
    trial.quantities.push_back(std::move(quantity));
}

/// What scenes of tubes and objects record.
void addScene(TrialTrace& trial, std::uint64_t seed) {
    addDrawn(trial, "step", seed, {1, 2, 3, 3, 3, 4, 9, 5, 6, 7, 8}, 60, 220);
    addDrawn(trial, "tension_N", seed + 1, {0.0, 0.4, 0.85, 0.849, 1.0, 1.15, 1.1501, 1.4});
    addDrawn(trial, "stretch_m", seed + 2, {0.0, 0.01, 0.018, 0.0195, 0.02, 0.0315, 0.03151, 0.04});
    addDrawn(trial, "grip_1", seed + 3, {0.0, 0.0, 1.0, 0.5}, 20, 120);
    addDrawn(trial, "grip_0", seed + 4, {0.0, 1.0}, 20, 120);
    addDrawn(trial, "fold_open", seed + 5, {0.0, 1.0, 0.5}, 50, 300);
    addDrawn(trial, "retraction_N", seed + 6, {0.0, 0.3, 0.2999, 0.6, 0.6001, 0.9});
    addDrawn(trial, "held", seed + 7, {0.0, 0.0, 1.0, 2.0}, 50, 300);
    addDrawn(trial, "squeeze_N", seed + 8, {0.0, 0.5, 1.5, 1.501, 2.0});
    addDrawn(trial, "held_error_m", seed + 9, {0.0, 0.001, -0.002});
    addDrawn(trial, "prediction_error_m", seed + 10, {0.0, 0.003, -0.004});
    addDrawn(trial, "coverage", seed + 11, {0.2, 0.5, 0.73});
    for (const char* id : {"body_0_x_m", "body_0_y_m", "body_1_x_m", "body_1_y_m"})
        addDrawn(trial, id, ++seed + 20, {0.013, 0.024, 0.02, 0.01});
    trial.truth = {{"over_stretch_m", 0.0315}, {"target_N", 1.0}, {"band_N", 0.15}, {"retraction_low_N", 0.3}, {"retraction_high_N", 0.6}, {"target_x_m", 0.01}, {"target_y_m", 0.02}, {"squeeze_limit_N", 1.5},
                   {"task", 1.0}, {"objects", 2.0}, {"heaviest", 1.0}, {"band_low_N", 0.8}, {"band_high_N", 2.5}};
}

SessionTrace drawn() {
    SessionTrace trace;
    trace.exercise = "drawn";
    trace.forceLimit_N = 1.5;
    trace.plannedTrials = 5;
    for (int k = 0; k < 4; ++k) {
        const auto seed = static_cast<std::uint64_t>(100 * k + 7);
        TrialTrace trial;
        trial.trial = k;
        trial.tools = {tool(seed), tool(seed + 40)};
        trial.insertion = canal(seed + 60, trial.tools[0].t_s);
        addScene(trial, seed + 70);
        trial.marked = k != 2;
        trial.timedOut = k == 2;
        trial.markInContact = k != 1;
        trial.completed = k % 2 == 0;
        trial.failed = k == 3;
        trial.p_WMark_m = trial.tools[0].p_WT_m.back() + Vec3(0.002 * k, -0.001, 0.0);
        trial.apex = ApexTruth{0.01 - 0.004 * k, 0.003 * k, 0.02};
        trace.trials.push_back(std::move(trial));
    }
    return trace;
}

/// One after the other a trial with nothing but its samples, and all trials with something gone.
std::vector<std::pair<const char*, std::function<void(SessionTrace&)>>> changes() {
    const auto each = [](auto change) { return [change](SessionTrace& trace) { std::for_each(trace.trials.begin(), trace.trials.end(), change); }; };
    const auto without = [&](const char* id) { return [id](SessionTrace& trace) { std::erase_if(trace.trials[1].quantities, [&](const QuantityTrace& q) { return q.id == id; }); }; };
    const auto untrue = [&](const char* id) { return [id](SessionTrace& trace) { std::erase_if(trace.trials[1].truth, [&](const NamedValue& v) { return v.id == id; }); }; };
    std::vector<std::pair<const char*, std::function<void(SessionTrace&)>>> all{
        {"as drawn", [](SessionTrace&) {}},
        {"one trial", [](SessionTrace& trace) { trace.trials.resize(1); }},
        {"two trials", [](SessionTrace& trace) { trace.trials.resize(2); }},
        {"no trial", [](SessionTrace& trace) { trace.trials.clear(); }},
        {"no tool", [](SessionTrace& trace) { trace.trials[1].tools.clear(); trace.trials[1].insertion.reset(); trace.trials[1].quantities.clear(); }},
        {"two samples", each([](TrialTrace& trial) {
             trial.insertion.reset();
             trial.quantities.clear();
             for (ToolTrace& one : trial.tools)
                 one = ToolTrace{{0.0, 0.01}, {Vec3(0, 0, 0), Vec3(0.01, 0, 0)}, {Vec3(0, 0, 1), Vec3(0, 0, 2)}, {}, {}, {0, 0}, {}, {}, {}, {}};
         })},
        {"forces not known", [](SessionTrace& trace) { trace.trials[2].forcesKnown = false; }},
        {"unfinished", [](SessionTrace& trace) { trace.trials[2].unfinished = true; }},
        {"all unfinished", each([](TrialTrace& trial) { trial.unfinished = true; })},
        {"more than planned", [](SessionTrace& trace) { trace.plannedTrials = 3; }},
        {"not known how many", [](SessionTrace& trace) { trace.plannedTrials = 0; }},
        {"no apex", [](SessionTrace& trace) { trace.trials[1].apex.reset(); }},
        {"no canal", [](SessionTrace& trace) { trace.trials[1].insertion.reset(); }},
        {"nothing to be done", [](SessionTrace& trace) { trace.trials[1].insertion.reset(); trace.trials[1].quantities.clear(); }},
        {"no torques", [](SessionTrace& trace) { trace.trials[1].tools[0].tissueTorque_Nm.clear(); }},
        {"no contact bits", each([](TrialTrace& trial) { trial.tools[0].contact.clear(); })},
        {"no landmarks", each([](TrialTrace& trial) { trial.insertion->landmarkSeen_s.clear(); })},
        {"never inside", each([](TrialTrace& trial) { trial.insertion->s_m.assign(trial.insertion->s_m.size(), -0.001); })},
        {"never inspected", each([](TrialTrace& trial) { std::replace(trial.insertion->stage.begin(), trial.insertion->stage.end(), std::uint8_t{2}, std::uint8_t{1}); })},
        {"never held", each([](TrialTrace& trial) { std::replace(trial.quantities[0].values.begin(), trial.quantities[0].values.end(), 3.0, 2.0); })},
        {"nothing taken", each([](TrialTrace& trial) { for (QuantityTrace& q : trial.quantities) if (q.id == "held") q.values.assign(q.values.size(), 0.0); })},
        {"all paused", each([](TrialTrace& trial) { for (ToolTrace& one : trial.tools) one.paused.assign(one.paused.size(), 1); })},
        {"still", each([](TrialTrace& trial) { for (ToolTrace& one : trial.tools) one.p_WT_m.assign(one.p_WT_m.size(), Vec3(0.01, 0, 0)); })},
        {"no force", each([](TrialTrace& trial) { for (ToolTrace& one : trial.tools) one.tissue_N.assign(one.tissue_N.size(), Vec3::Zero()); })},
        {"there and back", each([](TrialTrace& trial) { for (ToolTrace& one : trial.tools) one.p_WT_m.back() = one.p_WT_m.front(); })},
        {"to a mark", each([](TrialTrace& trial) {
             trial.truth.push_back({"mark_m", 0.02});
             trial.truth.push_back({"mark_tolerance_m", 0.002});
             std::erase_if(trial.truth, [](const NamedValue& v) { return v.id == "target_N"; });
         })},
        {"slow", each([](TrialTrace& trial) { for (ToolTrace& one : trial.tools) for (double& t : one.t_s) t *= 6.0; })}};
    for (const char* id : {"step", "tension_N", "stretch_m", "grip_1", "fold_open", "retraction_N", "held", "squeeze_N", "held_error_m", "prediction_error_m", "coverage", "body_1_x_m"})
        all.emplace_back(id, without(id));
    for (const char* id : {"over_stretch_m", "target_N", "band_N", "retraction_low_N", "target_x_m", "squeeze_limit_N", "task", "objects", "heaviest", "band_low_N", "band_high_N"})
        all.emplace_back(id, untrue(id));
    return all;
}

void tell(Figures& out, const QString& of, const MetricValue& value) {
    if (value.value)
        out.add(of, *value.value);
    else
        out.say(of, value.reason);
}

/// Of a palpation: lumps, findings near the edges of reach, regions and the area, said or not said.
std::vector<TrialTrace> palpated() {
    using tests::MadeTrial;
    std::vector<TrialTrace> trials;
    trials.push_back(MadeTrial({{-0.02, -0.02, 0.0075, 5}, {0.0, 0.0, 0.004, 2}, {0.02, 0.015, 0.015, 3}}).found(0, -0.015, -0.02, 5, 4, 80).found(1, 0.012, 0.0, 3, 2, 50).found(2, 0.02, 0.0301, 1, 3).found(3, 0.029, -0.029, 2).covered(0.9));
    trials.push_back(MadeTrial({{0.01, 0.01, 0.0075, 1}, {-0.01, 0.01, 0.0075, 4}}, 2).found(0, -0.0099, 0.01, 4, 4, 60).found(1, 0.0101, 0.01, 0, 1).found(2, -0.03, 0.03).found(3, 0.031, 0.0, 5).press(0, 20, 90, 1.0).press(1, 60, 120, 2.6).press(0, 150, 151, 0.02).pause(200, 230).timedOut());
    trials.push_back(MadeTrial({{0.0, 0.0, 0.0075, 3}, {0.02, 0.0, 0.0075, 3}, {-0.02, 0.0, 0.0075, 5}}).found(0, 0.0, 0.001, 2, 3, 75).found(1, 0.02, 0.001, 2, 3, 75).found(2, -0.02, 0.002, 2, 2, 90).say(core::ReportField::remove, 1, 1).at(250).say(core::ReportField::done, 0).covered(0.4));
    trials.push_back(MadeTrial().found(0, 0.01, 0.0, 1));
    trials.push_back(MadeTrial(std::vector<tests::MadeLump>{{0.0, 0.0, 0.0075, 2}}).press(0, 0, 300, 4.5));
    return trials;
}

} // namespace

class TestKeptScores : public QObject {
    Q_OBJECT
private slots:
    void everyMetric();
    void palpations();
    void events();
    void truths();
    void files();
    void cells();
    void headers();
    void nothingElseIsKept() { QCOMPARE(m_kept.unseen(), QStringList()); }

private:
    void hold(const QString& name, const Figures& figures) {
        const QString differs = m_kept.differs(name, figures.lines);
        QVERIFY2(differs.isEmpty(), qPrintable(differs));
    }
    static std::vector<MetricRequest> all() {
        std::vector<MetricRequest> requests;
        for (const MetricDefinition& metric : metricCatalogue())
            requests.push_back({std::string(metric.id), metric.version});
        return requests;
    }
    tests::KeptText m_kept{kFile, tests::sameFigures};
};

void TestKeptScores::everyMetric() {
    const SessionTrace trace = drawn();
    QSet<QString> before;
    for (const auto& [name, change] : changes()) {
        SessionTrace changed = trace;
        change(changed);
        Figures out;
        const auto card = calculateScore(changed, all(), {}, true);
        QVERIFY2(card, card ? "" : card.error().message.c_str());
        for (std::size_t i = 0; i < card->metrics.size(); ++i) {
            const QString id = QStringLiteral("%1@%2").arg(QString::fromStdString(card->metrics[i].id)).arg(card->metrics[i].version);
            tell(out, id, card->metrics[i]);
            for (std::size_t trial = 0; trial < card->trials.size(); ++trial)
                tell(out, QStringLiteral("%1 of %2").arg(id).arg(trial), card->trials[trial][i]);
        }
        const ForceFacts facts = forceFactsOf(changed);
        out.add(QStringLiteral("forces"), facts.tissue_N, facts.commanded_N, facts.limited_s, facts.firstLimited_s.value_or(-1.0), facts.samples, facts.beyondChecked, facts.beyondCheckedShare());
        // Of a change only what it changes.
        Figures changedOnly;
        for (qsizetype i = 0; i < out.lines.size(); ++i)
            if (before.isEmpty() || !before.contains(out.lines[i]))
                changedOnly.lines << out.lines[i];
        if (changedOnly.lines.isEmpty())
            changedOnly.say(QStringLiteral("changes"), "nothing");
        if (before.isEmpty())
            before = QSet<QString>(out.lines.begin(), out.lines.end());
        hold(QStringLiteral("metrics, %1").arg(QLatin1String(name)), changedOnly);
        if (QTest::currentTestFailed())
            return;
    }
}

void TestKeptScores::palpations() {
    Figures out;
    const std::vector<TrialTrace> trials = palpated();
    for (std::size_t count = 0; count <= trials.size(); ++count) {
        SessionTrace trace = tests::palpationSession({trials.begin(), trials.begin() + static_cast<std::ptrdiff_t>(count)});
        for (const double limit_N : {4.0, 2.0}) {
            trace.forceLimit_N = limit_N;
            const auto card = calculateScore(trace, all(), {}, true);
            for (std::size_t i = 0; i < card->metrics.size(); ++i)
                if (const std::string& id = card->metrics[i].id; id.starts_with("palpation") || id.starts_with("loc") || id.starts_with("size") || id.starts_with("hard") || id == "coverage" || id.starts_with("force_band") || id == "pressing_time" || id == "searching_time") {
                    tell(out, QString::fromStdString(id), card->metrics[i]);
                    for (const auto& trial : card->trials)
                        tell(out, QStringLiteral("- of one"), trial[i]);
                }
        }
    }
    RatingCounts ratings;
    for (const TrialTrace& trial : trials) {
        const JudgedTrial judged = judgePalpation(trial);
        QVERIFY(judged.answer);
        const PalpationAnswer& answer = *judged.answer;
        out.add(QStringLiteral("judged"), answer.hits(), answer.misses(), answer.falseAlarms(), answer.reports.size());
        for (const TimedReport& report : answer.reports)
            out.add(QStringLiteral("report"), report.t_s, static_cast<int>(report.field), report.finding, report.value, report.place_W.x(), report.place_W.y());
        for (const FindingMatch& match : answer.matches)
            out.add(QStringLiteral("match"), match.finding, match.lump, match.distance_m, match.region);
        for (const DetectionRegion& region : answer.regions)
            out.add(QStringLiteral("region"), region.signal, region.reported, region.confidence);
        const HardnessPairs pairs = hardnessPairs(answer.truth, answer.findings, answer.matches);
        out.add(QStringLiteral("pairs"), pairs.right, pairs.pairs, pairs.rated, pairs.rightByChance);
        ratings.add(answer.regions);
        if (const auto curve = rocOf(ratings)) {
            out.add(QStringLiteral("curve"), curve->area, curve->dA.value_or(-99.0), curve->slope.value_or(-99.0));
            for (const RocPoint& point : curve->points)
                out.add(QStringLiteral("point"), point.falseAlarmRate, point.hitRate, point.confidence);
        }
        for (const double x : {-0.0301, -0.03, -0.01, 0.0, 0.01, 0.0299, 0.03, 0.0301})
            out.add(QStringLiteral("region at"), x, regionAt(answer.truth, Vec3(x, 0.0, 0.0)), regionAt(answer.truth, Vec3(0.0, x, 0.0)), regionAt(answer.truth, Vec3(x, x, 0.0)));
    }
    for (const std::vector<std::pair<int, int>>& rated : std::vector<std::vector<std::pair<int, int>>>{{}, {{1, 1}}, {{1, 1}, {1, 2}}, {{1, 2}, {3, 3}, {5, 1}}, {{2, 2}, {4, 4}, {5, 4}, {1, 5}}}) {
        const HardnessPairs pairs = hardnessPairs(rated);
        out.add(QStringLiteral("of ratings"), pairs.right, pairs.pairs, pairs.rated, pairs.rightByChance);
    }
    hold(QStringLiteral("palpations"), out);
}

void TestKeptScores::events() {
    Figures out;
    const auto told = [&](const char* name, const std::vector<InsertionEvent>& events) {
        for (const InsertionEvent& event : events)
            out.add(QLatin1String(name), event.begin_s, event.end_s, event.value, isCritical(event));
    };
    SessionTrace trace = drawn();
    trace.trials[3].insertion.reset();
    for (TrialTrace& trial : trace.trials) {
        const InsertionEvents events = insertionEvents(traces::onGrids(trial));
        told("trauma", events.trauma);
        told("reversal", events.reversals);
        for (const InsertionQuantity quantity : {InsertionQuantity::offset, InsertionQuantity::alignment, InsertionQuantity::bendAlignment, InsertionQuantity::curveAlignment, InsertionQuantity::torque}) {
            const auto largest = largestOf(traces::onGrids(trial), quantity);
            out.add(QStringLiteral("largest"), largest ? largest->begin_s : -1.0, largest ? largest->value : -1.0, inMetricUnit(quantity, 0.01));
            told("over", stretchesOver(traces::onGrids(trial), quantity, inMetricUnit(quantity, quantity == InsertionQuantity::torque ? 0.001 : quantity == InsertionQuantity::offset ? 0.002 : 0.2)));
            out.say(QStringLiteral("unit"), metricUnitOf(quantity));
        }
    }
    for (const MetricDefinition& metric : metricCatalogue())
        if (const auto quantity = insertionQuantityOf(metric.id))
            out.add(QString::fromUtf8(metric.id.data(), static_cast<qsizetype>(metric.id.size())), static_cast<int>(*quantity));
    hold(QStringLiteral("events"), out);
}

/// A truth that lacks something or cannot be.
void TestKeptScores::truths() {
    Figures out;
    const std::vector<NamedValue> good = tests::MadeTrial(std::vector<tests::MadeLump>{{0.01, 0.01, 0.0075, 1}}).trial().truth;
    const auto tried = [&](const QString& name, const std::vector<NamedValue>& truth) {
        const auto read = palpationTruthOf(truth);
        out.say(name, read ? "read" : "refused");
        if (read)
            out.add(QStringLiteral("truth"), read->lumps.size(), read->areaHalf_m.x(), read->areaHalf_m.y(), read->regionColumns, read->regionRows, read->hitRadius_m, read->bandLow_N, read->bandHigh_N, read->coverForce_N, read->asksSize,
                    read->asksHardness);
    };
    for (std::size_t i = 0; i < good.size(); ++i) {
        std::vector<NamedValue> less = good;
        less.erase(less.begin() + static_cast<std::ptrdiff_t>(i));
        tried(QString::fromStdString(good[i].id), less);
        for (const double value : {-1.0, -1e-9, 0.0, 1e-6, 0.49, 0.5, 1.0, 1.49, 5.0, 5.5, 6.0, 8.0, 12.0, 16.0, 17.0, 32.0, 33.0, 64.0, 65.0, 1e12, HUGE_VAL}) {
            if (good[i].id == "lumps" && value > 1.4)
                continue; // then lumps lack
            std::vector<NamedValue> other = good;
            other[i].value = value;
            tried(QStringLiteral("%1 %2").arg(QString::fromStdString(good[i].id)).arg(value), other);
        }
    }
    for (const int lumps : {7, 8, 9, 12, 16, 17}) {
        const std::vector<tests::MadeLump> many(static_cast<std::size_t>(lumps));
        tried(QStringLiteral("%1 lumps").arg(lumps), tests::MadeTrial(many).trial().truth);
    }
    hold(QStringLiteral("truths"), out);
}

/// What is written of trials, row by row, and that it says as much when it is read.
void TestKeptScores::files() {
    Figures out;
    SessionTrace trace = drawn();
    trace.trials.resize(2);
    trace.trials[1].unfinished = true;
    for (const bool plain : {false, true}) {
        if (plain)
            for (TrialTrace& trial : trace.trials) {
                trial.insertion.reset();
                trial.quantities.clear();
                trial.truth.clear();
                trial.apex.reset();
                for (ToolTrace& one : trial.tools) {
                    one.commanded_N.clear();
                    one.measured_N.clear();
                    one.q_WT.clear();
                    one.tissueTorque_Nm.clear();
                    one.contact.clear();
                }
            }
        const TraceRows rows = rowsOf(trace);
        const std::string text = writeTraceCsv(rows);
        const QStringList lines = QString::fromStdString(text).split(QLatin1Char('\n'), Qt::SkipEmptyParts);
        out.add(QStringLiteral("lines"), lines.size());
        for (qsizetype i = 0; i < lines.size(); i += i == 0 ? 1 : 611)
            out.lines << QString(lines[i]).replace(QLatin1Char(','), QLatin1Char(' '));
        const auto read = readTraceCsv(text, "drawn.csv");
        QVERIFY2(read, read ? "" : read.error().message.c_str());
        const auto built = buildSessionTrace(*read, "drawn", 3.0);
        QVERIFY2(built, built ? "" : built.error().message.c_str());
        const auto card = calculateScore(*built, all(), {}, true), same = calculateScore(trace, all(), {}, true);
        for (std::size_t i = 0; i < card->metrics.size(); ++i) {
            QVERIFY2(plain || card->metrics[i].value == same->metrics[i].value, card->metrics[i].id.c_str());
            if (plain)
                tell(out, QString::fromStdString(card->metrics[i].id), card->metrics[i]);
        }
    }
    hold(QStringLiteral("files"), out);
}

/// Each cell of a row with every column, at the ends of what it may be and beyond, and how it is written again.
void TestKeptScores::cells() {
    Figures out;
    SessionTrace trace = drawn();
    trace.trials.resize(1);
    trace.trials[0].unfinished = true;
    TraceRows all = rowsOf(trace);
    all.columns.jaw = all.columns.buttons = all.columns.phase = true;
    all.rows.resize(1);
    all.rows[0].quantities[1] = -0.0;
    all.rows[0].quantities[2] = std::nan("");
    const QStringList lines = QString::fromStdString(writeTraceCsv(all)).split(QLatin1Char('\n'));
    const QStringList names = lines[0].split(QLatin1Char(',')), usual = lines[1].split(QLatin1Char(','));
    for (qsizetype i = 0; i < names.size(); ++i)
        out.say(names[i], usual[i].toStdString());
    for (qsizetype i = 0; i < names.size(); ++i) {
        const int known = findTraceColumn(names[i].toStdString());
        QStringList values{QString(), QStringLiteral("0"), QStringLiteral("1"), QStringLiteral("-1"), QStringLiteral("2"), QStringLiteral("0.5"), QStringLiteral("-0"), QStringLiteral("0.00000049"), QStringLiteral("x"), QStringLiteral("1e400"), QStringLiteral("running"), QStringLiteral("withdrawal")};
        if (known >= 0) {
            const TraceColumn& column = traceColumns()[static_cast<std::size_t>(known)];
            for (const double end : {column.least, column.most})
                for (const double away : {-1.0, 0.0, 1.0})
                    values << QString::number(end + away * std::max(1.0, 1e-9 * std::abs(end)), 'g', 17);
        }
        values.removeDuplicates();
        for (const QString& value : values) {
            QStringList row = usual;
            row[i] = value;
            const auto read = readTraceCsv((names.join(QLatin1Char(',')) + QLatin1Char('\n') + row.join(QLatin1Char(','))).toStdString(), "t");
            out.say(names[i] + QStringLiteral(" = ") + value, read ? QString::fromStdString(writeTraceCsv(*read)).section(QLatin1Char('\n'), 1, 1).section(QLatin1Char(','), i, i).toStdString() : read.error().message.substr(0, 160));
        }
    }
    hold(QStringLiteral("cells"), out);
}

/// Columns that are missing, given twice, unknown or too many, and lines that are no rows.
void TestKeptScores::headers() {
    Figures out;
    const auto told = [&](const std::string& name, const std::string& text) {
        const auto read = readTraceCsv(text, "t");
        const auto built = read ? buildSessionTrace(*read, "drawn") : core::Result<SessionTrace>(SessionTrace{});
        out.say(QString::fromStdString(name), !read ? read.error().message.substr(0, 200) : !built ? built.error().message : "read, " + std::to_string(read->rows.size()) + " rows, " + std::to_string(built->trials.size()) + " trials");
    };
    const std::string head = "t_s,x_mm,y_mm,z_mm", row = "\n0,1,2,3\n";
    for (const TraceColumn& column : traceColumns()) {
        told("with " + std::string(column.name), head + "," + std::string(column.name) + "\n0,1,2,3,1\n");
        told("twice " + std::string(column.name), std::string(column.name) + "," + std::string(column.name) + row);
    }
    for (const char* name : {"", "x", "quantity_", "quantity_a", "quantity_A", "quantity_a b", "truth_", "truth_a_1", "truth_1", "quantity_a,quantity_a", "quantity_a,truth_a"})
        told(std::string("named ") + name, head + "," + name + "\n0,1,2,3,1\n");
    for (const int count : {64, 65})
        for (const char* prefix : {"quantity_a", "truth_a"}) {
            std::string names = head, cells = "\n0,1,2,3";
            for (int i = 0; i < count; ++i) {
                names += "," + std::string(prefix) + std::to_string(i);
                cells += ",1";
            }
            told(std::to_string(count) + prefix, names + cells);
        }
    for (const char* text : {"", "\n", "\xef\xbb\xbf", "\xef\xbb\xbft_s,x_mm,y_mm,z_mm\n0,1,2,3", "t_s,x_mm,y_mm,z_mm", "t_s,x_mm,y_mm,z_mm\r\n0,1,2,3\r\n", "t_s,x_mm,y_mm,z_mm\n0,1,2,3\n\n\n", "t_s,x_mm,y_mm,z_mm\n0,1,2,3\n\n1,1,2,3", "t_s,x_mm,y_mm,z_mm\n\n0,1,2,3",
                             "t_s,x_mm,y_mm,z_mm\n0,1,2\n", "t_s,x_mm,y_mm,z_mm\n0,1,2,3,\n", "t_s,x_mm,y_mm,z_mm\n0,\x1f\x20\x7e\x7f\x80,2,3\n", "t_s,x_mm,y_mm,z_mm\n0,1234567890123456789012345678901234567890,2,x\n", "t_s,x_mm,y_mm,z_mm\n0,12345678901234567890123456789012345678901x,2,3\n",
                             "t_s,x_mm,y_mm,z_mm,tool\n0,1,2,3,0\n0,1,2,3,1\n0,1,2,3,1\n", "t_s,x_mm,y_mm,z_mm,trial\n0,1,2,3,1\n1,1,2,3,2\n2,1,2,3,1\n", "t_s,x_mm,y_mm,z_mm,phase\n0,1,2,3,ready\n", "t_s,x_mm,y_mm,z_mm,qw,qx,qy,qz\n0,1,2,3,1.0009,0,0,0\n1,1,2,3,1.0011,0,0,0\n",
                             "t_s,x_mm,y_mm,z_mm,force_limit_N\n0,1,2,3,2\n1,1,2,3,3\n", "t_s,x_mm,y_mm,z_mm,trials_planned\n0,1,2,3,2\n1,1,2,3,3\n", "t_s,x_mm,y_mm,z_mm,failed\n0,1,2,3,0\n1,1,2,3,1\n", "t_s,x_mm,y_mm,z_mm,unfinished\n0,1,2,3,1\n1,1,2,3,0\n", "t_s,x_mm,y_mm,z_mm,truth_a\n0,1,2,3,1\n1,1,2,3,2\n"})
        told(text, text);
    hold(QStringLiteral("headers"), out);
}

QTEST_APPLESS_MAIN(TestKeptScores)
#include "test_kept_scores.moc"
