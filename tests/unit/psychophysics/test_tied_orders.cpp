// SPDX-License-Identifier: GPL-3.0-or-later
// Rankings with ties: their probabilities against the model without ties, brute force and simulated
// observers; QUEST+ over them.
#include "procedure_runs.h"
#include "psychophysics/observers/simulated_observer.h"
#include "psychophysics/observers/thurstone.h"
#include "psychophysics/observers/tied_orders.h"
#include "psychophysics/planning/fisher_information.h"
#include "psychophysics/procedures/procedure_spec.h"

#include <QtTest>
#include <cmath>
#include <numeric>

using namespace chiron::psychophysics;

namespace {

/// What is said of three percepts, by the rule alone.
int said(const std::array<double, 3>& felt, double tie) {
    std::array<double, 3> sorted = felt;
    std::sort(sorted.begin(), sorted.end());
    Ranking ranks{};
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t k = 1; k < 3; ++k)
            ranks[i] = static_cast<std::int8_t>(
                ranks[i] + (felt[i] >= sorted[k] && sorted[k] - sorted[k - 1] >= tie ? 1 : 0));
    return rankingOf(ranks);
}

/// Midpoints of a cube of percepts: good to about the step.
RankingProbabilities bruteForce(double d, double tie) {
    constexpr double kStep = 0.06;
    constexpr int kReach = 83; // 5 sd
    RankingProbabilities p{};
    for (int a = -kReach; a < kReach; ++a)
        for (int b = -kReach; b < kReach; ++b)
            for (int c = -kReach; c < kReach; ++c) {
                const double x = (a + 0.5) * kStep, y = (b + 0.5) * kStep, z = (c + 0.5) * kStep;
                p[static_cast<std::size_t>(said({x, y + d, z + 2.0 * d}, tie))] +=
                    std::exp(-0.5 * (x * x + y * y + z * z));
            }
    const double total = std::accumulate(p.begin(), p.end(), 0.0);
    for (double& value : p)
        value /= total;
    return p;
}

Rank3Spec tied() {
    Rank3Spec spec;
    spec.differences = {0.01, 0.02, 0.04, 0.08, 0.16};
    spec.allowTies = true;
    return spec;
}

} // namespace

class TestTiedOrders : public QObject {
    Q_OBJECT
private slots:
    void withoutTies();
    void limits();
    void againstBruteForce();
    void tableHolds();
    void observerFollows();
    void rankingsAreWhole();
    void procedureOfThirteen();
    void findsSigma();
    void worthOfTies();
};

void TestTiedOrders::withoutTies() {
    for (const double d : {-1.5, 0.0, 0.4, 1.0, 3.0}) {
        const auto strict = rankProbabilities(d);
        const auto p = tiedRankProbabilities(d, 0.0);
        for (std::size_t i = 0; i < p.size(); ++i)
            QVERIFY(std::abs(p[i] - (i < strict.size() ? strict[i] : 0.0)) < 1e-13);
    }
}

void TestTiedOrders::limits() {
    for (const double tie : {0.2, 1.0, 4.0})
        for (const double d : {-3.0, 0.0, 0.7, 2.5, 40.0}) {
            const auto p = tiedRankProbabilities(d, tie);
            QVERIFY(std::abs(std::accumulate(p.begin(), p.end(), 0.0) - 1.0) < 1e-13);
            QVERIFY(std::abs(p[0] - rightOrderProbability(d, tie)) < 1e-13);
            QVERIFY(*std::min_element(p.begin(), p.end()) >= 0.0);
        }
    const auto same = tiedRankProbabilities(0.0, 0.7); // nothing differs: all of a kind alike
    for (std::size_t i = 1; i < 6; ++i)
        QVERIFY(std::abs(same[i] - same[0]) < 1e-14);
    for (std::size_t i = 7; i < 12; ++i)
        QVERIFY(std::abs(same[i] - same[6]) < 1e-14);
    QVERIFY(tiedRankProbabilities(40.0, 1.0)[0] > 1.0 - 1e-12);
    QVERIFY(tiedRankProbabilities(0.5, 40.0)[12] > 1.0 - 1e-12);
}

void TestTiedOrders::againstBruteForce() {
    const auto p = tiedRankProbabilities(
        0.8, 0.6); // a threshold at a multiple of the grid's step: no percept lies on an edge
    const auto rough = bruteForce(0.8, 0.6);
    for (std::size_t i = 0; i < p.size(); ++i)
        QVERIFY2(std::abs(p[i] - rough[i]) < 0.01,
                 qPrintable(QStringLiteral("%1: %2, %3").arg(i).arg(p[i]).arg(rough[i])));
}

void TestTiedOrders::tableHolds() {
    double worst = 0.0;
    for (const double tie : {0.1, 0.5, 1.5, 3.0}) {
        const TiedOrderTable table(tie);
        for (double d = -13.0; d < 18.0; d += 0.0373) {
            const auto exact = tiedRankProbabilities(d, tie);
            const auto read = table.at(d);
            for (std::size_t i = 0; i < exact.size(); ++i)
                worst = std::max(worst, std::abs(exact[i] - read[i]));
        }
    }
    qInfo("worst difference of the table %.2g", worst);
    QVERIFY(worst < 1e-6);
    QVERIFY(std::isnan(TiedOrderTable(0.5).at(std::nan(""))[3]));
}

