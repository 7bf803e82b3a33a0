// SPDX-License-Identifier: GPL-3.0-or-later
// Metrics of palpation on trials that were made up, each against a number worked out by hand.
#include "core/contact_bits.h"
#include "core/normal_distribution.h"
#include "curriculum/exercises/palpation/scoring/palpation_truth.h"
#include "modules/exercises/palpation/cues/report_word.h"
#include "palpation_traces.h"
#include "scoring/metric.h"
#include "scoring/metric_catalogue.h"
#include "scoring/score_calculator.h"
#include "scoring/trace_builder.h"
#include "scoring/trace_csv.h"

#include <QtTest>
#include <cmath>

using namespace chiron;
using namespace chiron::scoring;
using simulation::ReportField;
using tests::MadeTrial;
using tests::palpationSession;

namespace {

bool isNear(double a, double b, double tolerance) {
    return std::abs(a - b) <= tolerance;
}

Measurement metricOf(const SessionTrace& trace, const std::string& id, int version = 0) {
    const std::vector<MetricRequest> wanted{{id, version}};
    const auto card = calculateScore(trace, wanted, {}, true);
    if (!card)
        return Measurement{std::nullopt, card.error().message};
    return {card->metrics.front().value, card->metrics.front().reason};
}
double valueOf(const std::vector<TrialTrace>& trials, const std::string& id, int version = 0) {
    return metricOf(palpationSession(trials), id, version).value.value_or(std::nan(""));
}
QString reasonOf(const std::vector<TrialTrace>& trials, const std::string& id, int version = 0) {
    return QString::fromStdString(metricOf(palpationSession(trials), id, version).reason);
}

/// Three lumps of different hardness, two of them found 3 mm and 5 mm away, one finding beside.
MadeTrial threeLumps() {
    MadeTrial trial({{-0.02, -0.02, 0.005, 2}, {0.02, 0.02, 0.0075, 5}, {-0.02, 0.02, 0.006, 3}});
    trial.found(0, -0.017, -0.02, 4, 3, 60).found(1, 0.02, 0.025, 5, 4, 70).found(2, 0.02, -0.02, 1);
    return trial;
}

/// `trials` trials of one lump in the middle, `hits` of them found, and `alarms` with a mark in a corner.
std::vector<TrialTrace> oneLumpEach(int trials, int hits, int alarms) {
    std::vector<TrialTrace> out;
    for (int i = 0; i < trials; ++i) {
        MadeTrial trial({{0.0, 0.0}});
        if (i < hits)
            trial.found(0, 0.0, 0.0, 5);
        if (i < alarms)
            trial.found(1, -0.02, -0.02, 1);
        out.push_back(trial);
    }
    return out;
}

} // namespace

class TestPalpationMetrics : public QObject {
    Q_OBJECT
private slots:
    void counts() {
        QCOMPARE(valueOf({threeLumps()}, "palpation_hits"), 2.0);
        QCOMPARE(valueOf({threeLumps()}, "palpation_misses"), 1.0);
        QCOMPARE(valueOf({threeLumps()}, "palpation_false_alarms"), 1.0);
        QCOMPARE(valueOf({threeLumps(), threeLumps(), MadeTrial().found(0, 0.0, 0.0)}, "palpation_hits"),
                 4.0);
        QCOMPARE(valueOf({threeLumps(), MadeTrial().found(0, 0.0, 0.0)}, "palpation_false_alarms"), 2.0);
        QCOMPARE(valueOf({MadeTrial()}, "palpation_false_alarms"), 0.0);
        QCOMPARE(reasonOf({MadeTrial()}, "palpation_hits"), QString("no lump was there"));
        QCOMPARE(reasonOf({MadeTrial()}, "palpation_misses"), QString("no lump was there"));
        QCOMPARE(valueOf({MadeTrial({{0.0, 0.0}})}, "palpation_misses"), 1.0); // nobody said anything
    }

    void takenBackTimedOutAndPaused() {
        QCOMPARE(valueOf({threeLumps().say(ReportField::remove, 2)}, "palpation_false_alarms"), 0.0);
        QCOMPARE(valueOf({threeLumps().say(ReportField::remove, 0)}, "palpation_hits"), 1.0);
        QCOMPARE(valueOf({threeLumps().timedOut()}, "palpation_hits"), 2.0); // what had been said counts
        QCOMPARE(valueOf({threeLumps().pause(90, 250)}, "palpation_hits"),
                 2.0); // a report is one in a pause too
        MadeTrial again = threeLumps();
        again.say(ReportField::remove, 0)
            .found(0, -0.021, -0.02, 5, 5, 50); // its place in the list is taken anew
        QVERIFY(isNear(valueOf({again}, "localisation_error"), 3.0, 1e-9)); // (1 + 5)/2
    }

