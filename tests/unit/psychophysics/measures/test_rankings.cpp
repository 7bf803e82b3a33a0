// SPDX-License-Identifier: GPL-3.0-or-later
// Agreement, trend and worths of rankings against published numbers and closed forms.
#include "core/normal_distribution.h"
#include "core/random.h"
#include "psychophysics/measures/agreement.h"
#include "psychophysics/measures/page_trend.h"
#include "psychophysics/measures/pairwise_ranking.h"
#include "tests/unit/psychophysics/measures/published_line.h"

#include <numeric>

using namespace chiron::psychophysics;

class TestRankings : public QObject {
    Q_OBJECT
private slots:
    void choix();
    void kendallPublished();
    void kendallExactTables();
    void kendallDegenerate();
    void tauPublished();
    void tauAgainstEnumeration();
    void pageTables();
    void pageLargeAgreesWithNormal();
    void wholeOrders();
    void worthClosedForms();
    void worthErrors();
    void worthRefusals();
    void tiedPairs();
    void thurstone();
};

/// choix, tests/data (published_small_checks.json, choix): maximum likelihood log strengths, mean 0. The
/// published rankings-2 are short of their maximum (gradient 2e-5), so that they hold to 5e-5 only; ours must
/// be the likelier.
void TestRankings::choix() {
    PublishedLine line("published_small_checks.json choix");
    const auto check = [&](int objects, const std::vector<Selection>& data,
                           const std::vector<double>& published, double tolerance = 1e-6) {
        const WorthEstimate estimate = fitPlackettLuce(objects, data);
        for (std::size_t i = 0; i < published.size(); ++i)
            line.compare(estimate.logWorth[i], published[i], tolerance);
    };
    const auto orders = [](const std::vector<std::vector<int>>& lists) {
        std::vector<Selection> all;
        for (const auto& list : lists)
            for (const Selection& selection : selectionsOf(list))
                all.push_back(selection);
        return all;
    };
    check(3, {{0, {1}}, {1, {2}}, {2, {0}}}, {0.0, 0.0, 0.0});                            // pairwise-1
    check(3, {{0, {1}}, {0, {1}}, {1, {2}}, {2, {0}}}, {0.419617624, -0.419617624, 0.0}); // pairwise-2
    check(3, orders({{0, 1, 2}, {1, 2, 0}, {2, 0, 1}}), {0.0, 0.0, 0.0});                 // rankings-1
    check(4, orders({{0, 1, 2}, {3, 2, 0}, {1, 3}}), {-0.44328117, 0.69506219, -0.67061442, 0.4188334},
          5e-5);                                                                        // rankings-2
    check(3, {{0, {1, 2}}, {1, {0, 2}}, {2, {0, 1}}}, {0.0, 0.0, 0.0});                 // top1-1
    check(3, {{0, {1}}, {1, {2}}, {2, {0, 1}}}, {0.16040395, -0.32080789, 0.16040394}); // top1-2
    QVERIFY(line.holds());
    const auto likelihood = [&](const std::vector<double>& logs) {
        double sum = 0.0;
        for (const Selection& selection : orders({{0, 1, 2}, {3, 2, 0}, {1, 3}})) {
            double all = std::exp(logs[static_cast<std::size_t>(selection.winner)]);
            for (const int loser : selection.losers)
                all += std::exp(logs[static_cast<std::size_t>(loser)]);
            sum += logs[static_cast<std::size_t>(selection.winner)] - std::log(all);
        }
        return sum;
    };
    const WorthEstimate ours = fitPlackettLuce(4, orders({{0, 1, 2}, {3, 2, 0}, {1, 3}}));
    QVERIFY(likelihood(ours.logWorth) > likelihood({-0.44328117, 0.69506219, -0.67061442, 0.4188334}));
    QVERIFY(std::abs(likelihood(ours.logWorth) - ours.logLikelihood) < 1e-12);
}

/// Siegel & Castellan (1988): three executives rank six applicants, W = .16; and a table with ties worked by
/// hand.
void TestRankings::kendallPublished() {
    PublishedLine line("Kendall's W: Siegel & Castellan 1988, and by hand with ties");
    const Concordance applicants = kendallW({{1, 6, 3, 2, 5, 4}, {1, 5, 6, 4, 2, 3}, {6, 3, 2, 5, 4, 1}});
    line.compare(applicants.w, 306.0 / 1890.0, 1e-8);
    line.compare(applicants.chiSquare, 3.0 * 5.0 * 306.0 / 1890.0, 1e-8);
    const Concordance tied = kendallW({{1.0, 2.5, 2.5, 4.0}, {1.0, 2.0, 3.0, 4.0}, {2.0, 1.0, 3.5, 3.5}});
    line.compare(tied.w, 414.0 / 504.0, 1e-8);
    const Concordance same = kendallW({{10, 20, 30}, {1, 2, 3}, {-5, 0, 5}, {7, 8, 9}});
    line.compare(same.w, 1.0, 1e-12);
    QVERIFY(line.holds());
}

