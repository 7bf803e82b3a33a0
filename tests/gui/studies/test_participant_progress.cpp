// SPDX-License-Identifier: GPL-3.0-or-later
// What became of each condition of a participant, and what a researcher can do next: there is always
// something that can be done, or nothing left to do.
#include "desktop/studies/participant_progress.h"
#include "support/made_study.h"

#include <QtTest>

using namespace chiron;
using database::ParticipantState;
using database::StudyRunState;
using database::StudyState;
using desktop::ConditionProgress;
using desktop::OpenStudy;
using desktop::ParticipantRow;

namespace {

const QLocale kEnglish{QLocale::English, QLocale::UnitedKingdom};

OpenStudy study(StudyState state = StudyState::frozen) {
    OpenStudy open{};
    open.design = tests::smallStudy("progress");
    open.design.order = psychophysics::OrderDesign::fixed;
    open.design.questionnaires.clear();
    open.sealed = {{"stiffness", "QQ1"}, {"mass", "QQ2"}};
    open.summary.state = state;
    return open;
}

ParticipantRow row(ParticipantState state, std::vector<std::pair<std::string, StudyRunState>> runs) {
    ParticipantRow made;
    made.participant.code = "K7M-4QX";
    made.participant.state = state;
    for (const auto& [condition, runState] : runs) {
        database::StudyRun run;
        run.id = static_cast<database::StudyRunNumber>(made.runs.size()) + 1;
        run.condition = condition;
        run.state = runState;
        made.runs.push_back(run);
        if (runState == StudyRunState::open)
            made.left.push_back({run.id, 12, 40, "2026-11-28T10:12:00Z"});
    }
    return made;
}

} // namespace

