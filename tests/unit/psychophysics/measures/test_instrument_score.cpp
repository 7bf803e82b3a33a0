// SPDX-License-Identifier: GPL-3.0-or-later
// Scores of instruments by their published rules.
#include "psychophysics/measures/instrument_score.h"

#include <QtTest>
#include <cmath>

using namespace chiron::psychophysics;

namespace {

QuestionnaireItem likert(const std::string& id, int scale) {
    QuestionnaireItem item;
    item.id = id;
    item.text["en"] = id;
    item.scale = scale;
    return item;
}

QuestionnaireItem choice(const std::string& id, int choices) {
    QuestionnaireItem item = likert(id, 5);
    item.kind = QuestionnaireItem::Kind::choice;
    item.choices.resize(static_cast<std::size_t>(choices));
    return item;
}

Questionnaire sus() {
    Questionnaire out;
    out.score = "sus";
    for (int i = 1; i <= 10; ++i)
        out.items.push_back(likert("s" + std::to_string(i), 5));
    return out;
}

constexpr std::array<const char*, 6> kScales{"mental",      "physical", "temporal",
                                             "performance", "effort",   "frustration"};

Questionnaire tlx(bool weighted) {
    Questionnaire out;
    out.score = weighted ? "nasa_tlx_weighted" : "nasa_tlx_raw";
    for (const char* scale : kScales)
        out.items.push_back(likert(scale, 21));
    for (std::size_t a = 0; weighted && a < kScales.size(); ++a)
        for (std::size_t b = a + 1; b < kScales.size(); ++b)
            out.items.push_back(choice(std::string("pair_") + kScales[a] + "_" + kScales[b], 2));
    return out;
}

Questionnaire hands() {
    Questionnaire out;
    out.score = "laterality_quotient";
    for (int i = 1; i <= 10; ++i)
        out.items.push_back(choice("a" + std::to_string(i), 5));
    return out;
}

QuestionnaireReply all(const Questionnaire& questionnaire, double answer) {
    QuestionnaireReply reply;
    for (const QuestionnaireItem& item : questionnaire.items)
        reply.numbers[item.id] = answer;
    return reply;
}

} // namespace

class TestInstrumentScore : public QObject {
    Q_OBJECT
private slots:
    /// The completed form in Brooke (1996): contributions 4 1 1 4 1 2 1 1 4 3, their sum 22, SUS 55.
    void susOfThePublishedForm() {
        const std::array<double, 10> answers{5, 4, 2, 1, 2, 3, 2, 4, 5, 2};
        QuestionnaireReply reply;
        for (std::size_t i = 0; i < answers.size(); ++i)
            reply.numbers["s" + std::to_string(i + 1)] = answers[i];
        const auto scores = instrumentScores(sus(), reply);
        QCOMPARE(scores.size(), std::size_t(1));
        QCOMPARE(scores[0].id, std::string("sus"));
        QCOMPARE(scores[0].value, 55.0);
        QCOMPARE(instrumentScores(sus(), all(sus(), 3)).front().value, 50.0);
        for (const bool best : {true, false}) {
            QuestionnaireReply end;
            for (int i = 1; i <= 10; ++i)
                end.numbers["s" + std::to_string(i)] = (i % 2 == 1) == best ? 5 : 1;
            QCOMPARE(instrumentScores(sus(), end).front().value, best ? 100.0 : 0.0);
        }
    }

    void aMissingAnswerIsNoScore() {
        auto reply = all(sus(), 3);
        reply.numbers.erase("s4");
        QVERIFY(std::isnan(instrumentScores(sus(), reply).front().value));
        auto workload = all(tlx(true), 1);
        workload.numbers.erase("pair_mental_effort");
        QVERIFY(std::isnan(instrumentScores(tlx(true), workload).front().value));
    }

