// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/random.h"
#include "psychophysics/observers/simulated_observer.h"
#include "session/study/study_progress.h"
#include "support/study_designs.h"

#include <QtTest>

#include <algorithm>
#include <clocale>
#include <cmath>
#include <map>

using namespace chiron;

namespace {

/// A run by an observer who is told the values; `spoilEvery` > 0: so many presentations apart one is spoiled.
std::vector<database::StudyTrial> run(session::StudyProgress& progress,
                                      const psychophysics::Condition& condition, std::uint64_t seed, int most,
                                      int spoilEvery = 0) {
    psychophysics::SimulatedObserver observer({.weber = 0.12, .lapse = 0.02}, seed);
    std::vector<database::StudyTrial> trials;
    while (!progress.done() && static_cast<int>(trials.size()) < most) {
        const session::StudyPresentation shown = progress.next();
        std::vector<double> felt;
        for (const double value : shown.values)
            felt.push_back(std::log10(value / condition.stimulus.reference));
        session::StudyAnswer answer;
        answer.answer = observer.answer(condition.task, felt);
        if (spoilEvery > 0 && shown.ordinal % spoilEvery == spoilEvery - 1)
            answer.spoiled = "experimenter";
        auto trial = progress.record(answer);
        if (!trial)
            break;
        trials.push_back(*trial);
    }
    return trials;
}

psychophysics::StudyDesign designOf(const QByteArray& kind) {
    psychophysics::StudyDesign design = testing::rank3Study(psychophysics::Attribute::stiffness, 40, 20, 0.0);
    design.trial.practiceTrials = 2;
    psychophysics::Condition& condition = design.conditions.front();
    if (kind == "rank3")
        return design;
    if (kind == "rank3_ties") {
        condition.task = psychophysics::Task::rank3Ties;
        std::get<psychophysics::Rank3Spec>(condition.procedures.front()).allowTies = true;
        return design;
    }
    condition.task = psychophysics::Task::twoAfc;
    condition.scale = psychophysics::ProcedureScale::logDifference;
    psychophysics::StaircaseSpec stairs;
    stairs.start = -0.6;
    stairs.minimum = -2.0;
    stairs.maximum = -0.5;
    stairs.stop = {.trials = 40};
    psychophysics::QuestPlusSpec quest;
    quest.stimuli = {{"x", testing::spaced(-2.0, -0.5, 31)}};
    quest.parameters = {{"threshold", testing::spaced(-2.0, -0.5, 31), {}},
                        {"slope", {2.0, 3.5, 5.0}, {}},
                        {"lower_asymptote", {0.5}, {}},
                        {"lapse_rate", {0.02}, {}}};
    quest.stop = {.trials = 40};
    if (kind == "staircase")
        condition.procedures = {stairs};
    else if (kind == "quest_plus")
        condition.procedures = {quest};
    else
        condition.procedures = {stairs, quest};
    return design;
}

} // namespace

