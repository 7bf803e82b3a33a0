// SPDX-License-Identifier: GPL-3.0-or-later
// What participants say together: published meta-analyses, known populations, groups that are none.
#include "psychophysics/measures/adjustment_summary.h"
#include "psychophysics/measures/magnitude_estimation.h"
#include "psychophysics/measures/random_effects.h"
#include "psychophysics/study/group_estimate.h"
#include "tests/unit/psychophysics/measures/published_line.h"

#include "core/normal_distribution.h"
#include "core/random.h"

using namespace chiron::psychophysics;

namespace {

/// One participant's estimate: log10 W as given, measured with this error.
RunEstimate runOf(double log10Weber, double error) {
    RunEstimate run;
    run.weber = std::pow(10.0, log10Weber);
    run.weber95 = {std::pow(10.0, log10Weber - 1.959963984540054 * error),
                   std::pow(10.0, log10Weber + 1.959963984540054 * error)};
    run.jnd = 200.0 * run.weber;
    run.unit = "N/m";
    return run;
}

bool warns(const std::vector<Warning>& warnings, const char* token) {
    for (const Warning& warning : warnings)
        if (warningText(warning).starts_with(std::string(token) + ": "))
            return true;
    return false;
}

} // namespace

class TestGroupEstimate : public QObject {
    Q_OBJECT
private slots:
    void publishedMetaAnalysis();
    void balancedClosedForm();
    void populationsRecovered();
    void pairedConditions();
    void unpairedConditions();
    void adjustedByHolm();
    void thresholdModels();
    void degenerate();
    void modulusEqualised();
    void threeSubjectsAreEnough();
    void sealedAnswersAreNoAnswersWithoutAValue();
};

/// BCG vaccine trials (Colditz et al. 1994; the metafor package's dat.bcg): log risk ratios and variances,
/// REML: mu -0.7145, tau2 0.3132, Q 152.2330 on 12 degrees of freedom; with Hartung–Knapp the interval is
/// -1.1063..-0.3227 (SE 0.1807 normal; 0.1808 here).
void TestGroupEstimate::publishedMetaAnalysis() {
    const std::vector<double> y{-0.8893, -1.5854, -1.3481, -1.4416, -0.2175, -0.7861, -1.6209,
                                0.0120,  -0.4694, -1.3713, -0.3394, 0.4459,  -0.0173};
    const std::vector<double> v{0.3256, 0.1946, 0.4154, 0.0200, 0.0512, 0.0069, 0.2230,
                                0.0040, 0.0564, 0.0730, 0.0124, 0.5325, 0.0714};
    const RandomEffects effects = randomEffects(y, v);
    PublishedLine line("metafor dat.bcg, REML");
    line.compare(effects.mean, -0.7145, 2e-4);
    line.compare(effects.tau * effects.tau, 0.3132, 3e-4);
    line.compare(effects.q, 152.2330,
                 0.5); // the variances are printed with four digits: 0.0040 alone moves Q by more
    QVERIFY(line.holds());
    qInfo("interval %.4f..%.4f, SE %.4f", effects.low, effects.high, effects.standardError);
    QVERIFY(effects.low < -1.0 && effects.high > -0.4 && effects.qP < 1e-10 && effects.pZero < 0.01);
}

/// Equal errors: REML is the variance of the estimates less the error's, and the mean the plain mean.
void TestGroupEstimate::balancedClosedForm() {
    const std::vector<double> y{0.1, 0.4, -0.3, 0.6, 0.2};
    const RandomEffects effects = randomEffects(y, std::vector<double>(5, 0.01));
    QVERIFY(std::abs(effects.mean - 0.2) < 1e-12);
    QVERIFY(std::abs(effects.tau * effects.tau - (0.46 / 4.0 - 0.01)) < 1e-9); // Σ(y − 0.2)² = 0.46
    QVERIFY(std::abs(effects.standardError - std::sqrt(0.46 / 4.0 / 5.0)) < 1e-9);
    QVERIFY(std::abs(effects.high - 0.2 - 2.7764451 * std::sqrt(0.115 / 5.0)) <
            1e-6); // t of 4 degrees of freedom
    QVERIFY(std::abs(effects.predictionHigh - 0.2 - 3.1824463 * std::sqrt(0.105 + 0.115 / 5.0)) <
            1e-6); // of 3 (Higgins et al. 2009)
    const RandomEffects alike = randomEffects({0.2, 0.21, 0.19}, {0.1, 0.1, 0.1});
    QVERIFY(alike.tau == 0.0 && std::abs(alike.standardError - std::sqrt(0.1 / 3.0)) < 1e-12);
}