    /// Steps 1 to 21 are 0 to 100 in fives; the raw index is their mean (Hart 2006).
    void rawWorkloadIsTheMean() {
        QCOMPARE(instrumentScores(tlx(false), all(tlx(false), 1)).front().value, 0.0);
        QCOMPARE(instrumentScores(tlx(false), all(tlx(false), 21)).front().value, 100.0);
        QuestionnaireReply reply;
        const std::array<double, 6> ratings{30, 15, 60, 40, 40, 30};
        for (std::size_t i = 0; i < ratings.size(); ++i)
            reply.numbers[kScales[i]] = ratings[i] / 5.0 + 1.0;
        const auto scores = instrumentScores(tlx(false), reply);
        QVERIFY(std::abs(scores.front().value - 215.0 / 6.0) < 1e-12);
        QCOMPARE(scores[3].id, std::string("temporal"));
        QCOMPARE(scores[3].value, 60.0);
    }

    /// Each scale counts as often as it was chosen of its five pairs: weights 3 0 5 1 3 3, ratings 30 15 60
    /// 40 40 30, 640 of 15 (Hart & Staveland 1988).
    void weightedWorkloadCountsThePairs() {
        const std::array<double, 6> ratings{30, 15, 60, 40, 40, 30};
        const std::array<int, 6> rank{
            3, 0, 5, 1, 4, 2}; // a strict order gives 3 0 5 1 4 2; one pair turned gives 3 and 3
        QuestionnaireReply reply;
        for (std::size_t i = 0; i < ratings.size(); ++i)
            reply.numbers[kScales[i]] = ratings[i] / 5.0 + 1.0;
        for (std::size_t a = 0; a < kScales.size(); ++a)
            for (std::size_t b = a + 1; b < kScales.size(); ++b)
                reply.numbers[std::string("pair_") + kScales[a] + "_" + kScales[b]] =
                    rank[a] > rank[b] ? 0 : 1;
        reply.numbers["pair_effort_frustration"] = 1;
        QVERIFY(std::abs(instrumentScores(tlx(true), reply).front().value - 640.0 / 15.0) < 1e-12);
    }

    /// 100 (R - L)/(R + L) (Oldfield 1971).
    void lateralityFromLeftToRight() {
        QCOMPARE(instrumentScores(hands(), all(hands(), 4)).front().value, 100.0);
        QCOMPARE(instrumentScores(hands(), all(hands(), 3)).front().value,
                 100.0); // all of it right, if weakly
        QCOMPARE(instrumentScores(hands(), all(hands(), 0)).front().value, -100.0);
        QCOMPARE(instrumentScores(hands(), all(hands(), 2)).front().value, 0.0);
        auto reply = all(hands(), 4); // nine strongly right, one either: (19 - 1)/(19 + 1)
        reply.numbers["a1"] = 2;
        QVERIFY(std::abs(instrumentScores(hands(), reply).front().value - 90.0) < 1e-12);
        Questionnaire partly = hands();
        partly.items[0].required = false; // nobody does all of it
        reply.numbers.erase("a1");
        QCOMPARE(instrumentScores(partly, reply).front().value, 100.0);
        QVERIFY(std::isnan(instrumentScores(hands(), reply).front().value));
    }

    void whatCannotBeScoredIsSaid() {
        Questionnaire other = sus();
        other.items.pop_back();
        QVERIFY(!scoreFault(other).empty());
        QVERIFY(instrumentScores(other, all(other, 3)).empty());
        other = sus();
        other.score = "no_such_rule";
        QVERIFY(!scoreFault(other).empty());
        other.score.clear();
        QVERIFY(scoreFault(other).empty() && instrumentScores(other, all(other, 3)).empty());
        Questionnaire pairs = tlx(true);
        pairs.items.back().id = "pair_effort_boredom";
        QVERIFY(!scoreFault(pairs).empty());
        QVERIFY(scoreFault(tlx(true)).empty() && scoreFault(tlx(false)).empty() &&
                scoreFault(hands()).empty());
    }
};

QTEST_APPLESS_MAIN(TestInstrumentScore)
#include "test_instrument_score.moc"
