// SPDX-License-Identifier: GPL-3.0-or-later
// What a run says, from Thurstone observers of known σ written out here, and from data that carry nothing.
#include "psychophysics/study/run_estimate.h"

#include "psychophysics/measures/thurstone_posterior.h"
#include "tests/unit/psychophysics/measures/thurstone_runs.h"

#include <QElapsedTimer>
#include <QtTest>
#include <cmath>

using namespace chiron::psychophysics;
using namespace thurstone_runs;

namespace {

bool warns(const RunEstimate& estimate, const char* token) {
    for (const Warning& warning : estimate.warnings)
        if (warningText(warning).starts_with(std::string(token) + ": "))
            return true;
    return false;
}

} // namespace

class TestRunEstimate : public QObject {
    Q_OBJECT
private slots:
    void coverageAndBias_data();
    void coverageAndBias();
    void adaptivePlacement();
    void nothingToEstimateFrom();
    void degenerateRuns_data();
    void degenerateRuns();
    void oneLevelIsHeldExactly_data();
    void oneLevelIsHeldExactly();
    void settings();
    void magnitudes();
    void outcomeFromArrangementAndAnswer();
    void freeCurveBeside();
    void manyAnswersFit();
    void timeOfOne();
    void millionTrials();
};

void TestRunEstimate::coverageAndBias_data() {
    QTest::addColumn<int>("task");
    QTest::addColumn<int>("trials");
    QTest::newRow("rank3") << static_cast<int>(Task::rank3) << 60;
    QTest::newRow("rank3_ties") << static_cast<int>(Task::rank3Ties) << 60;
    QTest::newRow("2afc") << static_cast<int>(Task::twoAfc) << 120;
    QTest::newRow("3afc") << static_cast<int>(Task::threeAfc) << 100;
    QTest::newRow("oddity") << static_cast<int>(Task::oddity) << 100;
    QTest::newRow("same_different") << static_cast<int>(Task::sameDifferent) << 160;
    QTest::newRow("yes_no") << static_cast<int>(Task::yesNo) << 120;
}

void TestRunEstimate::coverageAndBias() {
    QFETCH(int, task);
    QFETCH(int, trials);
    const Coverage seen = coverageOf(static_cast<Task>(task), trials, 0.05, 0.02, 60);
    qInfo("%s: %d trials, 60 runs: covered %.3f, bias %+.4f log10, sd %.4f", QTest::currentDataTag(), trials,
          seen.covered, seen.bias, seen.sd);
    QVERIFY(seen.covered >= 0.87); // 52 of 60 is the 0.5 % point of 95 %
    QVERIFY(std::abs(seen.bias) < 0.02 + 3.0 * seen.sd / std::sqrt(60.0));
}

/// Trials placed by rank-3 QUEST+ itself, 60 seeds, true σ across its grid.
void TestRunEstimate::adaptivePlacement() {
    const Coverage seen = adaptiveCoverage(60, 40);
    qInfo("rank-3 QUEST+, 40 trials: covered %.3f, bias %+.4f log10, sd %.4f", seen.covered, seen.bias,
          seen.sd);
    QVERIFY(seen.covered >= 0.87 && std::abs(seen.bias) < 0.02 + 3.0 * seen.sd / std::sqrt(60.0));
}

void TestRunEstimate::nothingToEstimateFrom() {
    for (int task = 0; task < kTasks; ++task) {
        const RunEstimate none = estimateRun(conditionOf(static_cast<Task>(task)), {}, 1);
        QVERIFY(std::isnan(none.weber) && std::isnan(none.sigma95.low) && std::isnan(none.pse) &&
                none.trials == 0);
        QVERIFY(warns(none, "no_trials"));
    }
    Condition condition = conditionOf(Task::rank3);
    condition.stimulus.reference = std::nan("");
    QVERIFY(warns(estimateRun(condition, {}, 1), "reference"));
}

