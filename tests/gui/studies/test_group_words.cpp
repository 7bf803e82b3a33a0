// SPDX-License-Identifier: GPL-3.0-or-later
// What a group's value rests on, and what a comparison waits for: one statement, which names everybody and
// never contradicts itself.
#include "psychophysics/study/group_estimate.h"
#include "report/plot_view.h"
#include "session/study/study_analysis.h"
#include "session_report/group_words.h"
#include "session_report/marked_estimates.h"
#include "session_report/study_comparison_words.h"
#include "session_report/study_warning_words.h"

#include <QRegularExpression>
#include <QtTest>
#include <algorithm>
#include <cmath>

using namespace chiron;
using psychophysics::WarningKind;
using session::Presence;

namespace {

constexpr std::array kAll{Presence::used,       Presence::sealed,   Presence::notBegun,  Presence::noAnswers,
                          Presence::unfinished, Presence::allRight, Presence::guessing,  Presence::unbounded,
                          Presence::noValue,    Presence::shown,    Presence::simulated, Presence::withdrawn};

session::GroupRoll rollOf(std::vector<std::pair<std::string, Presence>> people) {
    session::GroupRoll roll;
    for (auto& [code, presence] : people)
        roll.people.push_back({code, presence, false});
    return roll;
}

psychophysics::RunEstimate estimateWith(double weber, std::vector<psychophysics::Warning> warnings) {
    psychophysics::RunEstimate estimate;
    estimate.trials = 40;
    estimate.weber = weber;
    estimate.weber95 = {0.7 * weber, 1.4 * weber};
    estimate.warnings = std::move(warnings);
    return estimate;
}

const QLocale kEnglish{QLocale::English, QLocale::UnitedKingdom};
QString nameOf(std::size_t at) {
    return at == 0 ? QStringLiteral("Soft") : QStringLiteral("Stiff");
}

} // namespace

class TestGroupWords : public QObject {
    Q_OBJECT
private slots:
    void everybodyIsNamedOnce();
    void noValueIsSaidOnce();
    void whoBreaksOffIsNotFinished();
    void closedStudiesBeginNothing();
    void whyARunIsNotUsed();
    void theGroupAgreesWithItsRoll();
    void comparisonsSayWhatTheyWaitFor();
    void whatAComparisonLacksIsSaid();
    void oneRuleForGroupsAndComparisons();
    void doubtIsSeen();
    void adviceFollowsFromTheCause();
    void theTaskIsDoubtedOnlyOfGuessers();
    void verdictsSayNoMoreThanTheNumbers();
    void whoIsComparedIsNamed();
    void everyNoticeSaysHowManyItConcerns();
    void theTestIsNamed();
    void noNoticeContradictsTheStatement();
    void whatATooSmallStudyNeedsIsSaid();
    void eachConditionHasItsWeberFraction();
    void aValueFromThePriorIsNone();
};

namespace {

/// A run of `trials` answers between 4 and 15 %, in a table from 2 to 60 %.
psychophysics::RunEstimate presented(int trials, std::vector<psychophysics::Warning> warnings,
                                     double smallest = 0.04, double largest = 0.15) {
    if (trials < 20)
        warnings.push_back({WarningKind::fewTrials, trials});
    psychophysics::RunEstimate estimate = estimateWith(0.1, std::move(warnings));
    estimate.trials = trials;
    estimate.points = {{smallest, 1, 2}, {largest, trials - 2, trials - 2}};
    return estimate;
}

session::Remedy remedyOf(const psychophysics::RunEstimate& estimate) {
    return session::remedyFor(estimate, session::presenceOf(estimate, true), {0.02, 0.04, 0.15, 0.6});
}

/// Two conditions done by A and B, with this interval of the ratio.
session::ComparedConditions comparedBy(double ratio, double low, double high, double p) {
    session::ComparedConditions compared{0, 1, {}, {}};
    compared.weber.ratio = ratio;
    compared.weber.ratio95 = {low, high};
    compared.weber.pValue = compared.weber.pHolm = p;
    compared.weber.participants = compared.weber.first = compared.weber.second = 2;
    compared.firstPeople = compared.secondPeople = {"A", "B"};
    return compared;
}

QString verdictOf(const session::ComparedConditions& compared) {
    return session_report::comparisonVerdict(compared, nameOf(0), nameOf(1), kEnglish);
}

} // namespace