/// Friedman's (1937) tables of the exact distribution (three objects, 3 and 4 judges; four objects, 2
/// judges).
void TestRankings::kendallExactTables() {
    PublishedLine line("Friedman 1937, exact probabilities of rank sums");
    line.compare(kendallW({{1, 2, 3}, {1, 2, 3}, {1, 2, 3}}).exactP, 1.0 / 36.0, 1e-12);
    line.compare(kendallW({{1, 2, 3}, {1, 2, 3}, {1, 3, 2}}).exactP, 0.194, 5e-4);
    line.compare(kendallW({{1, 2, 3}, {1, 2, 3}, {1, 2, 3}, {1, 2, 3}}).exactP, 0.0046, 5e-5);
    line.compare(kendallW({{1, 2, 3}, {1, 2, 3}, {1, 2, 3}, {1, 3, 2}}).exactP, 0.042, 5e-4);
    line.compare(kendallW({{1, 2, 3, 4}, {1, 2, 3, 4}}).exactP, 1.0 / 24.0, 1e-12);
    line.compare(kendallW({{1, 2, 3, 4}, {1, 2, 4, 3}}).exactP, 0.167, 5e-4);
    QVERIFY(line.holds());
}

void TestRankings::kendallDegenerate() {
    QVERIFY(std::isnan(kendallW({}).w) && std::isnan(kendallW({{1, 2, 3}}).w) &&
            std::isnan(kendallW({{1}, {1}}).w));
    QVERIFY(std::isnan(kendallW({{1, 1, 1}, {2, 2, 2}}).w));
    const Concordance part = kendallW({{1, 2, 3}, {1, std::nan(""), 3}, {1, 2, 3}, {1, 2}, {1, HUGE_VAL, 2}});
    QVERIFY(part.judges == 2 && std::abs(part.w - 1.0) < 1e-12 &&
            part.warnings.front().starts_with("left_out: 3"));
    std::vector<std::vector<double>> many(400, std::vector<double>(30));
    for (std::size_t i = 0; i < many.size(); ++i)
        for (std::size_t j = 0; j < 30; ++j)
            many[i][j] = static_cast<double>((i * 7 + j * 13) % 31);
    QVERIFY(std::isnan(kendallW(many).exactP) && kendallW(many).w >= 0.0);
}

/// Hollander & Wolfe (1973), p. 187, lightness of canned tuna, as in R's cor.test: tau 0.4444, T = 26, p =
/// 0.1194.
void TestRankings::tauPublished() {
    PublishedLine line("Kendall's tau: Hollander & Wolfe 1973 (R, cor.test)");
    const RankCorrelation tuna = kendallTau({44.4, 45.9, 41.9, 53.3, 44.7, 44.1, 50.7, 45.2, 60.1},
                                            {2.6, 3.1, 2.5, 5.0, 3.6, 4.0, 5.2, 2.8, 3.8});
    line.compare(tuna.tau, 4.0 / 9.0, 1e-8);
    line.compare(tuna.pValue, 0.1194, 5e-5);
    QVERIFY(line.holds() && tuna.exact);
    QVERIFY(std::isnan(kendallTau({}, {}).tau) && std::isnan(kendallTau({1, 1, 1}, {1, 2, 3}).tau));
    QVERIFY(std::isnan(kendallTau({1, std::nan("")}, {1, 2}).tau));
}

void TestRankings::tauAgainstEnumeration() {
    const std::vector<double> x{1, 2, 3, 4, 5, 6};
    std::vector<double> y{2, 1, 4, 3, 6, 5};
    const RankCorrelation seen = kendallTau(x, y);
    std::vector<double> order{1, 2, 3, 4, 5, 6};
    double extreme = 0.0;
    double all = 0.0;
    do {
        all += 1.0;
        extreme += std::abs(kendallTau(x, order).tau) >= std::abs(seen.tau) - 1e-12 ? 1.0 : 0.0;
    } while (std::next_permutation(order.begin(), order.end()));
    QVERIFY(std::abs(seen.pValue - extreme / all) < 1e-12);
    // τ-b with ties: 4 concordant, 0 discordant of 6 pairs, one tie on each side: 4/√(5·5)
    const RankCorrelation tied = kendallTau({1, 1, 2, 3}, {1, 2, 3, 3});
    QVERIFY(std::abs(tied.tau - 0.8) < 1e-12 && tied.exact);
    std::vector<double> longer(300);
    std::iota(longer.begin(), longer.end(), 0.0);
    QVERIFY(kendallTau(longer, longer).pValue < 1e-12 && !kendallTau(longer, longer).exact);
}