void TestRunEstimate::degenerateRuns_data() {
    QTest::addColumn<int>("task");
    QTest::addColumn<QString>("kind");
    QTest::addColumn<QString>("token");
    for (int task = 0; task < 6; ++task) {
        const QByteArray name(token(static_cast<Task>(task)).data());
        const bool saysYes =
            static_cast<Task>(task) == Task::sameDifferent || static_cast<Task>(task) == Task::yesNo;
        QTest::newRow((name + " right").constData())
            << task << "right" << (saysYes ? "step_function" : "all_right");
        QTest::newRow((name + " wrong").constData())
            << task << "wrong" << (saysYes ? "prior_edge" : "chance");
        QTest::newRow((name + " random").constData())
            << task << "random" << (saysYes ? "prior_edge" : "chance");
        QTest::newRow((name + " one level").constData()) << task << "one level"
                                                         << "one_level";
        QTest::newRow((name + " infinite").constData()) << task << "infinite"
                                                        << "left_out";
        QTest::newRow((name + " no answers").constData()) << task << "no answers"
                                                          << "left_out";
        QTest::newRow((name + " no difference").constData()) << task << "no difference"
                                                             << "no_difference";
        QTest::newRow((name + " few").constData()) << task << "few"
                                                   << "few_trials";
    }
}

void TestRunEstimate::degenerateRuns() {
    QFETCH(int, task);
    QFETCH(QString, kind);
    QFETCH(QString, token);
    const auto which = static_cast<Task>(task);
    const Condition condition = conditionOf(which);
    chiron::core::Random random(3);
    std::vector<ScoredTrial> trials;
    for (int i = 0; i < (kind == "few" ? 6 : 120); ++i) {
        const double sigma = kind == "random" ? 1e6 : 0.05;
        ScoredTrial trial = simulated(which, condition.stimulus.differences[static_cast<std::size_t>(i) % 8],
                                      sigma, 0.0, random);
        if (kind == "right" || kind == "wrong") {
            trial.answer = correctAnswer(which, trial.arrangement);
            if (kind == "wrong")
                trial.answer = (trial.answer + 1 + i % (answers(which) - 1)) % answers(which);
            trial.outcome = outcomeOf(which, trial.arrangement, trial.answer);
        }
        if (kind == "one level")
            trial.difference = 0.1;
        if (kind == "infinite" && i % 2 == 0)
            trial.difference = i % 4 == 0 ? HUGE_VAL : std::nan("");
        if (kind == "no answers" && i % 2 == 0)
            trial.outcome = trial.answer = 99; // nothing that could have been said
        if (kind == "no difference")
            trial.difference = 0.0;
        trials.push_back(trial);
    }
    const RunEstimate estimate = estimateRun(condition, trials, 1);
    for (const Warning& warning : estimate.warnings)
        qInfo("%s", warningText(warning).c_str());
    QVERIFY(warns(estimate, token.toUtf8().constData()));
    QVERIFY(kind != "no difference" || std::isnan(estimate.weber));
}

void TestRunEstimate::oneLevelIsHeldExactly_data() {
    QTest::addColumn<int>("task");
    QTest::addColumn<int>("of");
    for (const Task task : {Task::rank3, Task::twoAfc, Task::threeAfc, Task::oddity})
        for (const int of : {5, 10, 20})
            QTest::newRow((std::string(token(task)) + ' ' + std::to_string(of)).c_str())
                << static_cast<int>(task) << of;
}

/// Few answers at one difference have few outcomes: their chances are summed for every observer within the
/// prior, so that nothing is left to chance.
void TestRunEstimate::oneLevelIsHeldExactly() {
    QFETCH(int, task);
    QFETCH(int, of);
    const auto which = static_cast<Task>(task);
    const double difference = 0.1;
    std::vector<Interval> held; // by the number of right answers
    for (int right = 0; right <= of; ++right) {
        std::vector<ScoredTrial> trials;
        for (int i = 0; i < of; ++i) {
            ScoredTrial trial;
            trial.difference = difference;
            trial.arrangement = i % static_cast<int>(arrangements(which).size());
            trial.answer = correctAnswer(which, trial.arrangement);
            if (i >= right)
                trial.answer = (trial.answer + 1) % answers(which);
            trial.outcome = outcomeOf(which, trial.arrangement, trial.answer);
            trials.push_back(trial);
        }
        const RunEstimate estimate = estimateRun(conditionOf(which), trials, 1);
        QVERIFY(warns(estimate, "one_level"));
        QVERIFY(estimate.sigma95.low <= estimate.sigma_log10 &&
                estimate.sigma_log10 <= estimate.sigma95.high);
        held.push_back(estimate.sigma95);
    }
    const int kind = which == Task::rank3 ? 0 : 1;
    double least = 1.0, at = 0.0;
    for (double log10Sigma = -1.9; log10Sigma < -0.1; log10Sigma += 0.005) {
        const double p = answerProbability(which, difference, kind, {log10Sigma, 0.02, 0.0});
        double covered = 0.0;
        for (int right = 0; right <= of; ++right)
            if (const Interval& interval = held[static_cast<std::size_t>(right)];
                interval.low <= std::pow(10.0, log10Sigma) && std::pow(10.0, log10Sigma) <= interval.high)
                covered += std::exp(std::lgamma(of + 1.0) - std::lgamma(right + 1.0) -
                                    std::lgamma(of - right + 1.0) + right * std::log(p) +
                                    (of - right) * std::log1p(-p));
        if (covered < least)
            least = covered, at = log10Sigma;
    }
    QVERIFY2(least >= 0.95,
             qPrintable(QStringLiteral("%1 of observers of log10 sigma %2").arg(least).arg(at)));
}