    void errors() {
        QVERIFY(isNear(valueOf({threeLumps()}, "localisation_error"), 4.0, 1e-9));
        QVERIFY(isNear(valueOf({threeLumps()}, "size_error"), 0.75, 1e-9)); // (|6 − 5| + |7 − 7.5|)/2
        // pooled over hits, not a mean of the trials' means
        const auto one = MadeTrial({{0.0, 0.0}}).found(0, 0.010, 0.0, 0, 0, 85);
        QVERIFY(isNear(valueOf({threeLumps(), one}, "localisation_error"), 6.0, 1e-9));
        QVERIFY(isNear(valueOf({threeLumps(), one}, "size_error"), 2.5 / 3.0, 1e-9));
        QCOMPARE(reasonOf({MadeTrial({{0.0, 0.0}})}, "localisation_error"), QString("no lump was found"));
        QCOMPARE(reasonOf({MadeTrial({{0.0, 0.0}}).found(0, 0.0, 0.0)}, "size_error"),
                 QString("of no lump that was found the size was said"));
        TrialTrace unasked = MadeTrial({{0.0, 0.0}}).found(0, 0.0, 0.0);
        std::erase_if(unasked.truth, [](const NamedValue& v) { return v.id.starts_with("asks"); });
        QCOMPARE(reasonOf({unasked}, "size_error"), QString("the level asks for no size"));
        QCOMPARE(reasonOf({unasked}, "hardness_order"), QString("the level asks for no hardness"));
    }

    /// That a lump lies there is known beforehand: no evidence of detection. Everything else counts it.
    void anIntroductionIsLeftOutOfDetection() {
        const auto plain = oneLumpEach(40, 30, 20);
        auto introduced = plain;
        TrialTrace first = MadeTrial({{0.0, 0.0}}).found(0, 0.0, 0.0, 5);
        first.truth.push_back({"introduction", 1.0});
        introduced.insert(introduced.begin(), first);
        for (const char* metric : {"palpation_d_prime", "palpation_d_prime_low", "palpation_d_prime_high",
                                   "palpation_criterion", "palpation_roc_area"})
            for (const int version : {1, 2})
                if (findMetric(metric, version)) {
                    QVERIFY(std::isfinite(valueOf(plain, metric, version)));
                    QCOMPARE(valueOf(introduced, metric, version), valueOf(plain, metric, version));
                }
        QCOMPARE(valueOf(introduced, "palpation_hits"), valueOf(plain, "palpation_hits") + 1.0);
        first.truth.back().value = 0.0; // and without the mark it is one as any other
        introduced.front() = first;
        QVERIFY(valueOf(introduced, "palpation_d_prime") > valueOf(plain, "palpation_d_prime"));
    }

    void hardness() {
        QCOMPARE(valueOf({threeLumps()}, "hardness_order", 1), 100.0);
        QCOMPARE(valueOf({threeLumps().say(ReportField::hardness, 0, 5)}, "hardness_order", 1), 0.0);
        QCOMPARE(valueOf({threeLumps().say(ReportField::hardness, 0, 4)}, "hardness_order", 1),
                 0.0); // alike is not right
        // the third one, 3, is called 3: right against 5 called 4, alike with 2 called 3
        QVERIFY(isNear(valueOf({threeLumps().found(3, -0.02, 0.02, 0, 3)}, "hardness_order", 1), 200.0 / 3.0,
                       1e-9));
        QVERIFY(isNear(
            valueOf({threeLumps(), threeLumps().say(ReportField::hardness, 0, 5)}, "hardness_order", 1), 50.0,
            1e-9));
        const QString few("fewer than two lumps of a trial were found and their hardness said");
        QCOMPARE(reasonOf({MadeTrial({{0.0, 0.0}}).found(0, 0.0, 0.0, 0, 3)}, "hardness_order", 1), few);
        const auto one = MadeTrial({{0.0, 0.0, 0.0075, 2}}).found(0, 0.0, 0.0, 0, 3);
        const auto alike =
            MadeTrial({{-0.02, 0.0}, {0.02, 0.0}}).found(0, -0.02, 0.0, 0, 1).found(1, 0.02, 0.0, 0, 5);
        QCOMPARE(reasonOf({alike}, "hardness_order"), QString("the lumps that were found are equally hard"));
        // version 2: lumps of all trials are on one scale
        QCOMPARE(reasonOf({one}, "hardness_order"),
                 QString("fewer than two lumps were found and their hardness said"));
        QCOMPARE(reasonOf({one, one}, "hardness_order"),
                 QString("the lumps that were found are equally hard"));
        const auto harder = MadeTrial({{0.0, 0.0, 0.0075, 4}}).found(0, 0.0, 0.0, 0, 5);
        QCOMPARE(valueOf({one, harder}, "hardness_order"), 100.0);
        QCOMPARE(
            valueOf({one, MadeTrial({{0.0, 0.0, 0.0075, 4}}).found(0, 0.0, 0.0, 0, 2)}, "hardness_order"),
            0.0);
        QCOMPARE(valueOf({one, harder}, "hardness_order_by_chance"), 50.0);
        QVERIFY(std::isnan(valueOf({one, harder}, "hardness_order", 1)));
    }