class TestParticipantProgress : public QObject {
    Q_OBJECT
private slots:
    void eachConditionInWords() {
        const OpenStudy open = study();
        const ParticipantRow half = row(ParticipantState::consented, {{"stiffness", StudyRunState::open}});
        const auto progress = desktop::conditionProgress(open, half);
        QCOMPARE(progress.size(), std::size_t(2));
        QVERIFY2(desktop::progressWords(open, progress[0], kEnglish)
                     .contains(QStringLiteral("interrupted at trial 13 of at most 40")),
                 qPrintable(desktop::progressWords(open, progress[0], kEnglish)));
        QCOMPARE(desktop::progressWords(open, progress[1], kEnglish), QStringLiteral("not begun yet"));
        const QString next = desktop::nextStepFor(open, half, QStringLiteral("en"));
        QVERIFY2(next.contains(QStringLiteral("resume “Stiffness of a tube”")), qPrintable(next));
        const ParticipantRow gone = row(ParticipantState::withdrawn, {{"stiffness", StudyRunState::completed},
                                                                      {"mass", StudyRunState::stopped}});
        const auto left = desktop::conditionProgress(open, gone);
        QVERIFY(left[0].state == ConditionProgress::State::done &&
                left[1].state == ConditionProgress::State::ended);
        QVERIFY(desktop::progressWords(open, left[1], kEnglish).contains(QStringLiteral("broken off")));
        const ParticipantRow never = row(ParticipantState::withdrawn, {});
        for (const ConditionProgress& each : desktop::conditionProgress(open, never))
            QCOMPARE(desktop::progressWords(open, each, kEnglish),
                     QStringLiteral("not begun before the participant withdrew"));
    }
    /// "Not begun yet" promises a beginning.
    void whoCannotBeginHasDoneNothing() {
        const auto progress = [](StudyState of, ParticipantState state) {
            return desktop::participantProgress(study(of), row(state, {}), kEnglish);
        };
        QCOMPARE(progress(StudyState::frozen, ParticipantState::enrolled), QStringLiteral("not begun yet"));
        QCOMPARE(progress(StudyState::frozen, ParticipantState::consented), QStringLiteral("not begun yet"));
        QCOMPARE(progress(StudyState::frozen, ParticipantState::withdrawn), QStringLiteral("0 of 2 done"));
        for (const StudyState over : {StudyState::closed, StudyState::archived})
            for (const ParticipantState state : {ParticipantState::enrolled, ParticipantState::consented})
                QCOMPARE(progress(over, state), QStringLiteral("0 of 2 done"));
        QCOMPARE(desktop::participantStanding(study(StudyState::closed), row(ParticipantState::consented, {}),
                                              kEnglish),
                 QStringLiteral("0 of 2 done"));
    }
    void howSomebodyStandsInTheList() {
        const auto stands = [](ParticipantState state,
                               std::vector<std::pair<std::string, StudyRunState>> runs) {
            return desktop::participantStanding(study(), row(state, std::move(runs)), kEnglish);
        };
        QCOMPARE(stands(ParticipantState::enrolled, {}), QStringLiteral("Consent missing"));
        QCOMPARE(stands(ParticipantState::consented, {}), QStringLiteral("not begun yet"));
        QCOMPARE(stands(ParticipantState::consented, {{"stiffness", StudyRunState::open}}),
                 QStringLiteral("0 of 2 done, one interrupted"));
        QCOMPARE(stands(ParticipantState::consented, {{"stiffness", StudyRunState::completed}}),
                 QStringLiteral("1 of 2 done"));
        QCOMPARE(stands(ParticipantState::withdrawn, {{"stiffness", StudyRunState::stopped}}),
                 QStringLiteral("Withdrawn"));
        const ParticipantRow all = row(ParticipantState::completed, {{"stiffness", StudyRunState::completed},
                                                                     {"mass", StudyRunState::completed}});
        QCOMPARE(desktop::participantStanding(study(), all, kEnglish), QStringLiteral("Completed"));
        OpenStudy asks = study();
        asks.design.questionnaires = tests::smallStudy("asks").questionnaires;
        QCOMPARE(desktop::participantStanding(asks, all, kEnglish),
                 QStringLiteral("Completed, with questions to answer"));
        asks.answered.emplace(all.participant.id, asks.design.questionnaires.front().id);
        QCOMPARE(desktop::participantStanding(asks, all, kEnglish), QStringLiteral("Completed"));
    }
    void whoIsWaiting() {
        QVERIFY(desktop::isWaiting(study(), row(ParticipantState::enrolled, {})));
        QVERIFY(!desktop::isWaiting(study(StudyState::closed), row(ParticipantState::enrolled, {})));
        const ParticipantRow half = row(ParticipantState::consented, {{"stiffness", StudyRunState::open}});
        for (const StudyState state : {StudyState::frozen, StudyState::closed})
            QVERIFY(desktop::isWaiting(study(state), half)); // it can be finished
        QVERIFY(!desktop::isWaiting(study(StudyState::closed), row(ParticipantState::consented, {})));
        QVERIFY(!desktop::isWaiting(study(), row(ParticipantState::withdrawn, {})));
        const ParticipantRow all = row(ParticipantState::consented, {{"stiffness", StudyRunState::completed},
                                                                     {"mass", StudyRunState::completed}});
        QVERIFY(!desktop::isWaiting(study(), all));
        OpenStudy asks = study();
        asks.design.questionnaires = tests::smallStudy("asks").questionnaires;
        QVERIFY(desktop::isWaiting(asks, all));
        ParticipantRow completed = all; // every condition, and none of the questions
        completed.participant.state = ParticipantState::completed;
        QVERIFY(!desktop::isWaiting(study(), completed));
        QVERIFY(desktop::isWaiting(asks, completed));
        ParticipantRow gone = all;
        gone.participant.state = ParticipantState::withdrawn;
        QVERIFY(!desktop::isWaiting(asks, gone));
        asks.summary.state = StudyState::closed;
        QVERIFY(desktop::isWaiting(asks, completed));
        QVERIFY(desktop::isWaiting(
            asks, row(ParticipantState::consented, {{"stiffness", StudyRunState::completed}})));
        QVERIFY(
            !desktop::isWaiting(asks, row(ParticipantState::consented, {}))); // there is nothing to ask about
        asks.answered.emplace(completed.participant.id, asks.design.questionnaires.front().id);
        QVERIFY(!desktop::isWaiting(asks, completed));
    }
    void whatComesNext() {
        const auto next = [](const OpenStudy& open, const ParticipantRow& of) {
            return desktop::nextStepFor(open, of, QStringLiteral("en"));
        };
        QVERIFY(next(study(), row(ParticipantState::enrolled, {})).contains(QStringLiteral("consent")));
        QVERIFY(next(study(), row(ParticipantState::consented, {}))
                    .contains(QStringLiteral("begin “Stiffness of a tube”")));
        QVERIFY(next(study(), row(ParticipantState::consented, {{"stiffness", StudyRunState::completed}}))
                    .contains(QStringLiteral("begin “Mass of an object”")));
        const QString closed =
            next(study(StudyState::closed),
                 row(ParticipantState::consented, {{"stiffness", StudyRunState::completed}}));
        QVERIFY2(closed.contains(QStringLiteral("no longer")) &&
                     !closed.contains(QStringLiteral("Press Run")),
                 qPrintable(closed)); // it would be refused
        QVERIFY(next(study(StudyState::closed),
                     row(ParticipantState::consented, {{"stiffness", StudyRunState::open}}))
                    .contains(QStringLiteral("resume"))); // that is not
        QVERIFY(next(study(StudyState::archived), row(ParticipantState::consented, {}))
                    .contains(QStringLiteral("archive")));
        QVERIFY(next(study(), row(ParticipantState::withdrawn, {{"mass", StudyRunState::stopped}}))
                    .contains(QStringLiteral("withdrawn")));
        const ParticipantRow all = row(ParticipantState::completed, {{"stiffness", StudyRunState::completed},
                                                                     {"mass", StudyRunState::completed}});
        QVERIFY(next(study(), all).contains(QStringLiteral("Nothing is left")));
        OpenStudy asks = study();
        asks.design.questionnaires = tests::smallStudy("asks").questionnaires;
        QVERIFY(next(asks, all).contains(QStringLiteral("Face and content validity")));
        OpenStudy over = asks;
        over.summary.state = StudyState::closed;
        const QString both =
            next(over, row(ParticipantState::consented, {{"stiffness", StudyRunState::completed}}));
        QVERIFY2(both.contains(QStringLiteral("no longer")) &&
                     both.contains(QStringLiteral("Face and content validity")),
                 qPrintable(both));
        const std::string id = asks.design.questionnaires.front().id;
        asks.design.questionnaires.front().when = psychophysics::Questionnaire::When::afterCondition;
        asks.answered.emplace(all.participant.id, id); // about the first condition, and not about the second
        asks.answeredAfter.emplace(1, id);
        QVERIFY(next(asks, all).contains(QStringLiteral("Face and content validity")));
        asks.answeredAfter.emplace(2, id);
        QVERIFY(next(asks, all).contains(QStringLiteral("Nothing is left")));
    }
};

QTEST_MAIN(TestParticipantProgress)
#include "test_participant_progress.moc"
