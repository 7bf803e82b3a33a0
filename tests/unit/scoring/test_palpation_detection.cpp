// SPDX-License-Identifier: GPL-3.0-or-later
// What a trial of a palpation is judged to be: reports read back, findings matched to lumps, regions, ROC.
#include "core/random.h"
#include "curriculum/exercises/palpation/scoring/palpation_answer.h"
#include "curriculum/exercises/palpation/scoring/roc_curve.h"
#include "palpation_traces.h"

#include <QtTest>
#include <algorithm>
#include <cmath>
#include <limits>

using namespace chiron;
using namespace chiron::scoring;
using simulation::ReportField;
using tests::MadeLump;
using tests::MadeTrial;

namespace {

bool isNear(double a, double b, double tolerance) {
    return std::abs(a - b) <= tolerance;
}

PalpationAnswer answerOf(const MadeTrial& trial) {
    JudgedTrial judged = judgePalpation(trial);
    if (!judged.answer)
        qFatal("%s", storedText({judged.reason, {}}).c_str());
    return std::move(*judged.answer);
}

std::string reasonOf(const TrialTrace& trial) {
    return judgePalpation(trial).answer ? std::string() : storedText({judgePalpation(trial).reason, {}});
}

/// As many regions of each answer as told, surest first.
RatingCounts ratings(std::array<int, 7> ofSignal, std::array<int, 7> ofNoise) {
    return {ofSignal, ofNoise};
}

} // namespace

class TestPalpationDetection : public QObject {
    Q_OBJECT
private slots:
    void reportsComeBack() {
        MadeTrial trial;
        trial.found(0, 0.001, 0.002, 4, 3, 75).found(1, -0.01, 0.0);
        trial.say(ReportField::select, 0).say(ReportField::confidence, 0, 2); // rated again
        trial.say(ReportField::remove, 1).say(ReportField::done, -1);
        const PalpationAnswer answer = answerOf(trial);
        QCOMPARE(answer.reports.size(), std::size_t{9});
        QCOMPARE(answer.reports.front().t_s, 1.0);
        const simulation::Finding& first = answer.findings.list()[0];
        QVERIFY(first.present && answer.findings.done() && !answer.findings.has(1));
        QCOMPARE(first.p_W[1], 0.002);
        QCOMPARE(first.radius_m, 0.0075);
        QCOMPARE(int(first.confidence), 2);
        QCOMPARE(int(first.hardness), 3);
        const auto early = findingsAfter(answer.reports, 1.045); // five were made by then
        QVERIFY(early.has(1) && !early.done());
        QCOMPARE(int(early.list()[0].confidence), 4);
    }

    void reportsThatATraceDoesNotTell() {
        MadeTrial trial;
        trial.found(0, 0.0, 0.0);
        TrialTrace jump = trial;
        for (std::size_t i = 200; i < MadeTrial::kSamples; ++i)
            jump.quantities[0].values[i] = 3.0; // two at once: one is not told
        QCOMPARE(reportsOf(jump)->lost, 1);
        QCOMPARE(reasonOf(jump), std::string("the trace lost reports"));
        for (const auto& [column, value] :
             {std::pair{1, 9.0}, {1, std::nan("")}, {2, 8.0}, {2, -1.0}, {3, 5000.0}, {4, HUGE_VAL}}) {
            TrialTrace odd = trial;
            for (double& v : odd.quantities[static_cast<std::size_t>(column)].values)
                v = value;
            QCOMPARE(reportsOf(odd)->lost, 1);
        }
        TrialTrace wild = trial;
        wild.quantities[0].values.back() = 1e300;
        QCOMPARE(reportsOf(wild)->reports.size(), std::size_t{1});
        TrialTrace bare = trial;
        bare.quantities.erase(bare.quantities.begin() + 3);
        QCOMPARE(reasonOf(bare), std::string("the trace has no reports"));
        bare = trial;
        bare.tools.clear();
        QCOMPARE(reasonOf(bare), std::string("the trace has no reports"));
    }