void TestGroupWords::everybodyIsNamedOnce() {
    session::GroupRoll roll;
    for (const Presence presence : kAll)
        if (presence != Presence::sealed)
            roll.people.push_back({"P" + std::to_string(static_cast<int>(presence)), presence, false});
    const QStringList said = session_report::groupSentences(roll, kEnglish);
    QCOMPARE(
        said.front(),
        QStringLiteral(
            "The group value includes 1 of 9 participants.")); // withdrawn and simulated ones take no part
    for (const session::RolledPerson& person : roll.people) {
        const auto named =
            said.filter(
                    QRegularExpression(QStringLiteral("\\b%1\\b").arg(QString::fromStdString(person.code))))
                .size();
        QCOMPARE(named, person.presence == Presence::used ? 0 : 1);
        QVERIFY(!session_report::presenceWords(person.presence).isEmpty());
    }
    roll.people.front().open = true; // used, and not finished
    QVERIFY(session_report::groupSentences(roll, kEnglish)
                .join(u' ')
                .contains(QStringLiteral("may still change")));
    QCOMPARE(session_report::groupSentences(rollOf({{"A", Presence::used}, {"B", Presence::used}}), kEnglish),
             QStringList{QStringLiteral("The group value includes everybody who takes part.")});
}

/// Few answers of a run that was broken off are no bad performance.
void TestGroupWords::whoBreaksOffIsNotFinished() {
    const auto few = estimateWith(0.6, {{WarningKind::chance}, {WarningKind::priorEdgeHigh}});
    QCOMPARE(session::presenceOf(few, true), Presence::guessing);
    QCOMPARE(session::presenceOf(few, false), Presence::unfinished);
    QCOMPARE(session::presenceOf(estimateWith(0.1, {}), false),
             Presence::used); // enough to bound it: used, and said to be able to change
    QCOMPARE(session_report::presenceWords(Presence::unfinished),
             QStringLiteral("no: the answers give no value yet")); // the rule asks for nothing more
    session::GroupRoll roll = rollOf({{"A", Presence::used}, {"B", Presence::unfinished}});
    QVERIFY(session_report::groupSentences(roll, kEnglish)
                .join(u' ')
                .contains(QStringLiteral("(B): the answers give no value yet. The run is not finished")));
    roll.closed = true;
    QVERIFY(session_report::groupSentences(roll, kEnglish)
                .join(u' ')
                .contains(QStringLiteral("cannot be resumed")));
}

/// Where there is none no sentence speaks of one, and no warning says the same again.
void TestGroupWords::noValueIsSaidOnce() {
    const QStringList said = session_report::groupSentences(
        rollOf({{"A", Presence::allRight}, {"B", Presence::notBegun}}), kEnglish);
    QVERIFY(said.front().startsWith(QStringLiteral("There is no group value yet")));
    QVERIFY(!said.join(u' ').contains(QStringLiteral("includes")));
    QVERIFY(said.join(u' ').contains(QStringLiteral("1 of 2 participants (A): every answer was right")) &&
            said.join(u' ').contains(
                QStringLiteral("1 of 2 participants (B): this condition has not been begun")));
    const auto group = psychophysics::estimateGroup(
        {estimateWith(0.01, {{WarningKind::allRight}, {WarningKind::priorEdgeLow}})}, 1);
    QVERIFY(psychophysics::hasWarning(group.warnings, WarningKind::noParticipants)); // as data have it
    QVERIFY(session_report::furtherWarnings(group.warnings).empty());
    QVERIFY(
        session_report::groupSentences({}, kEnglish).front().contains(QStringLiteral("nobody takes part")));
    QCOMPARE(
        session_report::groupSentences(rollOf({{"A", Presence::sealed}, {"B", Presence::sealed}}), kEnglish)
            .size(),
        1);
}

void TestGroupWords::closedStudiesBeginNothing() {
    session::GroupRoll roll = rollOf({{"A", Presence::notBegun}});
    QVERIFY(
        session_report::groupSentences(roll, kEnglish).last().contains(QStringLiteral("Begin it under Run")));
    roll.planned = 12;
    roll.enrolled = 1;
    QVERIFY(
        session_report::groupSentences(roll, kEnglish).last().contains(QStringLiteral("1 of 12 planned")));
    roll.closed = true;
    QVERIFY(!session_report::groupSentences(roll, kEnglish)
                 .join(u' ')
                 .contains(QStringLiteral("planned"))); // nobody can be enrolled
    QVERIFY(!session_report::groupSentences(roll, kEnglish).last().contains(QStringLiteral("Begin it")));
}

