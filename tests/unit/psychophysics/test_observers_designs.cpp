// SPDX-License-Identifier: GPL-3.0-or-later
// Simulated observers, orders of conditions, and what planning says.
#include "psychophysics/designs/latin_square.h"
#include "psychophysics/designs/williams.h"
#include "psychophysics/observers/simulated_observer.h"
#include "psychophysics/observers/thurstone.h"
#include "psychophysics/planning/fisher_information.h"
#include "psychophysics/planning/study_plan.h"

#include <QtTest>
#include <cmath>
#include <map>
#include <set>

using namespace chiron::psychophysics;

class TestObserversDesigns : public QObject {
    Q_OBJECT
private slots:
    void observerText();
    void rankProbabilitiesHold();
    void answersFollowTheModel();
    void williams();
    void latin();
    void planningTable();
    void powerOfATTest();
};

void TestObserversDesigns::observerText() {
    const auto spec = parseObserver("weber:0.12,lapse:0.02,bias:-0.5");
    QVERIFY(spec);
    QCOMPARE(spec->weber, 0.12);
    QCOMPARE(spec->lapse, 0.02);
    QCOMPARE(spec->bias, -0.5);
    QVERIFY(std::abs(sigmaOf(*spec) - std::log10(1.12) / 0.9538725524) < 1e-10);
    const auto again = parseObserver(chiron::psychophysics::observerText(*spec));
    QVERIFY(again && again->weber == spec->weber && again->bias == spec->bias);
    const auto trainee = parseObserver("operator:expert");
    QVERIFY(trainee && trainee->trainee == "expert");
    QCOMPARE(parseObserver(chiron::psychophysics::observerText(*trainee))->trainee, trainee->trainee);
    const std::string longest(32, 'z');
    QVERIFY(parseObserver("operator:" + longest) && parseObserver("operator:a_z")->trainee == "a_z");
    QVERIFY(!parseObserver("operator:z" + longest));
    for (const char* wrong : {"operator:", "operator:two words", "operator:expert,operator:novice"})
        QVERIFY2(!parseObserver(wrong), wrong);
    for (const char* wrong : {"", "weber", "weber:", "weber:x", "weber:0", "weber:-1", "lapse:1.5",
                              "weber:0.1,", "weber:0.1,weber:0.2", "speed:1", "weber:nan", "weber:0.1 "})
        QVERIFY2(!parseObserver(wrong), wrong);
}

void TestObserversDesigns::rankProbabilitiesHold() {
    for (const double d : {0.0, 0.3, 1.0, 2.1, 5.0, 30.0}) {
        const auto p = rankProbabilities(d);
        double sum = 0.0;
        for (const double share : p)
            sum += share;
        QVERIFY(std::abs(sum - 1.0) < 1e-12);
        QVERIFY(p[1] == p[2] && p[3] == p[4]);
    }
    for (const double share : rankProbabilities(0.0))
        QVERIFY(std::abs(share - 1.0 / 6.0) < 1e-12);
    QVERIFY(rankProbabilities(30.0)[0] > 1.0 - 1e-12);
    QVERIFY(std::abs(rankProbabilities(1.0, 1.0)[5] - 1.0 / 6.0) < 1e-12);
}

/// 20,000 simulated answers against the model, within five standard errors.
void TestObserversDesigns::answersFollowTheModel() {
    constexpr int kAnswers = 20'000;
    SimulatedObserver observer({.weber = 0.1, .lapse = 0.1}, 1);
    const double d = observer.sigma();
    std::map<int, int> outcomes;
    for (int i = 0; i < kAnswers; ++i) {
        const int arrangement = i % 6;
        std::vector<double> places;
        for (const int multiple : arrangements(Task::rank3)[static_cast<std::size_t>(arrangement)])
            places.push_back(multiple * d);
        ++outcomes[outcomeOf(Task::rank3, arrangement, observer.answer(Task::rank3, places))];
    }
    const auto p = rankProbabilities(1.0, 0.1);
    for (int r = 0; r < 6; ++r) {
        const double expected = p[static_cast<std::size_t>(r)];
        QVERIFY(std::abs(outcomes[r] / double(kAnswers) - expected) <
                5.0 * std::sqrt(expected * (1.0 - expected) / kAnswers));
    }
    SimulatedObserver two({.weber = 0.2}, 2);
    int right = 0;
    for (int i = 0; i < kAnswers; ++i)
        right += two.answer(Task::twoAfc, {0.0, std::log10(1.2)});
    QVERIFY(std::abs(right / double(kAnswers) - 0.75) <
            5.0 * std::sqrt(0.75 * 0.25 / kAnswers)); // what a Weber fraction means
}

