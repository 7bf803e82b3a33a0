// SPDX-License-Identifier: GPL-3.0-or-later
#include "psychophysics/measures/run_warnings.h"

#include "psychophysics/study/arrangement.h"

#include <QtTest>

using namespace chiron;
using namespace chiron::psychophysics;

namespace {

/// `right` right answers of each arrangement, then `wrong` wrong ones; what is said when wrong comes from `says`.
std::vector<ScoredTrial> trialsOf(Task task, int right, int wrong, const std::function<int(int arrangement, int correct, int nth)>& says) {
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
    return std::any_of(warnings.begin(), warnings.end(), [](const Warning& w) { return w.kind == WarningKind::positionBias; });
}

} // namespace

/// What a reader of an estimate is told of the places of wrong answers.
class TestRunWarnings : public QObject {
    Q_OBJECT
private slots:
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
        QVERIFY(!warns(of, trialsOf(of, 30, 60, [places](int, int correct, int nth) { return (correct + 1 + nth % (places - 1)) % places; })));
    }
    /// Two places, of which one was shown as the wrong one more seldom: ten wrong answers are the least that is judged.
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
        for (const auto& [arrangement, answer] : {std::pair{-1, 0}, {static_cast<int>(arrangements(Task::threeAfc).size()), 0}, {0, -1}, {0, 3}}) {
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