void TestGroupWords::whyARunIsNotUsed() {
    QCOMPARE(session::presenceOf(estimateWith(0.1, {}), true), Presence::used);
    QCOMPARE(session::presenceOf(estimateWith(0.1, {{WarningKind::fewTrials, 5}}), true),
             Presence::used); // doubtful, and used
    QCOMPARE(
        session::presenceOf(estimateWith(0.1, {{WarningKind::allRight}, {WarningKind::priorEdgeLow}}), true),
        Presence::allRight);
    QCOMPARE(
        session::presenceOf(estimateWith(0.1, {{WarningKind::chance}, {WarningKind::priorEdgeHigh}}), true),
        Presence::guessing);
    QCOMPARE(session::presenceOf(estimateWith(0.1, {{WarningKind::priorEdgeLow}}), true),
             Presence::unbounded);
    QCOMPARE(session::presenceOf(
                 estimateWith(0.1, {{WarningKind::priorEdgeLow}, {WarningKind::priorEdgeHigh}}), true),
             Presence::unbounded); // neither small nor large is ruled out: that is not guessing
    QCOMPARE(session::presenceOf(estimateWith(std::nan(""), {}), true), Presence::noValue);
    psychophysics::RunEstimate none;
    QCOMPARE(session::presenceOf(none, true), Presence::noAnswers);
    QCOMPARE(session::presenceOf(estimateWith(0.1, {{WarningKind::sealed}}), true), Presence::sealed);
    QSet<QString> tokens;
    for (const Presence presence : kAll)
        tokens.insert(QString::fromUtf8(session::presenceToken(presence).data()));
    QCOMPARE(tokens.size(), qsizetype(kAll.size()));
}

/// As many are used as the group's value is of; also of numbers said, which have an exponent and no Weber
/// fraction.
void TestGroupWords::theGroupAgreesWithItsRoll() {
    psychophysics::RunEstimate said;
    said.method = psychophysics::EstimateMethod::numbersSaid;
    said.trials = 20;
    said.exponent = 0.8;
    psychophysics::RunEstimate nothing = said;
    nothing.exponent = std::nan("");
    const std::vector<std::vector<psychophysics::RunEstimate>> groups{
        {said, said, nothing},
        {estimateWith(0.1, {}), estimateWith(0.2, {}), estimateWith(0.1, {{WarningKind::priorEdgeHigh}})}};
    for (const auto& runs : groups) {
        const auto group = psychophysics::estimateGroup(runs, 1);
        QCOMPARE(group.participants, 2);
        QCOMPARE(group.leftOut, 1);
        QVERIFY(!psychophysics::hasWarning(group.warnings, WarningKind::noParticipants));
        QCOMPARE(
            std::count_if(runs.begin(), runs.end(),
                          [](const auto& run) { return session::presenceOf(run, true) == Presence::used; }),
            2);
    }
}

void TestGroupWords::comparisonsSayWhatTheyWaitFor() {
    using session_report::comparisonSentences;
    const auto soft = rollOf({{"A", Presence::used}, {"B", Presence::used}});
    QStringList said = comparisonSentences(
        {soft, rollOf({{"A", Presence::notBegun}, {"B", Presence::allRight}})}, {}, nameOf, kEnglish);
    const QString bothNamed = QStringLiteral("“Soft” and “Stiff” are not compared");
    QVERIFY2(said.front().startsWith(bothNamed), qPrintable(said.front()));
    QVERIFY2(said.front().contains(QStringLiteral("“Stiff” has no group value")), qPrintable(said.front()));
    QVERIFY(said.join(u' ').contains(
        QStringLiteral("A is not in this comparison (“Soft”: in the group value; “Stiff”: not begun)")));
    QVERIFY(said.join(u' ').contains(QStringLiteral(
        "B is not in this comparison (“Soft”: in the group value; “Stiff”: every answer was right)")));
    said = comparisonSentences({soft, rollOf({{"A", Presence::used}, {"B", Presence::allRight}})}, {}, nameOf,
                               kEnglish);
    QVERIFY2(said.front().contains(QStringLiteral("only A has a value in both")), qPrintable(said.front()));
    QVERIFY2(said.front().startsWith(bothNamed), qPrintable(said.front()));
    QVERIFY2(said.front().contains(QStringLiteral("nobody has a value in “Stiff” alone")),
             qPrintable(said.front()));
    said = comparisonSentences({rollOf({{"A", Presence::used}, {"B", Presence::allRight}}), soft}, {}, nameOf,
                               kEnglish);
    QVERIFY2(said.front().contains(QStringLiteral("nobody has a value in “Soft” alone")),
             qPrintable(said.front()));
    said = comparisonSentences({rollOf({{"A", Presence::used}}), rollOf({{"B", Presence::used}})}, {}, nameOf,
                               kEnglish); // numbers that were said, of two people
    QVERIFY2(said.front().startsWith(bothNamed) && said.front().contains(QStringLiteral("set against")),
             qPrintable(said.front()));
    session::ComparedConditions paired{0, 1, {}, {}};
    QVERIFY(comparisonSentences({soft, soft}, {paired}, nameOf, kEnglish).isEmpty());
    said = comparisonSentences({soft, rollOf({{"A", Presence::used}, {"B", Presence::shown}})}, {paired},
                               nameOf, kEnglish);
    QCOMPARE(said.size(), 1); // it is there, and says who is not in it
    QVERIFY(said.front().startsWith(QStringLiteral("B is not in this comparison")));
    session::ComparedConditions groups{0, 1, {}, {}};
    groups.weber.paired = false;
    groups.weber.pValue = 0.5;
    QVERIFY(comparisonSentences({rollOf({{"A", Presence::used}, {"B", Presence::notBegun}}),
                                 rollOf({{"A", Presence::notBegun}, {"B", Presence::used}})},
                                {groups}, nameOf, kEnglish)
                .isEmpty());
}