void TestObserversDesigns::williams() {
    for (int n = 1; n <= 9; ++n) {
        const auto rows = williamsDesign(n);
        const int expectedRows = n % 2 == 0 || n == 1 ? n : 2 * n;
        QCOMPARE(static_cast<int>(rows.size()), expectedRows);
        std::map<std::pair<int, int>, int> periods, follows;
        for (const auto& row : rows) {
            QCOMPARE(std::set<int>(row.begin(), row.end()).size(), static_cast<std::size_t>(n));
            for (std::size_t i = 0; i < row.size(); ++i) {
                ++periods[{static_cast<int>(i), row[i]}];
                if (i > 0)
                    ++follows[{row[i - 1], row[i]}];
            }
        }
        for (const auto& [key, count] : periods)
            QCOMPARE(count, expectedRows / n);
        QCOMPARE(static_cast<int>(follows.size()), n * (n - 1));
        for (const auto& [key, count] : follows)
            QCOMPARE(count, expectedRows / n);
    }
    QVERIFY(williamsDesign(0).empty());
}

void TestObserversDesigns::latin() {
    const auto square = latinSquare(6, 3);
    for (int place = 0; place < 6; ++place) {
        std::set<int> names;
        for (const auto& row : square)
            names.insert(row[static_cast<std::size_t>(place)]);
        QCOMPARE(names.size(), std::size_t(6));
    }
    QVERIFY(latinSquare(6, 3) == square && latinSquare(6, 4) != square);
    for (const OrderDesign design :
         {OrderDesign::fixed, OrderDesign::random, OrderDesign::latinSquare, OrderDesign::williams})
        for (int row = 0; row < 20; ++row) {
            const auto order = orderFor(design, 5, row, 1);
            QCOMPARE(std::set<int>(order.begin(), order.end()).size(), std::size_t(5));
        }
    QVERIFY(orderFor(OrderDesign::fixed, 3, 7, 1) == (std::vector<int>{0, 1, 2}));
}

/// The table of the design pages: best spacing, information and trials for 10 % of the JND, with 2 % lapses.
void TestObserversDesigns::planningTable() {
    const struct {
        const char* name;
        Task task;
        bool allCorrect;
        double spacing, information;
        int trials;
    } rows[] = {{"2AFC", Task::twoAfc, false, 2.05, 0.52, 192},
                {"3AFC", Task::threeAfc, false, 2.2, 0.86, 117},
                {"triangle oddity", Task::oddity, false, 3.55, 1.16, 86},
                {"rank 3, all-correct scoring", Task::rank3, true, 2.0, 1.15, 87},
                {"rank 3, six outcomes", Task::rank3, false, 2.1, 1.17, 86}};
    for (const auto& row : rows) {
        const BestSpacing best = bestSpacing(row.task, 0.02, row.allCorrect);
        qInfo("planning: %s: D/sigma %.2f, information %.3f, %.0f trials", row.name, best.spacing,
              best.information, best.trialsFor10Percent);
        QVERIFY(std::abs(best.spacing - row.spacing) < 0.08);
        QVERIFY(std::abs(best.information - row.information) < 0.011);
        QVERIFY(std::abs(best.trialsFor10Percent - row.trials) < 2.0);
    }
}

/// Two-sided paired t-tests at 5 %, effect sizes 0.5 and 0.8: n = 34 and 15 have 80 % (Cohen's tables,
/// G*Power).
void TestObserversDesigns::powerOfATTest() {
    PowerQuestion question;
    question.runSdLog10 = 0.0;
    question.effectSdLog10 = 1.0;
    question.differenceLog10 = 0.5;
    QCOMPARE(participantsFor(question, 0.8), 34);
    question.differenceLog10 = 0.8;
    QCOMPARE(participantsFor(question, 0.8), 15);
    question.paired = false;
    question.personSdLog10 = 1.0;
    question.differenceLog10 = 0.5;
    QCOMPARE(participantsFor(question, 0.8), 64);
    question.differenceLog10 = 0.0;
    QVERIFY(std::abs(power(question) - 0.05) < 1e-3);
    QCOMPARE(participantsFor(question, 0.8), -1); // no number of people finds what is not there
}

QTEST_APPLESS_MAIN(TestObserversDesigns)
#include "test_observers_designs.moc"