class TestStudyProgress : public QObject {
    Q_OBJECT
private slots:
    void rerunReproducesEveryChoice_data() {
        QTest::addColumn<QByteArray>("kind");
        for (const char* kind : {"rank3", "rank3_ties", "quest_plus", "staircase", "interleaved"})
            QTest::newRow(kind) << QByteArray(kind);
    }
    void rerunReproducesEveryChoice() {
        QFETCH(QByteArray, kind);
        const auto design = designOf(kind);
        auto progress = session::StudyProgress::begin(design, "main", 11);
        QVERIFY2(progress, progress ? "" : progress.error().message.c_str());
        const auto trials = run(*progress, design.conditions.front(), 3, 200, 7);
        QVERIFY(trials.size() > 20);
        database::StudyRun stored;
        stored.condition = "main";
        stored.seed = 11;
        stored.procedures = progress->procedureIds();
        const auto replayed = session::rerunChoices(design, stored, trials);
        QVERIFY(replayed);
        QCOMPARE(replayed->trials, static_cast<int>(trials.size()));
        QCOMPARE(replayed->same, replayed->trials);
        QCOMPARE(replayed->firstDifference, -1);
        QVERIFY(replayed->sameProcedures && replayed->identical());
        stored.procedures += "0"; // by another version, which chooses the same
        const auto other = session::rerunChoices(design, stored, trials);
        QVERIFY(other && other->same == other->trials && !other->sameProcedures && !other->identical());
        stored.procedures = progress->procedureIds();
        // A log that says otherwise is found; a margin of nothing excuses another candidate, not another
        // order of places.
        auto changed = trials;
        changed.back().arrangement = (changed.back().arrangement + 1) % 2;
        changed.back().entropyMargin = 0.0;
        const auto found = session::rerunChoices(design, stored, changed);
        QVERIFY(found);
        QCOMPARE(found->firstDifference, changed.back().ordinal);
        QVERIFY(!found->identical() && found->same == found->trials - 1);
    }
    /// What differs by nothing is a tie, and no difference.
    void tiesAreNoDifferences() {
        session::ReplayedChoices replayed;
        replayed.trials = 5;
        replayed.same = 4;
        QVERIFY(!replayed.identical());
        replayed.ties = 1;
        QVERIFY(replayed.identical());
        replayed.sameProcedures = false;
        QVERIFY(!replayed.identical());
    }
    /// Answers that the task has, and no others.
    void answersOfAnotherTaskAreRefused() {
        const auto design = designOf("rank3");
        auto progress = session::StudyProgress::begin(design, "main", 1);
        QVERIFY(progress);
        session::StudyAnswer given;
        given.answer = psychophysics::answers(psychophysics::Task::rank3);
        const auto refused = progress->record(given);
        QVERIFY(!refused && refused.error().code == core::ErrorCode::badInput);
        given.answer -= 1;
        QVERIFY(progress->record(given));
    }
    /// A run that stops after any trial and is resumed goes on as it would have.
    void resumedRunGoesOnAlike() {
        const auto design = designOf("interleaved");
        auto whole = session::StudyProgress::begin(design, "main", 5);
        QVERIFY(whole);
        const auto trials = run(*whole, design.conditions.front(), 9, 60, 9);
        for (std::size_t stop = 1; stop < trials.size(); stop += 7) {
            const std::vector<database::StudyTrial> before(
                trials.begin(), trials.begin() + static_cast<std::ptrdiff_t>(stop));
            auto resumed = session::StudyProgress::resume(design, "main", 5, before);
            QVERIFY(resumed);
            const auto next = resumed->next();
            QCOMPARE(next.candidate, trials[stop].candidate);
            QCOMPARE(next.arrangement, trials[stop].arrangement);
            QCOMPARE(next.procedure, trials[stop].procedure);
            QCOMPARE(next.ordinal, trials[stop].ordinal);
        }
    }
    /// A task and a procedure count the same outcomes, or the run is refused.
    void tiesNeedBothTaskAndProcedure() {
        for (const char* kind : {"rank3", "rank3_ties"}) {
            auto design = designOf(kind);
            auto& condition = design.conditions.front();
            QVERIFY(session::StudyProgress::begin(design, "main", 1));
            condition.task = condition.task == psychophysics::Task::rank3 ? psychophysics::Task::rank3Ties
                                                                          : psychophysics::Task::rank3;
            const auto refused = session::StudyProgress::begin(design, "main", 1);
            QVERIFY(!refused && refused.error().message.find("outcomes") != std::string::npos);
        }
    }
    void practiceIsNeverScoredAndSpoiledComesAgain() {
        const auto design = designOf("rank3");
        auto progress = session::StudyProgress::begin(design, "main", 2);
        QVERIFY(progress);
        const auto trials = run(*progress, design.conditions.front(), 3, 30, 5);
        QVERIFY(trials[0].practice && trials[1].practice && !trials[2].practice);
        QCOMPARE(trials[0].outcome, -1);
        QCOMPARE(trials[0].candidate, 29);
        QCOMPARE(QString::fromStdString(trials[4].spoiled), QStringLiteral("experimenter"));
        QCOMPARE(trials[4].outcome, -1);
        QCOMPARE(trials[5].candidate, trials[4].candidate); // an adaptive procedure asks for the same again
    }
    /// Practice that ended without an answer is no practice: it comes again, until somebody is asked. A log
    /// in which it counted, as earlier versions counted it, goes on as it was.
    void practiceWithoutAnAnswerComesAgain() {
        const auto design = designOf("rank3");
        auto progress = session::StudyProgress::begin(design, "main", 2);
        QVERIFY(progress);
        std::vector<database::StudyTrial> log;
        const auto answer = [&](session::StudyProgress& of, int given) {
            session::StudyAnswer said;
            said.answer = given;
            log.push_back(*of.record(said));
        };
        for (const int given : {-1, 0, -1, -1, 0})
            answer(*progress, given);
        for (std::size_t i = 0; i < log.size(); ++i)
            QVERIFY(log[i].practice && log[i].ordinal == static_cast<int>(i));
        QVERIFY(!progress->next().practice);
        QCOMPARE(progress->spoiledTrials(), 0); // nor is it a trial that was spoiled
        answer(*progress, 0);
        database::StudyRun stored;
        stored.condition = "main";
        stored.seed = 2;
        stored.procedures = progress->procedureIds();
        auto again = session::rerunChoices(design, stored, log);
        QVERIFY(again && again->same + again->ties == 6);
        // Two that timed out were all the practice of an older run.
        std::vector<database::StudyTrial> old{log[0], log[2], log[5]};
        for (std::size_t i = 0; i < old.size(); ++i)
            old[i].ordinal = static_cast<int>(i);
        auto resumed = session::StudyProgress::resume(design, "main", 2, old);
        QVERIFY(resumed && resumed->scored() == 1 && !resumed->next().practice);
        // Nobody answers at all: somebody is asked.
        auto silent = session::StudyProgress::begin(design, "main", 2);
        QVERIFY(silent);
        for (int i = 0; i < design.fidelity.repeatsAtMost; ++i) {
            QVERIFY(!silent->needsExperimenter());
            answer(*silent, -1);
        }
        QVERIFY(silent->needsExperimenter());
        silent->experimenterSays(true);
        QVERIFY(!silent->needsExperimenter() && silent->next().practice);
    }
    void arrangementsAreBalanced() {
        const auto design = designOf("rank3");
        auto progress = session::StudyProgress::begin(design, "main", 4);
        QVERIFY(progress);
        std::map<int, int> count;
        for (const auto& trial : run(*progress, design.conditions.front(), 3, 38))
            if (!trial.practice)
                ++count[trial.arrangement];
        QCOMPARE(count.size(), std::size_t{6});
        for (const auto& [arrangement, n] : count)
            QCOMPARE(n, 6);
    }
    void limitedTableIsNeverPassed() {
        const auto design = designOf("rank3");
        auto progress = session::StudyProgress::begin(design, "main", 4, 0.1);
        QVERIFY(progress);
        const auto trials = run(*progress, design.conditions.front(), 3, 30);
        for (const auto& trial : trials)
            QVERIFY(trial.difference <= 0.1);
        QCOMPARE(session::StudyProgress::limitOf(progress->procedureIds()), 0.1);
    }
    /// The stored limit is the same number again, in every locale: no candidate at its edge is lost.
    void limitIsStoredExactly() {
        const auto design = designOf("rank3");
        const double limit = 0.07918124604762482; // log10 1.2
        for (const char* locale : {"de_DE.UTF-8", "C"}) {
            std::setlocale(LC_NUMERIC, locale); // stays as it is where the machine has none of that name
            auto progress = session::StudyProgress::begin(design, "main", 4, limit);
            QVERIFY(progress);
            QVERIFY(session::StudyProgress::limitOf(progress->procedureIds()) == limit);
        }
        QVERIFY(session::StudyProgress::limitOf("staircase@1") == session::StudyProgress::kNoLimit);
    }
    /// Yes–no and same–different: where nothing differed, a right answer does not make the next difference
    /// smaller.
    void alikeObjectsTellAProcedureNothing_data() {
        QTest::addColumn<int>("task");
        QTest::newRow("yes_no") << static_cast<int>(psychophysics::Task::yesNo);
        QTest::newRow("same_different") << static_cast<int>(psychophysics::Task::sameDifferent);
    }
    void alikeObjectsTellAProcedureNothing() {
        QFETCH(int, task);
        auto design = designOf("staircase");
        auto& condition = design.conditions.front();
        condition.task = static_cast<psychophysics::Task>(task);
        auto progress = session::StudyProgress::begin(design, "main", 6);
        QVERIFY(progress);
        std::vector<database::StudyTrial> trials;
        std::map<int, int> count;
        while (!progress->done() && trials.size() < 200) {
            session::StudyAnswer answer;
            const auto shown = progress->next();
            answer.answer = psychophysics::correctAnswer(condition.task, shown.arrangement);
            auto trial = progress->record(answer);
            QVERIFY(trial);
            if (!trial->practice)
                ++count[trial->arrangement];
            trials.push_back(*trial);
        }
        QVERIFY(progress->done());
        QCOMPARE(progress->procedures().front()->trials(), 40);
        int alike = 0;
        for (std::size_t i = 0; i + 1 < trials.size(); ++i)
            if (!trials[i].practice &&
                psychophysics::correctAnswer(condition.task, trials[i].arrangement) == 0) {
                ++alike;
                QCOMPARE(trials[i].outcome, 1); // scored and kept
                QCOMPARE(trials[i + 1].candidate, trials[i].candidate);
            }
        QVERIFY(alike > 30);
        for (const auto& [arrangement, n] : count)
            QVERIFY(std::abs(n - count[0]) <= 1); // every block of presentations holds each arrangement once
        database::StudyRun stored;
        stored.condition = "main";
        stored.seed = 6;
        const auto replayed = session::rerunChoices(design, stored, trials);
        QVERIFY(replayed);
        QCOMPARE(replayed->same, replayed->trials);
    }
    /// A trial that was spoiled more often than allowed, and went on: resumed after any presentation, it goes
    /// on as it would have.
    void resumedAfterManySpoilsGoesOnAlike() {
        auto design = designOf("interleaved");
        design.fidelity.repeatsAtMost = 2;
        auto whole = session::StudyProgress::begin(design, "main", 8);
        QVERIFY(whole);
        std::vector<database::StudyTrial> trials;
        std::vector<session::StudyPresentation> shown;
        for (int i = 0; i < 24; ++i) {
            if (whole->needsExperimenter())
                whole->experimenterSays(true);
            shown.push_back(whole->next());
            session::StudyAnswer answer;
            answer.answer = i % 2;
            answer.spoiled = (i > 4 && i < 12) || i == 15 ? "saturation" : "";
            const auto trial = whole->record(answer);
            QVERIFY(trial);
            trials.push_back(*trial);
        }
        for (std::size_t stop = 1; stop < trials.size(); ++stop) {
            auto resumed = session::StudyProgress::resume(
                design, "main", 8, {trials.begin(), trials.begin() + static_cast<std::ptrdiff_t>(stop)});
            QVERIFY(resumed);
            const auto next = resumed->next();
            QCOMPARE(next.candidate, shown[stop].candidate);
            QCOMPARE(next.arrangement, shown[stop].arrangement);
            QCOMPARE(next.procedure, shown[stop].procedure);
            QCOMPARE(next.repeat, shown[stop].repeat);
        }
    }
    void whoGivesUpIsDoneButNotFinished() {
        auto design = designOf("rank3");
        design.trial.practiceTrials = 0;
        auto progress = session::StudyProgress::begin(design, "main", 8);
        QVERIFY(progress);
        while (!progress->needsExperimenter()) {
            session::StudyAnswer answer;
            answer.answer = 0;
            answer.spoiled = "saturation";
            QVERIFY(progress->record(answer));
        }
        QCOMPARE(progress->spoiledTrials(), design.fidelity.repeatsAtMost);
        QVERIFY(!progress->done());
        progress->experimenterSays(false);
        QVERIFY(progress->done());
        QVERIFY(progress->gaveUp());
    }
};

QTEST_MAIN(TestStudyProgress)
#include "test_study_progress.moc"