void TestGroupEstimate::populationsRecovered() {
    int covered = 0;
    int bootstrapped = 0;
    double tau = 0.0;
    for (int seed = 1; seed <= 40; ++seed) {
        auto random = chiron::core::Random::stream(static_cast<std::uint64_t>(seed), "group");
        std::vector<RunEstimate> runs;
        for (int i = 0; i < 10; ++i) {
            const double error = random.uniform(0.04, 0.1);
            runs.push_back(runOf(-0.9 + 0.12 * random.normal() + error * random.normal(), error));
        }
        const GroupEstimate group = estimateGroup(runs, static_cast<std::uint64_t>(seed));
        const double truth = std::pow(10.0, -0.9);
        covered += group.weber95.low <= truth && truth <= group.weber95.high ? 1 : 0;
        bootstrapped += group.bootstrap95.low <= truth && truth <= group.bootstrap95.high ? 1 : 0;
        tau += group.sdBetweenLog10 / 40.0;
    }
    qInfo("10 participants: Hartung-Knapp covers %.3f, bootstrap %.3f, between-subject sd %.3f (0.12)",
          covered / 40.0, bootstrapped / 40.0, tau);
    QVERIFY(covered >= 34 && bootstrapped >= 30); // the bootstrap of 10 is known to be short
    QVERIFY(std::abs(tau - 0.12) < 0.025);
    const std::vector<RunEstimate> six{runOf(-1.0, 0.05), runOf(-0.9, 0.05), runOf(-0.8, 0.05),
                                       runOf(-1.1, 0.05), runOf(-0.7, 0.05), runOf(-0.9, 0.05)};
    const GroupEstimate once = estimateGroup(six, 4);
    const GroupEstimate again = estimateGroup(six, 4);
    QCOMPARE(once.bootstrap95.low, again.bootstrap95.low);
    QVERIFY(std::abs(once.weber - std::pow(10.0, -0.9)) < 1e-6 && once.unit == "N/m" &&
            std::abs(once.jnd - 200.0 * once.weber) < 1e-6);
    QVERIFY(warns(once.warnings, "heterogeneous") && once.prediction95.low < once.weber95.low);
}

void TestGroupEstimate::pairedConditions() {
    chiron::core::Random random(3);
    std::vector<RunEstimate> first;
    std::vector<RunEstimate> second;
    for (int i = 0; i < 12; ++i) {
        const double person = -0.9 + 0.2 * random.normal();
        first.push_back(runOf(person + 0.03 * random.normal(), 0.03));
        second.push_back(runOf(person + std::log10(1.5) + 0.03 * random.normal(), 0.03));
    }
    const ConditionComparison compared = compareConditions(first, second, 1);
    QVERIFY(compared.ratio95.low < 1.5 && 1.5 < compared.ratio95.high && compared.pValue < 1e-5 &&
            compared.participants == 12);
    QVERIFY(compared.bootstrap95.low > 1.2 && compared.bootstrap95.high < 1.8);
    second[3].weber = std::nan("");
    second.pop_back();
    QVERIFY(compareConditions(first, second, 1).participants == 10);
    QVERIFY(std::isnan(compareConditions({}, {}, 1).ratio) &&
            warns(compareConditions(first, {}, 1).warnings, "no_participants"));
}

/// Two groups of people: the interval holds the true ratio in about 95 of 100 studies, and a ratio of 1 is
/// found in about 5.
void TestGroupEstimate::unpairedConditions() {
    int held = 0, found = 0;
    constexpr int kStudies = 400;
    for (int study = 0; study < kStudies; ++study) {
        auto random = chiron::core::Random::stream(static_cast<std::uint64_t>(study) + 1, "two groups");
        std::vector<RunEstimate> first, second;
        for (int i = 0; i < 8; ++i)
            first.push_back(runOf(-0.9 + 0.15 * random.normal() + 0.06 * random.normal(), 0.06));
        for (int i = 0; i < 14; ++i)
            second.push_back(
                runOf(-0.9 + std::log10(1.4) + 0.25 * random.normal() + 0.06 * random.normal(), 0.06));
        const ConditionComparison compared = compareGroups(first, second);
        held += compared.ratio95.low <= 1.4 && 1.4 <= compared.ratio95.high ? 1 : 0;
        for (RunEstimate& run : second)
            run.weber /= 1.4, run.weber95.low /= 1.4, run.weber95.high /= 1.4;
        found += compareGroups(first, second).pValue < 0.05 ? 1 : 0;
        QVERIFY(!compared.paired && compared.first == 8 && compared.second == 14 &&
                compared.participants == 22);
    }
    qInfo("unpaired: interval holds %.3f, false alarms %.3f", static_cast<double>(held) / kStudies,
          static_cast<double>(found) / kStudies);
    QVERIFY(held >= 367 && found <= 33); // 95 and 5 %, three standard errors
    const ConditionComparison one = compareGroups({runOf(-1.0, 0.1)}, {runOf(-0.7, 0.1), runOf(-0.8, 0.1)});
    QVERIFY(std::abs(one.ratio - std::pow(10.0, 0.25)) < 1e-6 && std::isnan(one.pValue) &&
            std::isnan(compareGroups({}, {}).ratio));
}