/// A dash has its reason, and whoever is in both of two groups that are compared is told why they are in
/// neither.
void TestGroupWords::whatAComparisonLacksIsSaid() {
    session::ComparedConditions groups{0, 1, {}, {}};
    groups.weber.paired = false;
    groups.weber.first = 1;
    groups.weber.second = 2;
    const auto soft = rollOf({{"A", Presence::used},
                              {"B", Presence::used},
                              {"C", Presence::notBegun},
                              {"D", Presence::guessing},
                              {"W", Presence::withdrawn}});
    const auto stiff = rollOf({{"A", Presence::used},
                               {"B", Presence::unfinished},
                               {"C", Presence::used},
                               {"D", Presence::used},
                               {"W", Presence::withdrawn}});
    const QStringList said = session_report::comparisonSentences({soft, stiff}, {groups}, nameOf, kEnglish);
    QCOMPARE(said.size(), 3);
    QVERIFY2(said[0].contains(QStringLiteral("needs at least two people, and these have 1 and 2")),
             qPrintable(said[0]));
    QVERIFY2(said[0].startsWith(QStringLiteral("“Soft” and “Stiff” have a ratio")), qPrintable(said[0]));
    QVERIFY2(
        said[1].startsWith(QStringLiteral("A is not in this comparison: it compares two separate groups")),
        qPrintable(said[1]));
    QVERIFY2(said[2].startsWith(QStringLiteral("W: withdrawn")), qPrintable(said[2]));
    QCOMPARE(session_report::comparisonHeadings(false).size(),
             session_report::comparisonRow(groups, QStringLiteral("a"), QStringLiteral("b"), false, kEnglish)
                 .size());
    QCOMPARE(session_report::comparisonHeadings(true).size(),
             session_report::comparisonHeadings(false).size() + 1);
    QVERIFY(!session_report::comparisonNote(false).contains(QStringLiteral("thresholds")));
}