/// Page (1963), table 2: the smallest L significant at 0.05, 0.01 and 0.001 for three and four objects.
void TestRankings::pageTables() {
    struct Row {
        int objects, judges;
        double l;
        double level;
    };
    const std::vector<Row> rows{
        {3, 2, 28, 0.05},   {3, 3, 41, 0.05},    {3, 3, 42, 0.01},  {3, 4, 54, 0.05},  {3, 4, 55, 0.01},
        {3, 4, 56, 0.001},  {3, 5, 66, 0.05},    {3, 5, 68, 0.01},  {3, 5, 70, 0.001}, {3, 10, 128, 0.05},
        {3, 10, 131, 0.01}, {3, 10, 134, 0.001}, {4, 2, 58, 0.05},  {4, 2, 60, 0.01},  {4, 3, 84, 0.05},
        {4, 3, 87, 0.01},   {4, 3, 89, 0.001},   {4, 5, 137, 0.05}, {4, 5, 141, 0.01}, {4, 5, 145, 0.001}};
    PublishedLine line("Page 1963, critical values of L");
    for (const Row& row : rows) {
        const auto tail = [&](double l) { return pageUpperTail(row.objects, row.judges, l); };
        const bool smallest = tail(row.l) <= row.level && tail(row.l - 1.0) > row.level;
        line.compare(smallest ? row.l : 0.0, row.l, 0.0);
    }
    QVERIFY(line.holds());
}

void TestRankings::pageLargeAgreesWithNormal() {
    chiron::core::Random random(3);
    std::vector<std::vector<double>> judges(60, std::vector<double>(4));
    for (auto& judge : judges)
        for (std::size_t j = 0; j < 4; ++j)
            judge[j] = 0.15 * static_cast<double>(j) + random.normal();
    const PageTrend trend = pageTrend(judges);
    qInfo("Page: L %.0f, expected %.0f, exact p %.5f, normal p %.5f", trend.l, trend.expected, trend.exactP,
          trend.normalP);
    QVERIFY(std::abs(trend.exactP - trend.normalP) < 0.01);
    QVERIFY(std::isnan(pageTrend({}).l) && std::isnan(pageTrend({{1, 1, 1}}).pValue) &&
            std::isnan(pageTrend({{2}}).pValue));
    QVERIFY(std::abs(pageTrend({{1, 1, 2}}).l - (1.5 + 3.0 + 9.0)) < 1e-12);
    judges.assign(3000, {1, 2, 3, 4, 5, 6, 8, 7, 9});
    QVERIFY(std::isnan(pageTrend(judges).exactP) && pageTrend(judges).pValue < 1e-10);
}

void TestRankings::wholeOrders() {
    const CompleteOrders orders = completeOrders(5, 12); // P(X ≥ 5), 1/6: 1 − pbinom(4, 12, 1/6)
    double p = 0.0;
    for (int k = 5; k <= 12; ++k)
        p += std::tgamma(13.0) / std::tgamma(k + 1.0) / std::tgamma(13.0 - k) * std::pow(1.0 / 6.0, k) *
             std::pow(5.0 / 6.0, 12 - k);
    QVERIFY(std::abs(orders.pValue - p) < 1e-12 && orders.low < orders.share && orders.share < orders.high);
    QVERIFY(std::isnan(completeOrders(0, 0).pValue) && std::isnan(completeOrders(4, 3).share));
}

