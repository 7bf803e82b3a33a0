// SPDX-License-Identifier: GPL-3.0-or-later
#include "psychophysics/measures/run_warnings.h"

#include "psychophysics/measures/scored_answers.h"
#include "psychophysics/study/arrangement.h"
#include "tests/unit/psychophysics/measures/thurstone_runs.h"

#include <QtTest>
#include <algorithm>
#include <initializer_list>
#include <utility>
#include <vector>

using namespace chiron;
using namespace chiron::psychophysics;

namespace {

/// `right` right answers of each arrangement, then `wrong` wrong ones; what is said when wrong comes from
/// `says`.
std::vector<ScoredTrial> trialsOf(Task task, int right, int wrong,
                                  const std::function<int(int arrangement, int correct, int nth)>& says) {
    std::vector<ScoredTrial> trials;
    const int kinds = static_cast<int>(arrangements(task).size());
    for (int i = 0; i < right * kinds; ++i) {
        ScoredTrial trial;
        trial.arrangement = i % kinds;
        trial.answer = correctAnswer(task, trial.arrangement);
        trials.push_back(trial);
    }
    for (int i = 0, made = 0; made < wrong; ++i) {
        ScoredTrial trial;
        trial.arrangement = i % kinds;
        const int correct = correctAnswer(task, trial.arrangement);
        trial.answer = says(trial.arrangement, correct, made);
        if (trial.answer == correct)
            continue;
        trials.push_back(trial);
        ++made;
    }
    return trials;
}

bool warns(Task task, const std::vector<ScoredTrial>& trials) {
    std::vector<Warning> warnings;
    warnOfPlaces(warnings, task, trials);
    return std::any_of(warnings.begin(), warnings.end(),
                       [](const Warning& w) { return w.kind == WarningKind::positionBias; });
}

/// A run of 100 trials at two differences, 80 right: nothing to say of it.
ScoredAnswers ordinary() {
    ScoredAnswers answers;
    answers.points = {{0.05, 30, 50}, {0.1, 50, 50}};
    answers.used = 100;
    answers.right = 80;
    answers.levels = 2;
    return answers;
}

ThurstonePosterior quiet() {
    ThurstonePosterior posterior;
    posterior.known = true;
    posterior.meanLapse = 0.02;
    return posterior;
}

/// `right` of `used` answers, all at one difference.
ScoredAnswers atOneDifference(int right, int used) {
    ScoredAnswers answers = ordinary(); // two levels, so that nothing is said of their number
    answers.points = {{0.1, right, used}};
    answers.used = used;
    answers.right = right;
    return answers;
}

/// The only kinds of warning, in order.
bool saysOnly(Task task, const ScoredAnswers& answers, const ThurstonePosterior& posterior,
              const std::vector<WarningKind>& kinds) {
    std::vector<Warning> warnings;
    warnOfAnswers(warnings, task, answers, posterior);
    std::string all;
    for (const Warning& warning : warnings)
        all += warningText(warning) + '\n';
    qInfo("%s", all.c_str());
    return std::equal(warnings.begin(), warnings.end(), kinds.begin(), kinds.end(),
                      [](const Warning& w, WarningKind kind) { return w.kind == kind; });
}

} // namespace