/// 30,000 simulated answers at every arrangement against the model, within five standard errors.
void TestTiedOrders::observerFollows() {
    constexpr int kAnswers = 30'000;
    SimulatedObserver observer({.weber = 0.1, .lapse = 0.1, .ties = 0.7}, 1);
    std::array<int, kRankings> counts{};
    for (int i = 0; i < kAnswers; ++i) {
        const int arrangement = i % 6;
        std::vector<double> places;
        for (const int multiple : arrangements(Task::rank3Ties)[static_cast<std::size_t>(arrangement)])
            places.push_back(multiple * 0.9 * observer.sigma());
        ++counts[static_cast<std::size_t>(
            outcomeOf(Task::rank3Ties, arrangement, observer.answer(Task::rank3Ties, places)))];
    }
    const auto p = tiedRankProbabilities(0.9, 0.7);
    for (std::size_t r = 0; r < p.size(); ++r) {
        const double expected = 0.9 * p[r] + 0.1 / kRankings;
        QVERIFY(std::abs(counts[r] / double(kAnswers) - expected) <
                5.0 * std::sqrt(expected * (1.0 - expected) / kAnswers));
    }
}

void TestTiedOrders::rankingsAreWhole() {
    for (int i = 0; i < kRankings; ++i)
        QCOMPARE(rankingOf(rankings()[static_cast<std::size_t>(i)]), i);
    QCOMPARE(rankingOf({0, 2, 2}), -1); // a rank left out
    for (int arrangement = 0; arrangement < 6; ++arrangement) {
        QCOMPARE(outcomeOf(Task::rank3Ties, arrangement, correctAnswer(Task::rank3Ties, arrangement)), 0);
        QCOMPARE(outcomeOf(Task::rank3Ties, arrangement, 12), 12);
        for (int answer = 0; answer < 6; ++answer)
            QCOMPARE(outcomeOf(Task::rank3Ties, arrangement, answer),
                     outcomeOf(Task::rank3, arrangement, answer));
    }
    QCOMPARE(outcomeOf(Task::rank3, 0, 6), -1); // a tie where none may be said
    QCOMPARE(outcomes(Task::rank3Ties), 13);
}

void TestTiedOrders::procedureOfThirteen() {
    auto procedure = makeProcedure(tied(), 1);
    QVERIFY(procedure);
    QCOMPARE((*procedure)->outcomes(), 13);
    QCOMPARE((*procedure)->id(), std::string_view("rank3_quest_plus_ties@1"));
    QVERIFY((*procedure)->record(12, (*procedure)->next().stimulus));
    QVERIFY(!(*procedure)->record(13, (*procedure)->next().stimulus));
    Rank3Spec none = tied();
    none.tieThresholds.clear();
    QVERIFY(!makeProcedure(none, 1));
    none.tieThresholds = {0.0};
    QVERIFY(!makeProcedure(none, 1));
}

/// 60 runs of 60 trials by observers whose threshold of ties the grid does not hold: sd of log10 JND as
/// without ties, no bias.
void TestTiedOrders::findsSigma() {
    constexpr int kRuns = 60;
    double sum = 0.0, squares = 0.0;
    for (int run = 0; run < kRuns; ++run) {
        Rank3Spec spec = tied();
        spec.stop = {.trials = 60};
        auto procedure = makeProcedure(spec, 1);
        SimulatedObserver observer({.weber = 0.12, .lapse = 0.02, .ties = 0.7},
                                   static_cast<std::uint64_t>(run + 1));
        while (!(*procedure)->done()) {
            const Stimulus x = (*procedure)->next().stimulus;
            const int answer = observer.answer(Task::rank3Ties, {0.0, x[0], 2.0 * x[0]});
            QVERIFY((*procedure)->record(outcomeOf(Task::rank3Ties, 0, answer), x));
        }
        const double error = (*procedure)->estimate().parameters[0].mean - std::log10(observer.sigma());
        sum += error;
        squares += error * error;
    }
    const double bias = sum / kRuns, sd = std::sqrt(squares / kRuns - bias * bias);
    qInfo("rank-3 QUEST+ with ties, 60 trials: bias %+.3f, sd %.3f log10", bias, sd);
    QVERIFY(sd < 0.075); // without ties 0.057
    QVERIFY(std::abs(bias) < 0.02 + 3.0 * sd / std::sqrt(double(kRuns)));
}

/// Planned precision is what simulated runs have (test_plan_coverage: 0.052 at 64 trials, best spacing or
/// not); always tied says nothing.
void TestTiedOrders::worthOfTies() {
    const double strict = bestSpacing(Task::rank3, 0.02).information;
    const double ties = bestSpacing(Task::rank3Ties, 0.02, false, 0.5).information;
    qInfo("information a trial: %.3f without ties, %.3f with", strict, ties);
    QVERIFY(ties > 0.8 * strict && ties < 1.5 * strict);
    QVERIFY(std::abs(fisherInformation(Task::rank3Ties, 2.0, 0.0, false, 1e-6) -
                     fisherInformation(Task::rank3, 2.0, 0.0)) < 0.01);
    QVERIFY(fisherInformation(Task::rank3Ties, 1.0, 0.02, false, 60.0) < 1e-6);
}

QTEST_APPLESS_MAIN(TestTiedOrders)
#include "test_tied_orders.moc"