void TestRankings::worthClosedForms() {
    const WorthEstimate two = fitPlackettLuce(2, {{0, {1}, 30.0}, {1, {0}, 10.0}});
    QVERIFY(std::abs(two.logWorth[0] - two.logWorth[1] - std::log(3.0)) < 1e-10);
    const double error = std::sqrt(1.0 / 30.0 + 1.0 / 10.0); // of the log odds
    QVERIFY(std::abs(2.0 * two.standardError[0] - error) < 1e-9);
    QVERIFY(std::abs(two.logLikelihood - (30.0 * std::log(0.75) + 10.0 * std::log(0.25))) < 1e-9);
    // Orders of three: the first places alone give γ when second places agree with Luce's axiom.
    std::vector<Selection> data;
    const std::vector<double> worth{0.5, 0.3, 0.2};
    std::vector<int> order{0, 1, 2};
    do {
        const double p = worth[static_cast<std::size_t>(order[0])] *
                         worth[static_cast<std::size_t>(order[1])] /
                         (1.0 - worth[static_cast<std::size_t>(order[0])]);
        for (const Selection& selection : selectionsOf(order, 1000.0 * p))
            data.push_back(selection);
    } while (std::next_permutation(order.begin(), order.end()));
    const WorthEstimate luce = fitPlackettLuce(3, data);
    for (std::size_t i = 0; i < 3; ++i)
        QVERIFY(std::abs(luce.logWorth[i] - luce.logWorth[0] - std::log(worth[i] / worth[0])) < 1e-8);
}

/// Standard errors are what repeated samples spread by.
void TestRankings::worthErrors() {
    chiron::core::Random random(9);
    const std::vector<double> logs{0.6, 0.1, -0.2, -0.5};
    double squares = 0.0;
    double claimed = 0.0;
    for (int run = 0; run < 150; ++run) {
        std::vector<Selection> data;
        for (int judge = 0; judge < 60; ++judge) {
            std::vector<std::pair<double, int>> felt; // Gumbel noise gives Plackett–Luce
            for (int i = 0; i < 4; ++i)
                felt.emplace_back(
                    -(logs[static_cast<std::size_t>(i)] - std::log(-std::log(random.uniform()))), i);
            std::sort(felt.begin(), felt.end());
            for (const Selection& selection :
                 selectionsOf({felt[0].second, felt[1].second, felt[2].second, felt[3].second}))
                data.push_back(selection);
        }
        const WorthEstimate estimate = fitPlackettLuce(4, data);
        squares += std::pow(estimate.logWorth[0] - 0.6, 2);
        claimed += std::pow(estimate.standardError[0], 2);
    }
    qInfo("Plackett-Luce: spread %.4f, claimed %.4f", std::sqrt(squares / 150), std::sqrt(claimed / 150));
    QVERIFY(std::abs(std::sqrt(squares / claimed) - 1.0) < 0.2);
}

void TestRankings::worthRefusals() {
    const std::vector<Selection> oneWay{{0, {1}}, {1, {2}}, {0, {2}}};
    const WorthEstimate refused = fitPlackettLuce(3, oneWay);
    QVERIFY(!refused.fitted && std::isnan(refused.logWorth[0]) &&
            refused.warnings.back().starts_with("not_connected: "));
    const WorthEstimate pulled = fitPlackettLuce(3, oneWay, {.regularisation = 0.1});
    QVERIFY(pulled.fitted && pulled.logWorth[0] > pulled.logWorth[1] &&
            pulled.logWorth[1] > pulled.logWorth[2]);
    QVERIFY(pulled.warnings.back().starts_with("regularised: "));
    QVERIFY(!fitPlackettLuce(3, {}).fitted && !fitPlackettLuce(0, {}).fitted &&
            !fitPlackettLuce(-2, {{0, {1}}}).fitted);
    QVERIFY(
        !fitPlackettLuce(2, {{0, {0}}, {5, {1}}, {0, {}}, {0, {1}, std::nan("")}, {0, {1}, -1.0}}).fitted);
    QVERIFY(!fitPlackettLuce(4, {{0, {1}}, {1, {0}}, {2, {3}}, {3, {2}}}).fitted); // two islands
}