/// What a reader of an estimate is told of the places of wrong answers.
class TestRunWarnings : public QObject {
    Q_OBJECT
private slots:
    void sizeOfARun() {
        using enum WarningKind;
        ScoredAnswers answers = ordinary();
        QVERIFY(saysOnly(Task::twoAfc, answers, quiet(), {}));
        answers.leftOut = 3;
        answers.binned = true;
        std::vector<Warning> warnings;
        warnOfAnswers(warnings, Task::twoAfc, answers, quiet());
        QCOMPARE(warnings.size(), 2U);
        QVERIFY((warnings[0] == Warning{leftOutTrials, 3}) && warnings[1].kind == binned);
        answers = ordinary();
        answers.used = 20;
        answers.right = 16;
        QVERIFY(saysOnly(Task::twoAfc, answers, quiet(), {}));
        answers.used = 19;
        QVERIFY(saysOnly(Task::twoAfc, answers, quiet(), {fewTrials}));
        warnings.clear();
        warnOfAnswers(warnings, Task::twoAfc, answers, quiet());
        QCOMPARE(warnings.front().count, 19);
        answers = ordinary();
        answers.levels = 1;
        QVERIFY(saysOnly(Task::twoAfc, answers, quiet(), {oneLevel}));
        answers.levels = 0;
        QVERIFY(saysOnly(Task::twoAfc, answers, quiet(), {noDifference}));
        answers.used = answers.right = 0; // nothing more is said of nothing
        answers.leftOut = 7;
        QVERIFY(saysOnly(Task::twoAfc, answers, quiet(), {leftOutTrials, noTrials}));
    }
    /// 256 differences are told one by one; one more, and neighbours are put together.
    void manyDifferences() {
        std::vector<ScoredTrial> trials;
        for (int i = 1; i <= 256; ++i) {
            ScoredTrial trial;
            trial.answer = correctAnswer(Task::twoAfc, trial.arrangement);
            trial.difference = 0.001 * i;
            trials.push_back(trial);
        }
        const ScoredAnswers each = sortAnswers(Task::twoAfc, trials);
        QVERIFY(!each.binned && each.levels == 256 && each.points.size() == 256U);
        trials.push_back(trials.back());
        trials.back().difference = 0.5;
        const ScoredAnswers pairs = sortAnswers(Task::twoAfc, trials);
        QVERIFY(pairs.binned && pairs.used == 257 && pairs.levels == 129 && pairs.largestDifference == 0.5);
        QVERIFY(std::abs(pairs.smallestDifference - 0.0015) < 1e-12); // the mean of the first two
    }
    /// Right answers of 20 from which on guessing is refuted (P of as many or more below 0.05, summed by
    /// hand: 0.0207, 0.0376, 0.0371; one fewer 0.0577, 0.0919, 0.1018).
    void guessing_data() {
        QTest::addColumn<int>("task");
        QTest::addColumn<int>("enough");
        QTest::newRow("2afc") << static_cast<int>(Task::twoAfc) << 15;
        QTest::newRow("3afc") << static_cast<int>(Task::threeAfc) << 11;
        QTest::newRow("oddity") << static_cast<int>(Task::oddity) << 11;
        QTest::newRow("rank3") << static_cast<int>(Task::rank3) << 7;
        QTest::newRow("rank3_ties") << static_cast<int>(Task::rank3Ties) << 7;
    }
    void guessing() {
        using enum WarningKind;
        QFETCH(int, task);
        QFETCH(int, enough);
        const auto of = static_cast<Task>(task);
        QVERIFY(saysOnly(of, atOneDifference(enough, 20), quiet(), {}));
        // Guessing is not refuted, and neither is its opposite.
        QVERIFY(saysOnly(of, atOneDifference(enough - 1, 20), quiet(),
                         {of == Task::rank3 || of == Task::rank3Ties ? chance : tooFewToTell}));
        QVERIFY(saysOnly(of, atOneDifference(19, 20), quiet(), {}));
        QVERIFY(saysOnly(of, atOneDifference(20, 20), quiet(), {allRight}));
    }
    /// Whoever perceives only the largest difference guesses at all others, and is no guesser. With seven
    /// levels, 10 of 10 at the largest have p = 7/1024 = 0.007, 8 of 10 have 7 · 0.055 = 0.38. Differences of
    /// both signs are of one size.
    void theLargestDifferenceRefutesGuessing() {
        using enum WarningKind;
        const auto sevenLevels = [](int rightAtTheTop, double sign) {
            ScoredAnswers answers = ordinary();
            answers.points.clear();
            for (int i = 0; i < 6; ++i)
                answers.points.push_back({(i % 2 == 0 ? sign : 1.0) * 0.02 * (i + 1), 5, 10});
            answers.points.push_back({sign * 0.3, rightAtTheTop, 10});
            answers.used = 70;
            answers.right = 30 + rightAtTheTop;
            answers.levels = 7;
            return answers;
        };
        for (const double sign : {1.0, -1.0}) {
            QVERIFY(saysOnly(Task::twoAfc, sevenLevels(10, sign), quiet(), {stepFunction}));
            QVERIFY(saysOnly(Task::twoAfc, sevenLevels(8, sign), quiet(), {chance}));
        }
    }
    /// Five of six right are no sign of guessing: by guessing, p is 0.11; whoever is right in 75 % of the
    /// trials has five of six or fewer in 82 % of the cases. Two of six refute the latter (0.038), three do
    /// not (0.169). The values are summed by hand.
    void fewAnswersTellNothingOfGuessing() {
        using enum WarningKind;
        for (const auto& [right, kinds] :
             std::initializer_list<std::pair<int, std::vector<WarningKind>>>{{2, {fewTrials, chance}},
                                                                             {3, {fewTrials, tooFewToTell}},
                                                                             {5, {fewTrials, tooFewToTell}},
                                                                             {6, {fewTrials, allRight}}}) {
            QVERIFY2(saysOnly(Task::twoAfc, atOneDifference(right, 6), quiet(), kinds),
                     qPrintable(QString::number(right)));
        }
        // One in four guessers has both right.
        QVERIFY(saysOnly(Task::twoAfc, atOneDifference(2, 2), quiet(), {fewTrials, allRight, tooFewToTell}));
        ScoredAnswers answers = ordinary();
        answers.used = 6; // the one at the smallest difference is wrong: no jump is seen in so few
        answers.right = 5;
        answers.points = {{0.02, 0, 1}, {0.05, 5, 5}};
        QVERIFY(saysOnly(Task::twoAfc, answers, quiet(), {fewTrials, tooFewToTell}));
    }
    /// Of no run two things are said of which one denies the other.
    void noTwoWarningsContradict() {
        using enum WarningKind;
        const std::vector<std::pair<WarningKind, WarningKind>> contradictions{
            {chance, stepFunction},      {tooFewToTell, stepFunction}, {chance, tooFewToTell},
            {chance, allRight},          {allRight, stepFunction},     {oneAnswer, stepFunction},
            {noRise, stepFunction},      {noRise, allRight},           {noRise, tooFewToTell},
            {notMonotone, stepFunction}, {notMonotone, allRight}};
        int guessed = 0, untold = 0, jumps = 0;
        for (const Task task : {Task::twoAfc, Task::threeAfc, Task::oddity, Task::rank3})
            for (const double sigma : {0.005, 0.03, 0.05, 0.5})
                for (const int trials : {2, 4, 6, 12, 40})
                    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
                        core::Random random(seed);
                        const Condition condition = thurstone_runs::conditionOf(task);
                        std::vector<ScoredTrial> run;
                        for (int i = 0; i < trials; ++i) // few levels, so that steps occur
                            run.push_back(thurstone_runs::simulated(
                                task, condition.stimulus.differences[static_cast<std::size_t>(i % 2) * 5],
                                sigma, 0.02, random));
                        const std::vector<Warning> warnings = estimateRun(condition, run, seed).warnings;
                        for (const auto& [one, other] : contradictions)
                            QVERIFY2(!hasWarning(warnings, one) || !hasWarning(warnings, other),
                                     (warningText({one}) + " / " + warningText({other})).c_str());
                        guessed += hasWarning(warnings, chance) ? 1 : 0;
                        untold += hasWarning(warnings, tooFewToTell) ? 1 : 0;
                        jumps += hasWarning(warnings, stepFunction) ? 1 : 0;
                    }
        QVERIFY(guessed > 0 && untold > 0 && jumps > 0); // else nothing was shown
    }
    /// Whoever says yes (different) always or never tells nothing of differences; the number of right answers
    /// does not matter there.
    void oneAnswerOnly() {
        using enum WarningKind;
        for (const Task task : {Task::yesNo, Task::sameDifferent}) {
            ScoredAnswers answers = ordinary();
            answers.right = 50;
            answers.points = {{0.0, 0, 50}, {0.05, 0, 25}, {0.1, 0, 25}};
            QVERIFY(saysOnly(task, answers, quiet(), {oneAnswer}));
            answers.points.back().right = 1;
            QVERIFY(saysOnly(task, answers, quiet(), {}));
            answers.points = {{0.0, 50, 50}, {0.05, 25, 25}, {0.1, 25, 25}};
            QVERIFY(saysOnly(task, answers, quiet(), {oneAnswer}));
            answers.points.front().right = 49;
            QVERIFY(saysOnly(task, answers, quiet(), {}));
        }
    }
    /// From never better than chance to always right.
    void steps() {
        using enum WarningKind;
        ScoredAnswers answers = ordinary();
        answers.points = {{0.02, 20, 40}, {0.05, 10, 20}, {0.1, 40, 40}}; // exactly at chance, then all
        answers.right = 70;
        QVERIFY(saysOnly(Task::twoAfc, answers, quiet(), {stepFunction}));
        answers.points[1].right = 11; // better than chance, and not all
        QVERIFY(saysOnly(Task::twoAfc, answers, quiet(), {}));
        answers.points[1].right = 20;
        QVERIFY(saysOnly(Task::twoAfc, answers, quiet(), {stepFunction}));
        answers.points[2].right = 39;
        QVERIFY(saysOnly(Task::twoAfc, answers, quiet(), {}));
        answers.points = {{0.05, 60, 60}, {0.1, 40, 40}}; // never at chance: no step is seen
        QVERIFY(saysOnly(Task::twoAfc, answers, quiet(), {}));
        answers.points = {{0.05, 30, 60}, {0.1, 20, 40}}; // never above
        QVERIFY(saysOnly(Task::twoAfc, answers, quiet(), {}));
        answers.points = {{0.05, 10, 30}, {0.1, 70, 70}}; // a third is chance of three
        QVERIFY(saysOnly(Task::threeAfc, answers, quiet(), {stepFunction}));
        QVERIFY(saysOnly(Task::oddity, answers, quiet(), {stepFunction}));
        QVERIFY(saysOnly(Task::rank3, answers, quiet(), {}));
        answers.points[0].right = 5; // a sixth
        QVERIFY(saysOnly(Task::rank3, answers, quiet(), {stepFunction}));
        QVERIFY(saysOnly(Task::rank3Ties, answers, quiet(), {stepFunction}));
        answers.points = {{0.0, 0, 30}, {0.1, 70, 70}}; // of who says yes: never, then always
        QVERIFY(saysOnly(Task::yesNo, answers, quiet(), {stepFunction}));
        answers.points[0].right = 1;
        QVERIFY(saysOnly(Task::yesNo, answers, quiet(), {}));
    }
    /// 0.147 is exp(-3.841/2): the end lies within the 95 % region of the likelihood.
    void endsOfThePrior() {
        using enum WarningKind;
        const auto says = [](double low, double high, const std::vector<WarningKind>& kinds) {
            ThurstonePosterior posterior = quiet();
            posterior.densityAtLowSigma = low;
            posterior.densityAtHighSigma = high;
            return saysOnly(Task::twoAfc, ordinary(), posterior, kinds);
        };
        QVERIFY(says(0.0199, 0.0199, {}));
        QVERIFY(says(0.02, 0.01, {priorBoundLow}) && says(0.01, 0.02, {priorBoundHigh}));
        QVERIFY(says(0.146, 0.01, {priorBoundLow}) && says(0.01, 0.146, {priorBoundHigh}));
        QVERIFY(says(0.147, 0.01, {priorEdgeLow}) && says(0.01, 0.147, {priorEdgeHigh}));
        // Each end by itself: one that is cut off does not hide the other.
        QVERIFY(says(0.9, 1.0, {priorEdgeLow, priorEdgeHigh}) &&
                says(1.0, 0.9, {priorEdgeLow, priorEdgeHigh}));
        QVERIFY(says(0.02, 0.02, {priorBoundLow, priorBoundHigh}));
        QVERIFY(says(0.147, 0.02, {priorEdgeLow, priorBoundHigh}));
        QVERIFY(says(0.02, 0.147, {priorBoundLow, priorEdgeHigh}));
        ThurstonePosterior posterior = quiet();
        posterior.known = false;
        posterior.densityAtHighSigma = 1.0;
        QVERIFY(saysOnly(Task::twoAfc, ordinary(), posterior, {}));
    }
    void manyLapses() {
        using enum WarningKind;
        ThurstonePosterior posterior = quiet();
        posterior.meanLapse = 0.1;
        QVERIFY(saysOnly(Task::twoAfc, ordinary(), posterior, {}));
        posterior.meanLapse = 0.1001;
        QVERIFY(saysOnly(Task::twoAfc, ordinary(), posterior, {lapses}));
    }
    void biasForAPlaceIsTold_data() {
        QTest::addColumn<int>("task");
        QTest::addColumn<int>("enough"); // wrong answers, all of them on one place, until p < 0.001
        QTest::newRow("2afc") << static_cast<int>(Task::twoAfc) << 17;
        QTest::newRow("3afc") << static_cast<int>(Task::threeAfc) << 14;
        QTest::newRow("oddity") << static_cast<int>(Task::oddity) << 14;
    }
    void biasForAPlaceIsTold() {
        QFETCH(int, task);
        QFETCH(int, enough);
        const auto of = static_cast<Task>(task);
        const int places = placesOf(of);
        for (int place = 0; place < places; ++place) {
            const auto here = [place](int, int, int) { return place; };
            QVERIFY(warns(of, trialsOf(of, 30, enough, here)));
            QVERIFY(!warns(of, trialsOf(of, 30, enough - 1, here)));
        }
        // As many on each place, as chance has it.
        QVERIFY(!warns(of, trialsOf(of, 30, 60, [places](int, int correct, int nth) {
                           return (correct + 1 + nth % (places - 1)) % places;
                       })));
    }
    /// Two places, of which one was shown as the wrong one more seldom: ten wrong answers are the least that
    /// is judged.
    void tenAreTheLeast() {
        for (const int wrong : {9, 10}) {
            std::vector<ScoredTrial> trials;
            for (int i = 0; i < 40; ++i) {
                const bool missed = i < wrong;
                ScoredTrial trial;
                trial.arrangement = 0;
                for (const int arrangement : {0, 1})
                    if (correctAnswer(Task::twoAfc, arrangement) == (missed ? 1 : 0))
                        trial.arrangement = arrangement;
                trial.answer = 0; // always the same
                trials.push_back(trial);
            }
            QCOMPARE(warns(Task::twoAfc, trials), wrong == 10);
        }
    }
    void otherTasksHaveNoPlaces() {
        std::vector<ScoredTrial> trials(60);
        for (ScoredTrial& trial : trials)
            trial.answer = 0;
        for (int task = 0; task < kTasks; ++task) {
            const auto of = static_cast<Task>(task);
            if (of != Task::twoAfc && of != Task::threeAfc && of != Task::oddity)
                QVERIFY(!warns(of, trials));
        }
    }
    /// What is no answer of the task counts for nothing.
    void nonsenseIsLeftOut() {
        std::vector<ScoredTrial> trials = trialsOf(Task::threeAfc, 30, 12, [](int, int, int) { return 0; });
        for (const auto& [arrangement, answer] : {std::pair{-1, 0},
                                                  {static_cast<int>(arrangements(Task::threeAfc).size()), 0},
                                                  {0, -1},
                                                  {0, 3}}) {
            ScoredTrial trial;
            trial.arrangement = arrangement;
            trial.answer = answer;
            trials.insert(trials.end(), 20, trial);
        }
        QVERIFY(!warns(Task::threeAfc, trials));
    }
};

QTEST_GUILESS_MAIN(TestRunWarnings)
#include "test_run_warnings.moc"