    void truthThatCannotBe() {
        const std::string refused = "the trace has no lumps and search area";
        for (const auto& [id, value] : {std::pair<std::string, double>{"lumps", 7.0},
                                        {"lumps", -1.0},
                                        {"region_columns", 0.0},
                                        {"region_rows", 1e9},
                                        {"area_half_x_m", 0.0},
                                        {"hit_radius_m", -0.001},
                                        {"lump_0_hardness", 6.0},
                                        {"lump_0_radius_m", std::nan("")}}) {
            TrialTrace trial = MadeTrial({{0.0, 0.0}});
            for (NamedValue& named : trial.truth)
                if (named.id == id)
                    named.value = value;
            QVERIFY2(reasonOf(trial) == refused, id.c_str());
            trial = MadeTrial({{0.0, 0.0}});
            std::erase_if(trial.truth, [&id = id](const NamedValue& named) { return named.id == id; });
            QVERIFY2(reasonOf(trial) == refused, id.c_str());
        }
    }

    /// Reach is 12 mm, or the lump's own radius; the border belongs to it.
    void reach() {
        const auto hits = [](double x_m, double radius_m) {
            return answerOf(MadeTrial({{0.0, 0.0, radius_m}}).found(0, x_m, 0.0)).hits();
        };
        QCOMPARE(hits(0.012, 0.0075), 1);
        QCOMPARE(hits(0.0121, 0.0075), 0);
        QCOMPARE(hits(0.0121, 0.014), 1);
        QCOMPARE(hits(0.0141, 0.014), 0);
    }

    /// Eight marks on one lump: one hit (the nearest), seven false alarms, none of which is a region's.
    void eightMarksOnOneLump() {
        MadeTrial trial({{0.0, 0.0}});
        for (int i = 0; i < 8; ++i)
            trial.found(i, 0.001 * (8 - i), 0.0);
        const PalpationAnswer answer = answerOf(trial);
        QCOMPARE(answer.hits(), 1);
        QCOMPARE(answer.misses(), 0);
        QCOMPARE(answer.falseAlarms(), 7);
        QCOMPARE(foundBy(answer.matches, 0)->finding, 7);
        QVERIFY((countsOf(answer.regions) == core::DetectionCounts{1, 1, 0, 8}));
    }

    /// Nearest pair first: finding 0 is nearer to both lumps than 1, and takes the one that is nearest of
    /// all.
    void nearestPairFirst() {
        const PalpationAnswer answer =
            answerOf(MadeTrial({{0.0, 0.0}, {0.016, 0.0}}).found(0, 0.009, 0.0).found(1, 0.002, 0.010));
        QCOMPARE(answer.matches[0].lump, 1);
        QVERIFY(isNear(answer.matches[0].distance_m, 0.007, 1e-12));
        QCOMPARE(answer.matches[1].lump, 0);
        QVERIFY(isNear(answer.matches[1].distance_m, std::hypot(0.002, 0.010), 1e-12));
    }

    void nothingMarkedAndNothingThere() {
        const PalpationAnswer silent = answerOf(MadeTrial({{0.0, 0.0}, {0.02, 0.02}}));
        QCOMPARE(silent.misses(), 2);
        QVERIFY((countsOf(silent.regions) == core::DetectionCounts{0, 2, 0, 7}));
        const PalpationAnswer nothing = answerOf(MadeTrial().found(0, 0.0, 0.0, 3));
        QCOMPARE(nothing.misses(), 0);
        QVERIFY((countsOf(nothing.regions) == core::DetectionCounts{0, 0, 1, 9}));
        QVERIFY(std::isinf(nothing.matches[0].distance_m));
    }