/// The same warning never counts for one run and not for another: what decides is whether the answers bound
/// the value, in groups and comparisons.
void TestGroupWords::oneRuleForGroupsAndComparisons() {
    QCOMPARE(session::presenceOf(estimateWith(0.1, {{WarningKind::chance}}), true), Presence::used);
    QCOMPARE(session::presenceOf(estimateWith(0.1, {{WarningKind::priorEdgeHigh}}), true),
             Presence::guessing);
    QVERIFY(!session_report::presenceWords(Presence::guessing)
                 .contains(QStringLiteral("guess"))); // what leaves it out is the end of the value
    QVERIFY(session_report::groupRule().contains(
        QStringLiteral("answers rule out two things: a threshold far below the smallest difference")));
    QVERIFY(
        session_report::groupRule().contains(QStringLiteral("does not matter whether the run is finished")));

    // A and B did both conditions; B's answers do not bound the second value. C did the second alone.
    session::StudyAnalysis study;
    study.design.conditions.resize(2);
    study.conditions.resize(2);
    const auto add = [&study](std::size_t condition, const char* code,
                              std::vector<psychophysics::Warning> warnings) {
        session::AnalysedRun run;
        run.participant.code = code;
        run.estimate = estimateWith(0.1, std::move(warnings));
        run.presence = session::presenceOf(run.estimate, true);
        study.conditions[condition].runs.push_back(std::move(run));
    };
    add(0, "A", {});
    add(0, "B", {{WarningKind::chance}});
    add(1, "A", {});
    add(1, "B", {{WarningKind::chance}, {WarningKind::priorEdgeHigh}});
    add(1, "C", {});
    for (std::size_t i = 0; i < 2; ++i) {
        study.conditions[i].condition = study.design.conditions[i].id = i == 0 ? "soft" : "stiff";
        std::vector<psychophysics::RunEstimate> estimates;
        for (const session::AnalysedRun& run : study.conditions[i].runs)
            estimates.push_back(run.estimate);
        study.conditions[i].group = psychophysics::estimateGroup(estimates, 1);
        QCOMPARE(study.conditions[i].group.participants, 2);
    }
    const auto compared = session::compareAll(study, 1);
    QCOMPARE(compared.size(), std::size_t{1});
    QVERIFY(!compared.front().weber.paired); // only A has a value in both: two groups, of B and of C
    QCOMPARE(compared.front().weber.first, 1);
    QCOMPARE(compared.front().weber.second, 1);
    QVERIFY(compared.front().firstPeople == std::vector<std::string>{"B"} &&
            compared.front().secondPeople == std::vector<std::string>{"C"});
    QVERIFY(!session::testsThresholds(compared));
}

void TestGroupWords::doubtIsSeen() {
    using session_report::markedValue;
    QCOMPARE(markedValue(QStringLiteral("10 %"), estimateWith(0.1, {})), QStringLiteral("10 %"));
    QCOMPARE(markedValue(QStringLiteral("10 %"), estimateWith(0.1, {{WarningKind::chance}})),
             QStringLiteral("! 10 %"));
    QCOMPARE(markedValue(QStringLiteral("–"), estimateWith(std::nan(""), {{WarningKind::noTrials}})),
             QStringLiteral("–"));
    session_report::MarkedEstimates estimates;
    QVERIFY(estimates.empty());
    estimates.add(0.0, estimateWith(0.1, {}), Presence::used);
    estimates.add(1.0, estimateWith(0.1, {{WarningKind::lapses}}), Presence::used);
    estimates.add(2.0, estimateWith(0.1, {{WarningKind::allRight}}), Presence::allRight);
    report::PlotView plot{report::PlotTheme{}};
    estimates.draw(plot);
    QCOMPARE(plot.legendTexts().size(), 3); // in words, not by colour
}

/// Too few trials ask for more of them, whatever was presented; then comes what the table has and the run did
/// not reach, and other differences only where it reached the table's end.
void TestGroupWords::adviceFollowsFromTheCause() {
    using session::Remedy;
    const psychophysics::Warning high{WarningKind::priorEdgeHigh}, low{WarningKind::priorEdgeLow};
    for (const auto& warnings : {std::vector{high}, std::vector{low}, std::vector{high, low}})
        QVERIFY(remedyOf(presented(6, warnings)) == Remedy::moreTrials);
    QVERIFY(remedyOf(presented(40, {high})) == Remedy::unusedDifferences);
    QVERIFY(remedyOf(presented(40, {low})) == Remedy::unusedDifferences);
    QVERIFY(remedyOf(presented(40, {high}, 0.04, 0.6)) == Remedy::otherDifferences);
    QVERIFY(remedyOf(presented(40, {low}, 0.02)) == Remedy::otherDifferences);
    QVERIFY(remedyOf(presented(40, {{WarningKind::allRight}, low}, 0.02)) == Remedy::otherDifferences);
    QVERIFY(remedyOf(presented(40, {high, low}, 0.02, 0.6)) == Remedy::moreTrials);
    QVERIFY(remedyOf(presented(40, {{WarningKind::oneLevel}, high, low})) == Remedy::moreDifferences);
    QVERIFY(remedyOf(presented(24, {{WarningKind::tooFewToTell}, high}, 0.04, 0.6)) == Remedy::moreTrials);
    QVERIFY(remedyOf(presented(40, {})) == Remedy::none);
    const auto said = [](Presence presence, Remedy remedy) {
        session::GroupRoll roll;
        roll.people = {{"A", presence, false, remedy}};
        return session_report::groupSentences(roll, kEnglish).join(u' ');
    };
    for (const Presence presence : {Presence::allRight, Presence::guessing, Presence::unbounded}) {
        const QString few = said(presence, Remedy::moreTrials);
        QVERIFY2(few.contains(QStringLiteral("plan more trials")) &&
                     !few.contains(QStringLiteral("larger differences")) &&
                     !few.contains(QStringLiteral("smaller differences")),
                 qPrintable(few));
    }
    QVERIFY(said(Presence::guessing, Remedy::unusedDifferences).contains(QStringLiteral("table has larger")));
    QVERIFY(
        said(Presence::allRight, Remedy::unusedDifferences).contains(QStringLiteral("table has smaller")));
    QVERIFY(said(Presence::guessing, Remedy::otherDifferences).contains(QStringLiteral("plan larger")));
    QVERIFY(said(Presence::allRight, Remedy::otherDifferences).contains(QStringLiteral("plan smaller")));
    QVERIFY(said(Presence::unbounded, Remedy::moreDifferences).contains(QStringLiteral("plan several")));
    QVERIFY(said(Presence::unbounded, Remedy::moreTrials).contains(QStringLiteral("far above the largest")));
    session::GroupRoll below; // 24 of 25 right: nothing large is possible
    below.people = {{"A", Presence::unbounded, false, Remedy::otherDifferences, false, true}};
    const QString small = session_report::groupSentences(below, kEnglish).join(u' ');
    QVERIFY2(small.contains(QStringLiteral("far below the smallest")) &&
                 !small.contains(QStringLiteral("far above")) &&
                 small.contains(QStringLiteral("plan smaller")),
             qPrintable(small));
}