void TestRunEstimate::settings() {
    chiron::core::Random random(5);
    int covered = 0;
    for (int run = 0; run < 60; ++run) {
        std::vector<ScoredTrial> trials(20);
        for (ScoredTrial& trial : trials)
            trial.value = 200.0 * std::pow(10.0, 0.03 + 0.05 * std::sqrt(2.0) * random.normal());
        const RunEstimate estimate = estimateRun(conditionOf(Task::adjustment), trials, 1);
        covered += estimate.sigma95.low < 0.05 && 0.05 < estimate.sigma95.high &&
                           estimate.pse95.low < 200.0 * std::pow(10.0, 0.03) &&
                           estimate.pse95.high > 200.0 * std::pow(10.0, 0.03)
                       ? 1
                       : 0;
    }
    QVERIFY(covered >= 48); // both at once: 0.9 of 60 expected
    std::vector<ScoredTrial> same(6);
    for (ScoredTrial& trial : same)
        trial.value = 210.0;
    const RunEstimate estimate = estimateRun(conditionOf(Task::adjustment), same, 1);
    QVERIFY(std::abs(estimate.pse - 210.0) < 1e-9 && std::isnan(estimate.weber) &&
            warns(estimate, "no_spread"));
}

void TestRunEstimate::magnitudes() {
    std::vector<ScoredTrial> trials;
    for (int i = 0; i < 16; ++i) {
        ScoredTrial trial;
        trial.difference = 0.1 * i;
        trial.value = 3.0 * std::pow(200.0 * std::pow(10.0, trial.difference), 0.8);
        trials.push_back(trial);
    }
    trials[3].value = -1.0;
    const RunEstimate estimate = estimateRun(conditionOf(Task::magnitude), trials, 1);
    QVERIFY(std::abs(estimate.exponent - 0.8) < 1e-9 && std::abs(estimate.exponent95.low - 0.8) < 1e-6);
    QVERIFY(std::isnan(estimate.weber) && estimate.trials == 15 && warns(estimate, "left_out"));
}

/// Trials that hold only what was shown and said give the same as trials that hold the outcome.
void TestRunEstimate::outcomeFromArrangementAndAnswer() {
    for (int task = 0; task < 6; ++task) {
        chiron::core::Random random(11);
        const Condition condition = conditionOf(static_cast<Task>(task));
        std::vector<ScoredTrial> whole = runOf(condition, 50, 0.05, 0.02, random);
        std::vector<ScoredTrial> bare = whole;
        for (ScoredTrial& trial : bare)
            trial.outcome = -1;
        std::vector<ScoredTrial> outcomes = whole;
        for (ScoredTrial& trial : outcomes)
            trial.answer = -1;
        QCOMPARE(estimateRun(condition, outcomes, 1).sigma_log10,
                 estimateRun(condition, whole, 1).sigma_log10);
        QCOMPARE(estimateRun(condition, bare, 1).sigma_log10, estimateRun(condition, whole, 1).sigma_log10);
    }
}