    /// A border belongs to the region further along; the area's own far edge to the last one.
    void borders() {
        const PalpationTruth truth = *palpationTruthOf(MadeTrial().trial().truth);
        QCOMPARE(regionAt(truth, {-0.03, -0.03, 0.0}), 0);
        QCOMPARE(regionAt(truth, {-0.01 - 1e-12, 0.0, 0.0}), 3);
        QCOMPARE(regionAt(truth, {-0.01 + 1e-12, 0.0, 0.0}), 4);
        QCOMPARE(regionAt(truth, {0.03, 0.03, 0.0}), 8);
        QCOMPARE(regionAt(truth, {0.0301, 0.0, 0.0}), FindingMatch::kNone);
        QCOMPARE(regionAt(truth, {0.0, std::nan(""), 0.0}), FindingMatch::kNone);
        // exactly on a border that a double can hold: 2 × 2 regions meet at 0
        PalpationTruth four = truth;
        four.regionColumns = four.regionRows = 2;
        QCOMPARE(regionAt(four, {0.0, 0.0, 0.0}), 3);
        QCOMPARE(regionAt(four, {-1e-15, 0.0, 0.0}), 2);
    }

    /// A finding that found a lump of the next region counts there and is no false alarm where it lies; one
    /// outside the area is of no region; the highest confidence stands.
    void regionsOfFindings() {
        MadeTrial trial({{0.009, 0.0}});
        trial.found(0, 0.012, 0.0, 4); // beyond the border: finds the lump of the middle
        trial.found(1, -0.02, 0.02, 2).found(2, -0.025, 0.025, 5); // one lump-free region twice
        trial.found(3, 0.04, 0.0, 5);                              // outside
        trial.found(4, -0.009, -0.009, 5);                         // in the lump's region, out of reach
        const PalpationAnswer answer = answerOf(trial);
        QCOMPARE(answer.hits(), 1);
        QCOMPARE(answer.falseAlarms(), 4);
        QVERIFY((countsOf(answer.regions) == core::DetectionCounts{1, 1, 1, 8}));
        QCOMPARE(answer.regions[4].confidence, 4);
        QVERIFY(!answer.regions[5].reported);
        QCOMPARE(answer.regions[6].confidence, 5);
    }

    /// Where no two distances are alike, the order in which findings were made changes nothing.
    void orderDoesNotMatter() {
        core::Random random(11);
        const auto place = [&random] { return 0.06 * (random.uniform() - 0.5); };
        for (int round = 0; round < 200; ++round) {
            std::vector<MadeLump> lumps;
            for (int i = 0; i < 4; ++i)
                lumps.push_back({place(), place()});
            std::vector<std::pair<double, double>> marks;
            for (int i = 0; i < 6; ++i)
                marks.emplace_back(place(), place());
            MadeTrial forth(lumps);
            MadeTrial back(lumps);
            for (int i = 0; i < 6; ++i) {
                forth.found(i, marks[static_cast<std::size_t>(i)].first,
                            marks[static_cast<std::size_t>(i)].second);
                back.found(i, marks[static_cast<std::size_t>(5 - i)].first,
                           marks[static_cast<std::size_t>(5 - i)].second);
            }
            const PalpationAnswer a = answerOf(forth);
            const PalpationAnswer b = answerOf(back);
            QCOMPARE(a.hits(), b.hits());
            for (std::size_t i = 0; i < 6; ++i)
                QCOMPARE(a.matches[i].lump, b.matches[5 - i].lump);
            QVERIFY(countsOf(a.regions) == countsOf(b.regions));
        }
    }

    void rocOfRatings() {
        const auto perfect = rocOf(ratings({10, 5, 3, 2, 0, 0, 0}, {0, 0, 0, 0, 0, 0, 20}));
        QCOMPARE(perfect->area, 1.0);
        QVERIFY(!perfect->dA);
        const auto nothing = rocOf(ratings({2, 4, 6, 8, 10, 0, 70}, {1, 2, 3, 4, 5, 0, 35}));
        QVERIFY(isNear(nothing->area, 0.5, 1e-12));
        QVERIFY(isNear(*nothing->dA, 0.0, 1e-12) && isNear(*nothing->slope, 1.0, 1e-12));
        const auto silent = rocOf(ratings({0, 0, 0, 0, 0, 0, 20}, {0, 0, 0, 0, 0, 0, 30}));
        QCOMPARE(silent->area, 0.5);
        const auto reversed = rocOf(ratings({0, 0, 0, 0, 0, 0, 20}, {20, 0, 0, 0, 0, 0, 0}));
        QCOMPARE(reversed->area, 0.0);
        QVERIFY(!rocOf(ratings({1, 0, 0, 0, 0, 0, 0}, {})) && !rocOf(ratings({}, {1, 0, 0, 0, 0, 0, 0})));
    }