/// Whoever had nearly everything right understood the task.
void TestGroupWords::theTaskIsDoubtedOnlyOfGuessers() {
    session::GroupRoll roll;
    roll.people = {{"A", Presence::guessing, false, session::Remedy::moreTrials, false},
                   {"B", Presence::guessing, false, session::Remedy::moreTrials, true},
                   {"C", Presence::guessing, false, session::Remedy::moreTrials, false},
                   {"D", Presence::used, false, session::Remedy::none, false}};
    const QStringList doubted = session_report::groupSentences(roll, kEnglish)
                                    .filter(QStringLiteral("Check that the task was understood"));
    QCOMPARE(doubted.size(), 1);
    QVERIFY2(doubted.front().startsWith(QStringLiteral("1 of 4 participants (B): ")),
             qPrintable(doubted.front()));
    QCOMPARE(session_report::groupSentences(roll, kEnglish)
                 .filter(QStringLiteral("2 of 4 participants (A, C): "))
                 .size(),
             1);
}

void TestGroupWords::verdictsSayNoMoreThanTheNumbers() {
    QString said = verdictOf(comparedBy(1.0, 3.3e-6, 303393.0, 1.0));
    QVERIFY2(said.startsWith(QStringLiteral("The values show no difference between “Soft” and “Stiff”")) &&
                 said.contains(QStringLiteral("unbounded in practice (too few participants)")) &&
                 said.contains(
                     QStringLiteral("With 2 participants in both conditions, even a tenfold difference")),
             qPrintable(said));
    QVERIFY2(!said.contains(QStringLiteral("303")), qPrintable(said));
    QVERIFY(session_report::comparisonRow(comparedBy(1.0, 3.3e-6, 303393.0, 1.0), nameOf(0), nameOf(1), false,
                                          kEnglish)[2]
                .startsWith(QStringLiteral("unbounded in practice")));
    said = verdictOf(comparedBy(1.1, 0.55, 2.2, 0.6));
    QVERIFY2(said.contains(QStringLiteral("0.550 … 2.20")) &&
                 said.contains(QStringLiteral("every ratio in this interval remains possible")),
             qPrintable(said));
    said = verdictOf(comparedBy(94.0, 8.0, 1100.0, 0.01)); // wide, and yet it excludes 1
    QVERIFY2(said.contains(QStringLiteral("8.00 … 1,100")) && !said.contains(QStringLiteral("unbounded")),
             qPrintable(said));
    said = verdictOf(comparedBy(1.4, 1.1, 1.8, 0.012));
    QVERIFY2(
        said.startsWith(QStringLiteral("The Weber fraction of “Stiff” is 1.40 times that of “Soft” (95 % "
                                       "interval: 1.10 … 1.80; p = 0.012).")),
        qPrintable(said));
    said = verdictOf(comparedBy(0.5, 0.4, 0.8, 0.0001)); // the larger one is named first
    QVERIFY2(
        said.startsWith(QStringLiteral("The Weber fraction of “Soft” is 2.00 times that of “Stiff” (95 % "
                                       "interval: 1.25 … 2.50; p < 0.001).")),
        qPrintable(said));
    session::ComparedConditions adjusted = comparedBy(1.4, 1.1, 1.8, 0.03);
    adjusted.weber.pHolm = 0.09; // one of several comparisons
    said = verdictOf(adjusted);
    QVERIFY2(said.startsWith(QStringLiteral("The values show no difference")) &&
                 said.contains(QStringLiteral("adjusted p = 0.090")) &&
                 said.contains(QStringLiteral("interval is that of this comparison alone")) &&
                 !said.contains(QStringLiteral("remains possible")),
             qPrintable(said));
    said = verdictOf(comparedBy(1.4, std::nan(""), std::nan(""), std::nan("")));
    QVERIFY2(said.contains(QStringLiteral("It is not known whether the Weber fractions")), qPrintable(said));
}