/// Two objects: Davidson's worth ratio is wins to losses and ν = t/√(ab); Rao & Kupper's θ² =
/// (1−p)(1−q)/(pq).
void TestRankings::tiedPairs() {
    const std::vector<PairCount> counts{{0, 1, 40.0, 20.0, 15.0}};
    const TiedWorthEstimate davidson = fitTiedPairs(TieModel::davidson, 2, counts);
    QVERIFY(std::abs(davidson.logWorth[0] - davidson.logWorth[1] - std::log(2.0)) < 1e-5);
    QVERIFY(std::abs(davidson.tie - 15.0 / std::sqrt(800.0)) < 1e-5);
    const TiedWorthEstimate rao = fitTiedPairs(TieModel::raoKupper, 2, counts);
    const double p = 40.0 / 75.0;
    const double q = 20.0 / 75.0;
    const double theta = std::sqrt((1.0 - p) * (1.0 - q) / (p * q));
    QVERIFY(std::abs(rao.tie - theta) < 1e-5);
    QVERIFY(std::abs(rao.logWorth[0] - rao.logWorth[1] - std::log(p * theta / (1.0 - p))) < 1e-5);
    // Standard errors in closed form: of ln(a/b), of ln t − ½ ln(ab), of ½ (logit p − logit q); a centred
    // worth has half of a difference.
    QVERIFY(std::abs(davidson.standardError[0] - 0.5 * std::sqrt(1.0 / 40.0 + 1.0 / 20.0)) < 1e-5);
    QVERIFY(std::abs(davidson.standardError[1] - davidson.standardError[0]) < 1e-9);
    QVERIFY(std::abs(davidson.tieStandardError - std::sqrt(1.0 / 15.0 + 1.0 / 160.0 + 1.0 / 80.0)) < 1e-5);
    const double variance =
        (0.25 / (p * (1.0 - p)) + 0.25 / (q * (1.0 - q)) + 0.5 / ((1.0 - p) * (1.0 - q))) / 75.0;
    QVERIFY(std::abs(rao.standardError[0] - 0.5 * std::sqrt(variance)) < 1e-5);
    QVERIFY(!fitTiedPairs(TieModel::davidson, 2, {{0, 1, 3.0, 2.0, 0.0}}).fitted);
    QVERIFY(!fitTiedPairs(TieModel::raoKupper, 2, {{0, 1, 0.0, 0.0, 4.0}}).fitted);
    QVERIFY(!fitTiedPairs(TieModel::raoKupper, 3, {{0, 1, 4.0, 1.0, 4.0}}).fitted);
    QVERIFY(!fitTiedPairs(TieModel::davidson, 2,
                          {{0, 0, 1.0, 1.0, 1.0}, {0, 9, 1.0, 1.0, 1.0}, {0, 1, -1.0, 1.0, 1.0}})
                 .fitted);
}

void TestRankings::thurstone() {
    const WorthEstimate two = fitThurstonePairs(2, {{0, {1}, 75.0}, {1, {0}, 25.0}});
    const double z75 = 0.674489750196082; // Φ⁻¹(0.75)
    const double density = std::exp(-0.5 * z75 * z75) / std::sqrt(2.0 * M_PI);
    QVERIFY(std::abs(two.standardError[0] - 0.5 * std::sqrt(0.75 * 0.25 / 100.0) / density) < 1e-6);
    QVERIFY(std::abs(two.logWorth[0] - two.logWorth[1] - 0.674489750) < 1e-6);
    // Exact pair shares of a case V scale come back.
    const std::vector<double> scale{0.7, 0.1, -0.2, -0.6};
    std::vector<Selection> pairs;
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j)
            if (i != j)
                pairs.push_back({i,
                                 {j},
                                 100.0 * chiron::core::normalCumulative(scale[static_cast<std::size_t>(i)] -
                                                                        scale[static_cast<std::size_t>(j)])});
    const WorthEstimate four = fitThurstonePairs(4, pairs);
    for (std::size_t i = 0; i < 4; ++i)
        QVERIFY(std::abs(four.logWorth[i] - scale[i]) < 1e-5);
    const WorthEstimate orders = fitThurstoneOrders(3, {{0, 1, 2}, {1, 0, 2}, {2, 0, 1}, {0, 2, 1}});
    QVERIFY(orders.fitted && std::isnan(orders.standardError[0]) && orders.logWorth[0] > orders.logWorth[1]);
    QVERIFY(!fitThurstoneOrders(3, {{0, 1, 2}}).fitted);
    // Many judges of many objects: pairs are counted, not gone through again and again (this took minutes).
    chiron::core::Random random(9);
    std::vector<std::vector<int>> many;
    for (int judge = 0; judge < 300; ++judge) {
        std::vector<std::pair<double, int>> felt;
        for (int object = 0; object < 30; ++object)
            felt.emplace_back(0.1 * object + random.normal(), object);
        std::sort(felt.begin(), felt.end());
        many.emplace_back();
        for (const auto& [value, object] : felt)
            many.back().push_back(object);
    }
    const WorthEstimate wide = fitThurstoneOrders(30, many);
    QVERIFY(wide.fitted && wide.warnings.empty());
    for (std::size_t i = 0; i < 30;
         ++i) // best first is smallest first here; case V of differences: sd √2 a difference
        QVERIFY(std::abs(wide.logWorth[i] * std::sqrt(2.0) - (1.45 - 0.1 * static_cast<double>(i))) < 0.2);
}

QTEST_APPLESS_MAIN(TestRankings)
#include "test_rankings.moc"