    /// By hand: of 4 lumps 2 sure, 1 unrated, 1 silent; of 4 places without 1 at 3, 3 silent. Points (0, ½),
    /// (¼, ½), (¼, ¾), (1, 1): area ¼·½ + ¾·⅞ = 0.78125.
    void rocByHand() {
        const auto curve = rocOf(ratings({2, 0, 0, 0, 0, 1, 1}, {0, 0, 1, 0, 0, 0, 3}));
        QVERIFY(isNear(curve->area, 0.78125, 1e-12));
        QCOMPARE(curve->points.size(), std::size_t{8});
        QCOMPARE(curve->points.front().hitRate, 0.0);
        QCOMPARE(curve->points.back().falseAlarmRate, 1.0);
        for (std::size_t i = 1; i < curve->points.size(); ++i)
            QVERIFY(curve->points[i].hitRate >= curve->points[i - 1].hitRate &&
                    curve->points[i].falseAlarmRate >= curve->points[i - 1].falseAlarmRate &&
                    curve->points[i].confidence < curve->points[i - 1].confidence);
    }

    /// 40,000 ratings of an observer with d′ = 1.5 and spreads 1 and 1.25: slope 0.8 and d_a = √(2/(1 +
    /// 0.64))·0.8·1.5 = 1.3252; the straight lines between five points lie a little below the curve's area
    /// Φ(d_a/√2) = 0.8257.
    void rocOfAGaussianObserver() {
        core::Random random(5);
        RatingCounts counts;
        const auto answer = [](double x) {
            const double edges[] = {2.4, 1.7, 1.1, 0.6, 0.1};
            return static_cast<std::size_t>(
                std::find_if(std::begin(edges), std::end(edges), [x](double e) { return x > e; }) -
                std::begin(edges));
        };
        for (int i = 0; i < 20000; ++i) {
            const std::size_t said = answer(1.5 + 1.25 * random.normal());
            const std::size_t saidOfNoise = answer(random.normal());
            ++counts.ofSignal[said == 5 ? 6 : said];
            ++counts.ofNoise[saidOfNoise == 5 ? 6 : saidOfNoise];
        }
        const auto curve = rocOf(counts);
        QVERIFY2(isNear(*curve->slope, 0.8, 0.03), qPrintable(QString::number(*curve->slope)));
        QVERIFY2(isNear(*curve->dA, 1.3252, 0.04), qPrintable(QString::number(*curve->dA)));
        QVERIFY2(curve->area < 0.8257 + 0.005 && curve->area > 0.8257 - 0.03,
                 qPrintable(QString::number(curve->area)));
    }

    void regionsBecomeRatings() {
        RatingCounts counts;
        const std::vector<DetectionRegion> regions{
            {true, true, 5}, {true, true, 0}, {true, false, -1}, {false, true, 1}, {false, false, -1}};
        counts.add(regions);
        RatingCounts twice = counts;
        twice += counts;
        QVERIFY((counts.ofSignal == std::array<int, 7>{1, 0, 0, 0, 0, 1, 1}));
        QVERIFY((counts.ofNoise == std::array<int, 7>{0, 0, 0, 0, 1, 0, 1}));
        QVERIFY((twice.counts() == core::DetectionCounts{4, 6, 2, 4}));
    }
};

QTEST_APPLESS_MAIN(TestPalpationDetection)
#include "test_palpation_detection.moc"