void TestGroupWords::whoIsComparedIsNamed() {
    QVERIFY(verdictOf(comparedBy(1.0, 0.5, 2.0, 1.0)).endsWith(QStringLiteral("both conditions: A, B.")));
    session::ComparedConditions groups = comparedBy(1.0, 0.5, 2.0, 1.0);
    groups.weber.paired = false;
    groups.secondPeople = {"C", "D"};
    const QString said = verdictOf(groups);
    QVERIFY2(said.endsWith(QStringLiteral(
                 "A, B, with a value only in “Soft”, and C, D, with a value only in “Stiff”.")),
             qPrintable(said));
    QVERIFY2(said.contains(QStringLiteral("two groups of 2 and 2 participants")), qPrintable(said));
}

/// Of those whom the first sentence counts; of everybody for those who take no part. Where there is nobody
/// else, a number would say nothing.
void TestGroupWords::everyNoticeSaysHowManyItConcerns() {
    const auto roll = rollOf({{"A", Presence::used},
                              {"B", Presence::allRight},
                              {"C", Presence::allRight},
                              {"D", Presence::notBegun},
                              {"W", Presence::withdrawn}});
    const QStringList said = session_report::groupSentences(roll, kEnglish);
    QVERIFY(said.front().contains(QStringLiteral("1 of 4 participants")));
    for (const char* begins : {"2 of 4 participants (B, C): every answer", "1 of 4 participants (D): this",
                               "1 of 5 participants (W): withdrawn"})
        QCOMPARE(said.filter(QLatin1String(begins)).size(), 1);
    const QStringList alone = session_report::groupSentences(rollOf({{"A", Presence::allRight}}), kEnglish);
    QVERIFY2(alone.last().startsWith(QStringLiteral("A: every answer")), qPrintable(alone.last()));
    for (const QString& each : said + alone)
        QVERIFY2(!each.contains(QStringLiteral("1 participants")) && !each.contains(QStringLiteral("(s)")),
                 qPrintable(each));
}

/// Whether or not somebody has a value, what is said of runs that were shown or simulated is true.
void TestGroupWords::noNoticeContradictsTheStatement() {
    for (const Presence presence : kAll) {
        if (presence == Presence::used || presence == Presence::sealed)
            continue;
        const QString statement = session_report::groupSentences(rollOf({{"A", presence}}), kEnglish).front();
        QVERIFY2(statement.startsWith(QStringLiteral("There is no group value")), qPrintable(statement));
        QVERIFY2(!statement.contains(QStringLiteral("usable")),
                 qPrintable(statement)); // A may have given one
    }
    for (const WarningKind kind :
         {WarningKind::shownInGroup, WarningKind::notRenderedOfGroup, WarningKind::simulatedOnly}) {
        const QString notice = session_report::warningWords({kind, 1});
        for (const char* claims : {"group includes", "of the group", "group contains"})
            QVERIFY2(!notice.contains(QLatin1String(claims)), qPrintable(notice));
    }
    QVERIFY(session_report::warningWords({WarningKind::shownInGroup, 1})
                .contains(QStringLiteral("if its answers give a value")));
}