    /// What feeling nothing gives stands beside what was reached.
    void chance() {
        QVERIFY(isNear(valueOf({threeLumps()}, "hardness_order_by_chance"), 50.0,
                       1e-9)); // one pair, called differently
        QVERIFY(isNear(valueOf({threeLumps().say(ReportField::hardness, 0, 4)}, "hardness_order_by_chance"),
                       0.0, 1e-9)); // alike: never right
        // 3, 4 and 3: two of three pairs differ, so a third is right in random order
        QVERIFY(isNear(valueOf({threeLumps().found(3, -0.02, 0.02, 0, 3)}, "hardness_order_by_chance"),
                       100.0 / 3.0, 1e-9));
        const auto one = MadeTrial({{0.0, 0.0}}).found(0, 0.010, 0.0);
        QVERIFY(isNear(valueOf({threeLumps()}, "size_error_by_chance"), 2.5 / 3.0,
                       1e-9)); // 5, 6 and 7.5 mm about 6
        QVERIFY(isNear(valueOf({threeLumps()}, "size_error_by_chance", 1), 1.25,
                       1e-9)); // of the two that were found
        const double radius_mm = 1e3 * palpationTruthOf(TrialTrace(one).truth)->hitRadius_m;
        QVERIFY(isNear(valueOf({one, one}, "localisation_error_by_chance"), radius_mm * 2.0 / 3.0, 1e-9));
        QCOMPARE(reasonOf({MadeTrial({{0.0, 0.0}})}, "localisation_error_by_chance"),
                 QString("no lump was found"));
    }

    /// 20 lumps in 20 trials of nine regions: 15 found, 8 of 160 lump-free regions with a false alarm.
    void sensitivity() {
        const auto trials = oneLumpEach(20, 15, 8);
        double zH = core::normalQuantile(15.5 / 21.0);
        double zF = core::normalQuantile(8.5 / 161.0);
        QVERIFY(isNear(zH, 0.6375, 1e-4) && isNear(zF, -1.6183, 1e-4)); // by a table
        QVERIFY(isNear(valueOf(trials, "palpation_d_prime", 1), zH - zF, 1e-12));
        QVERIFY(isNear(valueOf(trials, "palpation_criterion", 1), -0.5 * (zH + zF), 1e-12));
        // version 2: one region in nine has a lump
        zH = core::normalQuantile((15.0 + 1.0 / 9.0) / (20.0 + 2.0 / 9.0));
        zF = core::normalQuantile((8.0 + 8.0 / 9.0) / (160.0 + 16.0 / 9.0));
        QVERIFY(isNear(valueOf(trials, "palpation_d_prime"), zH - zF, 1e-12));
        QVERIFY(isNear(valueOf(trials, "palpation_criterion"), -0.5 * (zH + zF), 1e-12));
        QVERIFY(isNear(
            0.5 * (valueOf(trials, "palpation_d_prime_low") + valueOf(trials, "palpation_d_prime_high")),
            zH - zF, 1e-12));
        QVERIFY(valueOf(trials, "palpation_d_prime_low") > 1.0); // it was felt
        // sure of every hit, guessed every false alarm: ¾ straight up, then to (0.05, 0.75), then to (1, 1)
        QVERIFY(isNear(valueOf(trials, "palpation_roc_area"), 0.05 * 0.75 + 0.95 * 0.875, 1e-12));
    }