/// Levels with 60 trials each: the free curve's threshold lies by the Thurstone observer's; answers that fall
/// with the difference do not fit.
void TestRunEstimate::freeCurveBeside() {
    for (const Task task :
         {Task::twoAfc, Task::threeAfc, Task::oddity, Task::rank3, Task::yesNo, Task::sameDifferent}) {
        chiron::core::Random random(21);
        const Condition condition = conditionOf(task);
        const RunEstimate estimate = estimateRun(condition, runOf(condition, 480, 0.05, 0.02, random), 1);
        qInfo("%s: threshold %.4f (%.4f..%.4f), free curve %.4f (%.4f..%.4f), deviance %.1f, p %.2f",
              token(task).data(), estimate.threshold, estimate.threshold95.low, estimate.threshold95.high,
              estimate.fitThreshold, estimate.fitThreshold95.low, estimate.fitThreshold95.high,
              estimate.deviance, estimate.pValue);
        QVERIFY(estimate.threshold95.low < estimate.threshold &&
                estimate.threshold < estimate.threshold95.high);
        QVERIFY(std::abs(std::log10(estimate.fitThreshold / estimate.threshold)) < 0.15 &&
                estimate.pValue > 0.001);
    }
    Condition condition = conditionOf(Task::twoAfc);
    std::vector<ScoredTrial> upside;
    for (int i = 0; i < 480; ++i) {
        ScoredTrial trial;
        trial.difference = condition.stimulus.differences[static_cast<std::size_t>(i) % 8];
        trial.outcome = i % 8 == 2 ? 0 : 1;
        upside.push_back(trial);
    }
    QVERIFY(warns(estimateRun(condition, upside, 1), "poor_fit"));
}

/// The observer's own curve describes its own answers, however many; one that pays attention to half of the
/// trials only is noticed.
void TestRunEstimate::manyAnswersFit() {
    for (const Task task :
         {Task::twoAfc, Task::threeAfc, Task::oddity, Task::rank3, Task::yesNo, Task::sameDifferent}) {
        const Condition condition = conditionOf(task);
        int poor = 0;
        for (std::uint64_t seed = 1; seed <= 10; ++seed) {
            chiron::core::Random random(seed);
            poor += warns(estimateRun(condition, runOf(condition, 10000, 0.05, 0.02, random), 1), "poor_fit")
                        ? 1
                        : 0;
        }
        QVERIFY2(poor <= 1, qPrintable(QStringLiteral("%1: %2 of 10").arg(token(task).data()).arg(poor)));
        chiron::core::Random random(3);
        std::vector<ScoredTrial> mixed = runOf(condition, 2000, 0.005, 0.0, random);
        const std::vector<ScoredTrial> blunt = runOf(condition, 2000, 0.4, 0.0, random);
        mixed.insert(mixed.end(), blunt.begin(), blunt.end());
        QVERIFY2(warns(estimateRun(condition, mixed, 1), "poor_fit"), token(task).data());
    }
}

/// Reported only: planning runs thousands.
void TestRunEstimate::timeOfOne() {
    for (const Task task : {Task::rank3, Task::twoAfc, Task::yesNo}) {
        chiron::core::Random random(23);
        const Condition condition = conditionOf(task);
        const std::vector<ScoredTrial> trials = runOf(condition, 60, 0.05, 0.02, random);
        QElapsedTimer timer;
        timer.start();
        for (int i = 0; i < 10; ++i)
            QVERIFY(estimateRun(condition, trials, 1).trials == 60);
        qInfo("%s: %.2f ms", token(task).data(), static_cast<double>(timer.nsecsElapsed()) / 1e7);
    }
}

void TestRunEstimate::millionTrials() {
    chiron::core::Random random(17);
    const Condition condition = conditionOf(Task::rank3);
    std::vector<ScoredTrial> trials = runOf(condition, 1000, 0.05, 0.02, random);
    trials.reserve(1000000);
    while (trials.size() < 1000000)
        trials.push_back(trials[trials.size() - 1000]);
    const RunEstimate estimate = estimateRun(condition, trials, 1);
    QCOMPARE(estimate.trials, 1000000);
    QVERIFY(estimate.sigma95.high / estimate.sigma95.low < 1.02 &&
            std::abs(std::log10(estimate.sigma_log10 / 0.05)) < 0.1);
    for (std::size_t i = 0; i < trials.size(); ++i)
        trials[i].difference += 1e-9 * static_cast<double>(i);
    QVERIFY(warns(estimateRun(condition, trials, 1), "binned"));
}

QTEST_APPLESS_MAIN(TestRunEstimate)
#include "test_run_estimate.moc"
