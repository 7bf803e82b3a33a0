// SPDX-License-Identifier: GPL-3.0-or-later
// Face and content validity: counts, medians, agreement and the content validity index by hand and from
// published tables.
#include "psychophysics/measures/questionnaire_measures.h"
#include "tests/unit/psychophysics/measures/published_line.h"

using namespace chiron::psychophysics;

namespace {

QuestionnaireItem likert(const char* id, int scale, const char* construct) {
    QuestionnaireItem item;
    item.id = id;
    item.scale = scale;
    item.construct = construct;
    return item;
}

} // namespace

class TestQuestionnaireSummary : public QObject {
    Q_OBJECT
private slots:
    void byHand();
    void contentValidityKappa();
    void wordsUntouched();
    void degenerate();
};

void TestQuestionnaireSummary::byHand() {
    Questionnaire form;
    form.items = {likert("looks_real", 5, "face"), likert("feels_real", 5, "face"),
                  likert("relevant", 4, "content")};
    const std::vector<std::vector<double>> answers{{5, 4, 4}, {4, 3, 4}, {4, 2, 3},
                                                   {3, 4, 4}, {2, 5, 4}, {5, 4, 2}};
    std::vector<QuestionnaireReply> replies;
    for (const auto& row : answers)
        replies.push_back(
            {{{"looks_real", row[0]}, {"feels_real", row[1]}, {"relevant", row[2]}}, {}, row[0] + 10.0});
    const QuestionnaireSummary s = summariseQuestionnaire(form, replies);
    QCOMPARE(s.likert[0].counts, (std::vector<int>{0, 1, 1, 2, 2}));
    QVERIFY(s.likert[0].median == 4.0 && s.likert[0].lowerQuartile == 3.25 &&
            s.likert[0].upperQuartile == 4.75);
    QVERIFY(std::abs(s.likert[0].agreement - 4.0 / 6.0) < 1e-12);
    // Wilson, 4 of 6: (p + z²/2n ± z√(pq/n + z²/4n²))/(1 + z²/n), z = 1.96: 0.300..0.903
    QVERIFY(std::abs(s.likert[0].agreementLow - 0.3000) < 5e-4 &&
            std::abs(s.likert[0].agreementHigh - 0.9032) < 5e-4);
    QVERIFY(std::abs(s.likert[0].withPerformance.tau - 1.0) < 1e-12);
    QVERIFY(std::abs(s.likert[2].contentValidityIndex - 5.0 / 6.0) < 1e-12);
    QVERIFY(s.constructs.size() == 2 && s.constructs[0].construct == "face" && s.constructs[0].items == 2 &&
            s.constructs[0].answers == 12);
    QVERIFY(std::abs(s.constructs[0].agreement - 8.0 / 12.0) < 1e-12 && s.constructs[0].median == 4.0);
    QVERIFY(std::abs(s.constructs[1].contentValidityAverage - 5.0 / 6.0) < 1e-12 &&
            s.constructs[1].contentValidityUniversal == 0.0);
}

/// Polit, Beck & Owen (2007), table 4: kappa of I-CVI by number of experts.
void TestQuestionnaireSummary::contentValidityKappa() {
    struct Row {
        int experts, agree;
        double kappa;
    };
    PublishedLine line("Polit, Beck & Owen 2007, modified kappa of I-CVI");
    for (const Row& row :
         {Row{3, 3, 1.00}, Row{3, 2, 0.47}, Row{4, 3, 0.67}, Row{5, 4, 0.76}, Row{6, 5, 0.81},
          Row{7, 6, 0.85}, Row{8, 7, 0.88}, Row{9, 8, 0.89}, Row{8, 6, 0.72}, Row{9, 7, 0.76}}) {
        Questionnaire form;
        form.items = {likert("item", 4, "content")};
        std::vector<QuestionnaireReply> replies;
        for (int i = 0; i < row.experts; ++i)
            replies.push_back({{{"item", i < row.agree ? 4.0 : 2.0}}, {}});
        line.compare(summariseQuestionnaire(form, replies).likert[0].contentValidityKappa, row.kappa,
                     0.0101); // two digits, from rounded steps
    }
    QVERIFY(line.holds());
}

void TestQuestionnaireSummary::wordsUntouched() {
    Questionnaire form;
    QuestionnaireItem words;
    words.id = "remarks";
    words.kind = QuestionnaireItem::Kind::text;
    QuestionnaireItem choice;
    choice.id = "hand";
    choice.kind = QuestionnaireItem::Kind::choice;
    choice.choices.resize(2);
    QuestionnaireItem number;
    number.id = "years";
    number.kind = QuestionnaireItem::Kind::number;
    form.items = {words, choice, number};
    const std::string odd = "  \"Tissue\" felt\n too stiff; <b>β</b>, \xF0\x9F\x91\x8D ";
    const QuestionnaireSummary s =
        summariseQuestionnaire(form, {{{{"hand", 1}, {"years", 4}}, {{"remarks", odd}}},
                                      {{{"hand", 0}, {"years", 10}}, {{"remarks", ""}}},
                                      {{{"hand", 7}}, {}}});
    QVERIFY(s.texts[0].answers == std::vector<std::string>{odd});
    QCOMPARE(s.numbers[0].choiceCounts, (std::vector<int>{1, 1}));
    QVERIFY(s.numbers[1].answered == 2 && s.numbers[1].mean == 7.0 && s.numbers[1].median == 7.0);
}

void TestQuestionnaireSummary::degenerate() {
    Questionnaire form;
    form.items = {likert("a", 5, "face"), likert("b", 0, "face"), likert("c", -4, "")};
    const QuestionnaireSummary none = summariseQuestionnaire(form, {});
    QVERIFY(none.warnings.front().starts_with("no_replies: ") && std::isnan(none.likert[0].median) &&
            std::isnan(none.constructs[0].agreement));
    const QuestionnaireSummary bad = summariseQuestionnaire(form, {{{{"a", 6}, {"b", 1}}, {}},
                                                                   {{{"a", 2.5}}, {}},
                                                                   {{{"a", std::nan("")}}, {}},
                                                                   {{{"a", -HUGE_VAL}}, {}},
                                                                   {{{"a", 0}}, {}}});
    QVERIFY(bad.likert[0].answered == 0 && bad.likert[0].missing == 5);
    QVERIFY(summariseQuestionnaire({}, {{}}).likert.empty());
    const QuestionnaireSummary one = summariseQuestionnaire(form, {{{{"a", 5}}, {}}});
    QVERIFY(one.likert[0].median == 5.0 && one.likert[0].agreement == 1.0 &&
            std::isnan(one.likert[0].withPerformance.tau));
}

QTEST_APPLESS_MAIN(TestQuestionnaireSummary)
#include "test_questionnaire_summary.moc"
