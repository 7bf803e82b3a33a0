// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/study/questionnaire_replies.h"

#include <QtTest>
#include <cmath>

using namespace chiron;

// Answers beside performance: who does better than the others in a condition stands above 0, however the
// conditions' own scales are.
class TestQuestionnaireReplies : public QObject {
    Q_OBJECT
private slots:
    void performanceIsAmongOthers();
    void aConditionThatTellsNobodyApart();
    void repliesAreByParticipant();
    void partsAreByCondition();
};

namespace {

session::AnalysedRun weberRun(database::ParticipantNumber who, double weber) {
    session::AnalysedRun run;
    run.participant.id = who;
    run.estimate.weber = weber;
    return run;
}

session::AnalysedRun apexRun(database::ParticipantNumber who, double percent) {
    session::AnalysedRun run;
    run.participant.id = who;
    run.apex.emplace();
    run.apex->meanAbsolutePercent = percent;
    return run;
}

session::AnalysedCondition conditionOf(std::vector<session::AnalysedRun> runs) {
    session::AnalysedCondition condition;
    condition.runs = std::move(runs);
    return condition;
}

} // namespace

void TestQuestionnaireReplies::performanceIsAmongOthers() {
    session::StudyAnalysis analysis;
    analysis.conditions.push_back(
        conditionOf({weberRun(1, 0.01), weberRun(2, 0.1), weberRun(3, 1.0)})); // log10: −2, −1, 0; sd 1
    analysis.conditions.push_back(
        conditionOf({apexRun(1, 20.0), apexRun(2, 10.0), weberRun(4, std::nan(""))})); // sd 7.07, mean 15
    const auto performance = session::performanceOf(analysis);
    QCOMPARE(performance.size(), std::size_t{3});
    const double apart = 5.0 / std::sqrt(50.0);
    QVERIFY(std::abs(performance.at(1) - 0.5 * (1.0 - apart)) <
            1e-12); // better in the first, worse in the second
    QVERIFY(std::abs(performance.at(2) - 0.5 * apart) < 1e-12);
    QVERIFY(std::abs(performance.at(3) + 1.0) < 1e-12);
}

void TestQuestionnaireReplies::aConditionThatTellsNobodyApart() {
    session::StudyAnalysis analysis;
    analysis.conditions.push_back(conditionOf({weberRun(1, 0.1), weberRun(2, 0.1)}));
    analysis.conditions.push_back(conditionOf({weberRun(3, 0.1)}));
    QVERIFY(session::performanceOf(analysis).empty());
}

void TestQuestionnaireReplies::repliesAreByParticipant() {
    psychophysics::Questionnaire questionnaire;
    questionnaire.id = "face";
    const auto replies =
        session::questionnaireReplies(questionnaire,
                                      {{2, "face", "real", 4.0, "", ""},
                                       {1, "face", "real", 5.0, "", ""},
                                       {2, "face", "remarks", {}, "soft", ""},
                                       {3, "other", "real", 1.0, "", ""},
                                       {4, "face", "real", {}, "", ""}}, // of another; erased
                                      {{2, 0.5}});
    QCOMPARE(replies.size(), std::size_t{2});
    QVERIFY(replies[0].numbers.at("real") == 5.0 && std::isnan(replies[0].performance));
    QVERIFY(replies[1].numbers.at("real") == 4.0 && replies[1].texts.at("remarks") == "soft" &&
            replies[1].performance == 0.5);
}

/// Asked once: one part, whoever has answered; after each condition: one for each that was answered about, in
/// the design's order.
void TestQuestionnaireReplies::partsAreByCondition() {
    psychophysics::StudyDesign design;
    design.conditions.resize(2);
    design.conditions[0].id = "soft";
    design.conditions[1].id = "hard";
    psychophysics::Questionnaire questionnaire;
    questionnaire.id = "tlx";
    QCOMPARE(session::answeredParts(design, questionnaire, {}).size(), std::size_t{1});
    const auto about = [](database::StudyRunNumber run, const char* condition, const char* code,
                          bool withheld = false) {
        database::QuestionnaireAnswer answer{1, "tlx", "effort", 3.0, "", ""};
        answer.run = run;
        answer.condition = condition;
        answer.sealedCode = code;
        answer.withheld = withheld;
        return answer;
    };
    questionnaire.when = psychophysics::Questionnaire::When::afterCondition;
    QVERIFY(session::answeredParts(design, questionnaire, {}).empty());
    const auto parts = session::answeredParts(design, questionnaire,
                                              {about(7, "hard", "Q7M"), about(8, "soft", "A3K"),
                                               about(9, "hard", "Q7M"), about(4, "", "ZZZ", true)});
    QCOMPARE(parts.size(), std::size_t{2});
    QVERIFY(parts[0].label == "soft" && parts[0].answers.size() == 1 && parts[1].label == "hard" &&
            parts[1].answers.size() == 2);
    const auto codes =
        session::answeredParts(design, questionnaire, {about(7, "", "Q7M"), about(8, "", "A3K")});
    QVERIFY(codes.size() == 2 && codes[0].label == "A3K" && codes[1].label == "Q7M");
}

QTEST_GUILESS_MAIN(TestQuestionnaireReplies)
#include "test_questionnaire_replies.moc"