/// From how much people scatter, not from the ratio that was found; and from fewer than three people nothing
/// is reckoned.
void TestGroupWords::whatATooSmallStudyNeedsIsSaid() {
    const auto of = [](int people, double low, double high) {
        session::ComparedConditions compared = comparedBy(std::sqrt(low * high), low, high, 0.6);
        compared.weber.participants = compared.weber.first = compared.weber.second = people;
        return verdictOf(compared);
    };
    QVERIFY2(of(2, 0.55, 2.2).contains(QStringLiteral("cannot show how many are needed")),
             qPrintable(of(2, 0.55, 2.2)));
    const auto needed = [&](int people, double low, double high) {
        static const QRegularExpression kNumber(QStringLiteral("about (\\d+) participants in both"));
        return kNumber.match(of(people, low, high)).captured(1).toInt();
    };
    const int few = needed(6, 0.6, 1.8), more = needed(6, 0.4, 2.7);
    QVERIFY2(few > 6 && more > few, qPrintable(of(6, 0.6, 1.8) + of(6, 0.4, 2.7)));
    QCOMPARE(needed(6, 0.6 * 1.2, 1.8 * 1.2), few);                    // the same scatter about another ratio
    QVERIFY(!of(6, 0.9, 1.15).contains(QStringLiteral("are needed"))); // six are enough
    QVERIFY(of(6, 0.6, 1.8).contains(QStringLiteral("1.5 times the other")));
    session::GroupRoll roll;
    roll.people = {{"A", Presence::unbounded, false, session::Remedy::moreTrials, false, false, 7}};
    QString said = session_report::groupSentences(roll, kEnglish).join(u' ');
    QVERIFY2(said.contains(QStringLiteral("Fewer than 20 answers")) &&
                 said.contains(QStringLiteral("Expected precision")),
             qPrintable(said));
    roll.people.front().answers = 40;
    said = session_report::groupSentences(roll, kEnglish).join(u' ');
    QVERIFY2(!said.contains(QStringLiteral("Fewer than 20")) &&
                 said.contains(QStringLiteral("Expected precision")),
             qPrintable(said));
}

/// With its degrees of freedom; and none where there is no p.
void TestGroupWords::theTestIsNamed() {
    QVERIFY(verdictOf(comparedBy(1.4, 1.1, 1.8, 0.012))
                .contains(QStringLiteral("paired t test on the log Weber fractions (df = 1;")));
    session::ComparedConditions groups = comparedBy(1.0, 0.5, 2.0, 1.0);
    groups.weber.paired = false;
    QVERIFY(verdictOf(groups).contains(QStringLiteral("Welch's t test on the log Weber fractions")));
    const double none = std::nan("");
    QVERIFY(!verdictOf(comparedBy(1.4, none, none, none)).contains(QStringLiteral("t test")));
}

void TestGroupWords::eachConditionHasItsWeberFraction() {
    using session_report::weberOfCondition;
    const auto two = psychophysics::estimateGroup({estimateWith(0.1, {}), estimateWith(0.12, {})}, 1);
    const QString said = weberOfCondition(two, nameOf(0), kEnglish);
    QVERIFY2(said.startsWith(QStringLiteral("“Soft”: Weber fraction 1")) &&
                 said.contains(QStringLiteral("95 % interval: ")) &&
                 said.endsWith(QStringLiteral("of 2 participants.")),
             qPrintable(said));
    const auto one = psychophysics::estimateGroup({estimateWith(0.1, {})}, 1);
    QVERIFY(weberOfCondition(one, nameOf(0), kEnglish).endsWith(QStringLiteral("of one participant.")));
    const auto none = psychophysics::estimateGroup({estimateWith(0.1, {{WarningKind::priorEdgeLow}})}, 1);
    QVERIFY(weberOfCondition(none, nameOf(0), kEnglish).isEmpty());
}

/// What stands in an estimate that the answers do not support comes from the prior, and is not shown as a
/// value.
void TestGroupWords::aValueFromThePriorIsNone() {
    using session_report::supportedValue;
    const auto open = estimateWith(0.0306, {{WarningKind::priorEdgeHigh}});
    QCOMPARE(supportedValue(QStringLiteral("3.06 %"), open, true), QStringLiteral("no value yet"));
    QCOMPARE(supportedValue(QStringLiteral("3.06 %"), open, false), QStringLiteral("no value"));
    QCOMPARE(session_report::supportedInterval(QStringLiteral("1 … 9 %"), open), QStringLiteral("–"));
    QVERIFY(!session_report::whyNoValue(open).isEmpty());
    const auto doubtful = estimateWith(0.0306, {{WarningKind::fewTrials, 6}});
    QCOMPARE(supportedValue(QStringLiteral("3.06 %"), doubtful, true), QStringLiteral("! 3.06 %"));
    QCOMPARE(session_report::supportedInterval(QStringLiteral("1 … 9 %"), doubtful),
             QStringLiteral("1 … 9 %"));
    QVERIFY(session_report::whyNoValue(doubtful).isEmpty());
}

QTEST_MAIN(TestGroupWords)
#include "test_group_words.moc"