    void sensitivityOfExtremes() {
        const double z = core::normalQuantile(20.5 / 21.0);
        const double none = core::normalQuantile(0.5 / 161.0);
        QVERIFY(
            isNear(valueOf(oneLumpEach(20, 20, 0), "palpation_d_prime", 1), z - none, 1e-12)); // all right
        QVERIFY(isNear(valueOf(oneLumpEach(20, 0, 0), "palpation_d_prime", 1), -z - none,
                       1e-12)); // no marks: version 1 has 0.67
        const auto silent = oneLumpEach(20, 0, 0);
        QVERIFY(isNear(valueOf(silent, "palpation_d_prime"), 0.0, 1e-12)); // who says nothing shows nothing
        QVERIFY(valueOf(silent, "palpation_d_prime_low") < 0.0 &&
                valueOf(silent, "palpation_d_prime_high") > 0.0);
        QCOMPARE(reasonOf(oneLumpEach(20, 0, 0), "palpation_roc_area"),
                 QString("nobody said how sure a finding is"));
    }

    /// Pressed over the limit (4 N) within reach of a lump: not found, nor in any region; beside it, or
    /// gently: found.
    void pressedTooHardIsNotFound() {
        const auto hard = [](double force_N, double x_m) {
            MadeTrial trial({{0.02, 0.02}});
            trial.found(0, 0.02, 0.021).press(0, 50, 60, force_N);
            TrialTrace made = trial;
            for (std::size_t i = 0; i < made.tools[0].p_WT_m.size(); ++i)
                made.tools[0].p_WT_m[i] = core::Vec3(x_m, 0.02, -0.006);
            return made;
        };
        QCOMPARE(valueOf({hard(3.9, 0.02)}, "palpation_hits"), 1.0);
        QCOMPARE(valueOf({hard(4.1, 0.02)}, "palpation_hits"), 0.0);
        QCOMPARE(valueOf({hard(4.1, 0.02)}, "palpation_misses"), 1.0);
        QCOMPARE(valueOf({hard(4.1, 0.02)}, "palpation_false_alarms"), 0.0);
        QCOMPARE(valueOf({hard(4.1, 0.02)}, "palpation_hits", 1), 1.0);
        QCOMPARE(valueOf({hard(4.1, -0.02)}, "palpation_hits"),
                 1.0); // elsewhere: the gate on time over the limit minds that
        TrialTrace broken = hard(1.0, 0.02);
        broken.tools[0].contact.assign(broken.tools[0].t_s.size(), 0);
        broken.tools[0].contact[55] = core::contact_bits::kThrough;
        QCOMPARE(valueOf({broken}, "palpation_hits"), 0.0);
        auto all = oneLumpEach(20, 20, 0);
        const double found = valueOf(all, "palpation_d_prime");
        for (TrialTrace& trial : all)
            for (ToolTrace& tool : trial.tools) {
                tool.tissue_N[50] = core::Vec3(0.0, 0.0, 9.0);
                for (core::Vec3& p : tool.p_WT_m)
                    p = core::Vec3(0.0, 0.0, 0.0);
            }
        QVERIFY(valueOf(all, "palpation_d_prime") < found - 1.0);
    }

    void tooFew() {
        for (const char* id : {"palpation_d_prime", "palpation_criterion", "palpation_roc_area"}) {
            QCOMPARE(reasonOf(oneLumpEach(19, 19, 0), id),
                     QString("only 19 regions with a lump and 152 without: 20 of each are needed"));
            const auto card = calculateScore(palpationSession(oneLumpEach(20, 15, 8)),
                                             std::vector<MetricRequest>{{id, 1}}, {}, true);
            QVERIFY(card && card->metrics[0].value &&
                    !card->trials[0][0].value); // a session has enough, each of its trials not
            QCOMPARE(card->trials[0][0].reason,
                     std::string("only 1 regions with a lump and 8 without: 20 of each are needed"));
        }
    }

    void coverage() {
        QVERIFY(
            isNear(valueOf({MadeTrial().covered(0.5), MadeTrial().covered(0.8)}, "coverage"), 65.0, 1e-9));
        TrialTrace bare = MadeTrial();
        bare.quantities.clear();
        QCOMPARE(reasonOf({MadeTrial(), bare}, "coverage"), QString("the trace has no coverage"));
    }