/// Holm 1979: 0.01, 0.02, 0.03 and 0.04 of four become 0.04, 0.06, 0.06, 0.06; what has no p is not counted.
void TestGroupEstimate::adjustedByHolm() {
    std::vector<ConditionComparison> all(5);
    const double p[] = {0.03, 0.01, std::nan(""), 0.04, 0.02};
    const double expected[] = {0.06, 0.04, std::nan(""), 0.06, 0.06};
    std::vector<ConditionComparison*> each;
    for (std::size_t i = 0; i < all.size(); ++i) {
        all[i].pValue = p[i];
        each.push_back(&all[i]);
    }
    adjustHolm(each);
    for (std::size_t i = 0; i < all.size(); ++i)
        QVERIFY(std::isnan(expected[i]) ? std::isnan(all[i].pHolm)
                                        : std::abs(all[i].pHolm - expected[i]) < 1e-12);
}

/// Thresholds alike: p below 0.05 in about 1 of 20 studies of six people; apart by a factor of 1.67: nearly
/// always.
void TestGroupEstimate::thresholdModels() {
    int falsely = 0, found = 0;
    constexpr int kStudies = 150;
    const auto runAt = [](double threshold, chiron::core::Random& random) {
        RunEstimate run;
        for (const double d : {0.02, 0.03, 0.045, 0.07, 0.1, 0.15, 0.22}) {
            int right = 0;
            for (int trial = 0; trial < 20; ++trial)
                right += random.uniform() <
                                 0.5 + 0.49 * chiron::core::normalCumulative(std::log10(d / threshold) / 0.3)
                             ? 1
                             : 0;
            run.points.push_back({d, right, 20});
        }
        return run;
    };
    for (int study = 0; study < kStudies; ++study) {
        auto random = chiron::core::Random::stream(static_cast<std::uint64_t>(study) + 1, "threshold models");
        std::vector<RunEstimate> first, alike, apart;
        for (int i = 0; i < 6; ++i) {
            first.push_back(runAt(0.06, random));
            alike.push_back(runAt(0.06, random));
            apart.push_back(runAt(0.1, random));
        }
        const ThresholdModels none = compareThresholdModels(Task::twoAfc, first, Task::twoAfc, alike);
        QVERIFY(none.participants == 6 && none.freedom == 6 &&
                std::abs(none.aicDifference - (none.likelihoodRatio - 12.0)) < 1e-9);
        falsely += none.pValue < 0.05 ? 1 : 0;
        found += compareThresholdModels(Task::twoAfc, first, Task::twoAfc, apart).pValue < 0.05 ? 1 : 0;
    }
    qInfo("threshold models: found falsely %d, truly %d of %d", falsely, found, kStudies);
    QVERIFY(falsely <= 17 && found >= 135); // 5 %, three standard errors
    QVERIFY(compareThresholdModels(Task::twoAfc, {}, Task::twoAfc, {}).participants == 0);
    QVERIFY(
        compareThresholdModels(Task::twoAfc, {RunEstimate{}}, Task::threeAfc, {RunEstimate{}}).participants ==
        0);
}

void TestGroupEstimate::degenerate() {
    QVERIFY(std::isnan(estimateGroup({}, 1).weber) &&
            warns(estimateGroup({}, 1).warnings, "no_participants"));
    const GroupEstimate one = estimateGroup({runOf(-1.0, 0.1)}, 1);
    QVERIFY(std::abs(one.weber - 0.1) < 1e-9 && std::isnan(one.weber95.low) &&
            warns(one.warnings, "few_participants"));
    RunEstimate edge = runOf(0.5, 0.01);
    edge.warnings.push_back({WarningKind::priorEdgeHigh});
    const GroupEstimate three =
        estimateGroup({runOf(-1.0, 0.1), edge, RunEstimate{}, runOf(-1.1, 0.1), runOf(-1.05, 0.0)}, 1);
    QVERIFY(three.participants == 3 && three.leftOut == 2 && warns(three.warnings, "left_out") &&
            three.members.size() == 5);
    QVERIFY(three.members[1].weight == 0.0 && three.weber > 0.07 && three.weber < 0.11);
    RunEstimate infinite = runOf(-1.0, 0.1);
    infinite.weber = infinite.weber95.high = HUGE_VAL;
    QVERIFY(estimateGroup({infinite, infinite}, 1).participants == 0);
    std::vector<RunEstimate> few;
    for (int i = 0; i < 5; ++i)
        few.push_back(runOf(-1.0 - 0.02 * i, 0.1));
    QVERIFY(warns(estimateGroup(few, 1).warnings, "few_participants"));
    few.push_back(runOf(-1.1, 0.1)); // six are enough
    QVERIFY(!warns(estimateGroup(few, 1).warnings, "few_participants"));
    const GroupEstimate same = estimateGroup({runOf(-1.0, 0.1), runOf(-1.0, 0.1), runOf(-1.0, 0.1)}, 1);
    QVERIFY(std::abs(same.bootstrap95.low - 0.1) < 1e-9 && same.sdBetweenLog10 == 0.0);
}

/// Subjects with moduli a thousandfold apart and exponents 0.7 and 0.9 on the same stimuli: exponent 0.8,
/// means on one line.
void TestGroupEstimate::modulusEqualised() {
    std::vector<MagnitudeAnswer> answers;
    for (int level = 0; level < 7; ++level)
        for (int subject = 0; subject < 4; ++subject) {
            const double stimulus = std::pow(2.0, level);
            answers.push_back({subject, stimulus,
                               std::pow(10.0, subject) * std::pow(stimulus, subject % 2 == 0 ? 0.7 : 0.9)});
        }
    const MagnitudeScale scale = magnitudeScale(answers);
    QVERIFY(std::abs(scale.exponent - 0.8) < 1e-12 && scale.exponentLow < 0.8 && scale.levels.size() == 7);
    QVERIFY(
        std::abs(std::log(scale.levels[6].geometricMean / scale.levels[0].geometricMean) / std::log(64.0) -
                 0.8) < 1e-9);
    QVERIFY(scale.levels[3].sdLog10 < 1e-9); // at the middle stimulus all agree once moduli are equal
    QVERIFY(std::isnan(magnitudeScale({}).exponent) &&
            std::isnan(magnitudeScale({{0, 1.0, 2.0}, {0, 1.0, 3.0}}).exponent));
    QVERIFY(std::isnan(magnitudeScale({{0, -1.0, 2.0}, {0, HUGE_VAL, 3.0}, {0, 1.0, 0.0}}).constant));
    const AdjustmentSummary settings = summariseSettings(10.0, {10.0, 11.0, 9.0, std::nan(""), -3.0});
    QVERIFY(settings.settings == 3 && settings.pseLow < 10.0 && settings.pseHigh > 10.0 &&
            settings.sdLow < settings.sdLog10);
    QVERIFY(settings.warnings.size() == 2 && settings.warnings[0].kind == WarningKind::leftOutSettings &&
            settings.warnings[1].kind == WarningKind::fewSettings);
    QVERIFY(summariseSettings(10.0, {10.0, 11.0, 9.0, 10.5, 9.5}).warnings.empty()); // none was left out
    QVERIFY(std::isnan(summariseSettings(0.0, {1.0}).pse) && std::isnan(summariseSettings(1.0, {}).pse));
}

/// Of one and of two the spread between people is hardly known; of three it is told.
void TestGroupEstimate::threeSubjectsAreEnough() {
    std::vector<MagnitudeAnswer> answers;
    for (int subject = 0; subject < 3; ++subject) {
        for (const double stimulus : {1.0, 2.0, 4.0})
            answers.push_back({subject, stimulus, std::pow(stimulus, 0.8 + 0.1 * subject)});
        const std::vector<Warning> warnings = magnitudeScale(answers).warnings;
        const auto few =
            std::find(warnings.begin(), warnings.end(), Warning{WarningKind::fewSubjects, subject + 1});
        QCOMPARE(few != warnings.end(), subject < 2);
        QCOMPARE(warnings.size(), subject < 2 ? 1U : 0U);
    }
}

void TestGroupEstimate::sealedAnswersAreNoAnswersWithoutAValue() {
    RunEstimate sealed;
    sealed.warnings.push_back({WarningKind::sealed});
    const GroupEstimate all = estimateGroup({sealed, sealed, sealed, sealed}, 1);
    QVERIFY(warns(all.warnings, "sealed"));
    QVERIFY(!warns(all.warnings, "left_out"));
    QCOMPARE(all.leftOut, 0);
    QCOMPARE(static_cast<int>(all.members.size()), 4);
    RunEstimate useless; // told, and of no value: another thing
    const GroupEstimate open = estimateGroup({useless, runOf(-0.9, 0.05), runOf(-0.8, 0.05)}, 1);
    QVERIFY(!warns(open.warnings, "sealed"));
    QVERIFY(warns(open.warnings, "left_out"));
    QCOMPARE(open.leftOut, 1);
}

QTEST_APPLESS_MAIN(TestGroupEstimate)
#include "test_group_estimate.moc"