    /// Two fingers: 0.5 to 1.5 s with 1 N, and 1 to 2 s, half of it with 3 N.
    void pressing() {
        auto trial = MadeTrial({}, 2).press(0, 50, 150, 1.0).press(1, 100, 150, 0.8).press(1, 150, 200, 3.0);
        QVERIFY(isNear(valueOf({trial}, "pressing_time"), 1.5, 1e-9));
        QVERIFY(isNear(valueOf({trial}, "force_band_time"), 75.0, 1e-9)); // of two finger-seconds
        QVERIFY(isNear(valueOf({trial, trial}, "pressing_time"), 3.0, 1e-9));
        trial.pause(150, 200);
        QVERIFY(isNear(valueOf({trial}, "pressing_time"), 1.0, 1e-9));
        QVERIFY(isNear(valueOf({trial}, "force_band_time"), 100.0, 1e-9));
        QVERIFY(isNear(valueOf({MadeTrial().press(0, 0, 100, 0.02)}, "pressing_time"), 0.0,
                       1e-12)); // not over 0.02 N
        QVERIFY(isNear(valueOf({MadeTrial().press(0, 0, 100, 2.5)}, "force_band_time"), 100.0,
                       1e-9)); // both ends belong to it
        QVERIFY(isNear(valueOf({MadeTrial().press(0, 0, 100, 2.501)}, "force_band_time"), 0.0, 1e-9));
        QCOMPARE(reasonOf({MadeTrial()}, "force_band_time"), QString("nothing was pressed"));
        TrialTrace bare = MadeTrial();
        bare.truth.clear();
        QCOMPARE(reasonOf({bare}, "force_band_time"), QString("the trace has no force band"));
        bare.forcesKnown = false;
        QCOMPARE(reasonOf({bare}, "pressing_time"), QString("the trace has no forces"));
    }

    void searching() {
        QVERIFY(isNear(valueOf({MadeTrial().timedOut()}, "searching_time"), 3.0, 1e-9));
        QVERIFY(
            isNear(valueOf({MadeTrial().at(200).say(ReportField::done, -1)}, "searching_time"), 2.0, 1e-9));
        QVERIFY(
            isNear(valueOf({MadeTrial().pause(50, 150).at(200).say(ReportField::done, -1)}, "searching_time"),
                   1.0, 1e-9));
        QVERIFY(isNear(valueOf({MadeTrial(), MadeTrial()}, "searching_time"), 6.0, 1e-9));
    }

    void absentWithTheReason() {
        for (const char* id : {"palpation_hits", "palpation_misses", "palpation_false_alarms",
                               "palpation_d_prime", "palpation_criterion", "palpation_roc_area",
                               "localisation_error", "size_error", "hardness_order"}) {
            TrialTrace bare = threeLumps();
            bare.truth.clear();
            QCOMPARE(reasonOf({threeLumps(), bare}, id), QString("the trace has no lumps and search area"));
            bare = threeLumps();
            bare.quantities.clear();
            QCOMPARE(reasonOf({threeLumps(), bare}, id), QString("the trace has no reports"));
            QCOMPARE(reasonOf({}, id), QString("no trials"));
        }
        QCOMPARE(reasonOf({}, "searching_time"), QString("no trials"));
    }

    /// Quantities and truth through a file and back: every score is the same double.
    void throughATraceFile() {
        auto two = oneLumpEach(20, 15, 8);
        two.push_back(threeLumps().press(0, 50, 150, 1.0).covered(1.0 / 3.0));
        SessionTrace before = palpationSession(two);
        for (std::size_t t = 0; t < before.trials.size(); ++t)
            for (double& s : before.trials[t].tools[0].t_s)
                s += 4.0 * static_cast<double>(t); // trials follow one another
        const auto rows = readTraceCsv(writeTraceCsv(rowsOf(before)), "palpation.csv");
        QVERIFY2(rows, rows ? "" : rows.error().message.c_str());
        const auto after = buildSessionTrace(*rows, "palpation");
        QVERIFY2(after, after ? "" : after.error().message.c_str());
        for (const char* id :
             {"palpation_hits", "palpation_misses", "palpation_false_alarms", "palpation_d_prime",
              "palpation_criterion", "palpation_roc_area", "localisation_error", "size_error",
              "hardness_order", "coverage", "force_band_time", "pressing_time", "searching_time"}) {
            const auto a = metricOf(before, id);
            QVERIFY2(a.value && a.value == metricOf(*after, id).value, id);
        }
    }
};

QTEST_APPLESS_MAIN(TestPalpationMetrics)
#include "test_palpation_metrics.moc"
