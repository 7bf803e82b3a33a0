// SPDX-License-Identifier: GPL-3.0-or-later
// Rankings of three objects summed up, against counts done by hand and closed forms.
#include "psychophysics/measures/ranking_summary.h"

#include <QtTest>

#include <algorithm>
#include <cmath>

using namespace chiron::psychophysics;

class TestRankingSummary : public QObject {
    Q_OBJECT
private slots:
    void participantsAreDrawn();
    void readsTrials();
    void byHand();
    void ties();
    void alwaysRight();
    void groupIsOfPersons();
    void nothingSaid();
};

/// Answer and arrangement count, an outcome only where there is no answer; a time-out says nothing.
void TestRankingSummary::readsTrials() {
    ScoredTrial right;
    right.arrangement = right.answer = 3; // {1,2,0}, and said so
    right.outcome = 5;                    // as a procedure of two outcomes may have heard it
    ScoredTrial heard;
    heard.outcome = 1; // {0,2,1}
    ScoredTrial silent;
    const auto rankings = saidRanks({right, heard, silent});
    QCOMPARE(rankings.size(), std::size_t{2});
    QCOMPARE(rankings[0], (SaidRanks{1, 2, 3}));
    QCOMPARE(rankings[1], (SaidRanks{1, 3, 2}));
}

/// Four rankings: two right, one with the upper two changed, one reversed.
void TestRankingSummary::byHand() {
    const RankingSummary summary = summariseRankings({{1, 2, 3}, {1, 2, 3}, {1, 3, 2}, {3, 2, 1}});
    QCOMPARE(summary.rankings, 4);
    QCOMPARE(summary.judges, 4);
    QCOMPARE(summary.complete.right, 2);
    QVERIFY(std::abs(summary.tau - (1.0 + 1.0 + 1.0 / 3.0 - 1.0) / 4.0) < 1e-12);
    const double sd =
        std::sqrt((2 * std::pow(2.0 / 3, 2) + 0 + std::pow(4.0 / 3, 2)) / 3.0); // of 1, 1, 1/3, −1 about 1/3
    QVERIFY(std::abs(summary.tauHigh - std::min(1.0, summary.tau + 3.182446305 * sd / 2.0)) < 1e-6);
    QVERIFY(std::abs(summary.tauLow - std::max(-1.0, summary.tau - 3.182446305 * sd / 2.0)) < 1e-6);
    // column sums 6, 9, 9: S = 4 + 1 + 1, W = 12 S/(m²(k³−k))
    QVERIFY(std::abs(summary.agreement.w - 12.0 * 6.0 / (16.0 * 24.0)) < 1e-12);
    QCOMPARE(summary.trend.l, 6.0 + 2 * 9.0 + 3 * 9.0);
    QVERIFY(summary.bradleyTerry.fitted && summary.plackettLuce.fitted && summary.thurstone.fitted);
    // 1 over 0, 2 over 0: three of four; 2 over 1: two of four — worths of 1 and 2 are alike, three times
    // that of 0.
    QVERIFY(std::abs(summary.bradleyTerry.logWorth[1] - summary.bradleyTerry.logWorth[2]) < 1e-6);
    QVERIFY(std::abs(summary.bradleyTerry.logWorth[1] - summary.bradleyTerry.logWorth[0] - std::log(3.0)) <
            1e-6);
    QVERIFY(summary.bradleyTerry.standardError[0] > 0.0);
}

/// Four rankings: right; the lower two equal; the upper two equal, in the wrong place; all equal.
void TestRankingSummary::ties() {
    ScoredTrial lower, all;
    lower.arrangement = 5; // {2,1,0}: said 1, 0, 0 from left to right, so objects 0 and 1 are equal
    lower.answer = rankingOf({1, 0, 0});
    all.outcome = rankingOf({0, 0, 0});
    const auto said = saidRanks({lower, all});
    QCOMPARE(said[0], (SaidRanks{1.5, 1.5, 3}));
    QCOMPARE(said[1], (SaidRanks{2, 2, 2}));
    const RankingSummary summary = summariseRankings({{1, 2, 3}, said[0], {2.5, 1, 2.5}, said[1]});
    QCOMPARE(summary.tied, 3);
    QCOMPARE(summary.complete.right, 1);
    QVERIFY(std::abs(summary.tau - (1.0 + 2.0 / 3.0 + 0.0 + 0.0) / 4.0) <
            1e-12); // the third: one pair right, one wrong, one tied
    // column sums 7, 6.5, 10.5 about 8; Σ(t³ − t) = 0 + 6 + 6 + 24
    QVERIFY(std::abs(summary.agreement.w - 12.0 * (1.0 + 2.25 + 6.25) / (16.0 * 24.0 - 4.0 * 36.0)) < 1e-12);
    QCOMPARE(summary.trend.l, 7.0 + 2 * 6.5 + 3 * 10.5);
    QVERIFY(summary.bradleyTerry.fitted && summary.davidsonTie > 0.0);
    // Davidson's likelihood equation of ties: as many are expected as there were
    const auto& g = summary.bradleyTerry.logWorth;
    double expected = 0.0;
    for (const auto& [i, j] : {std::pair{0U, 1U}, std::pair{0U, 2U}, std::pair{1U, 2U}}) {
        const double up = std::exp(0.5 * (g[i] - g[j]));
        expected += 4.0 * summary.davidsonTie / (up + 1.0 / up + summary.davidsonTie);
    }
    QVERIFY(std::abs(expected - 5.0) < 1e-5); // 0 + 1 + 1 + 3 tied pairs
    QVERIFY(summary.plackettLuce.fitted && summary.thurstone.fitted &&
            std::isnan(summary.thurstone.standardError[0]));
    QVERIFY(summary.thurstone.logWorth[2] > summary.thurstone.logWorth[0]);
}

/// Never wrong: no finite worth exists, and none is shown.
void TestRankingSummary::alwaysRight() {
    const RankingSummary summary = summariseRankings({{1, 2, 3}, {1, 2, 3}, {1, 2, 3}});
    QCOMPARE(summary.tau, 1.0);
    QCOMPARE(summary.agreement.w, 1.0);
    QVERIFY(!summary.bradleyTerry.fitted && !summary.plackettLuce.fitted && !summary.thurstone.fitted);
}

/// Who ranked more often does not count for more in W, L and τ.
void TestRankingSummary::groupIsOfPersons() {
    const std::vector<SaidRanks> good(30, SaidRanks{1, 2, 3});
    const RankingSummary summary = summariseGroupRankings({good, {}, {{3, 2, 1}, {3, 2, 1}}});
    QCOMPARE(summary.rankings, 32);
    QCOMPARE(summary.judges, 2);
    QVERIFY(std::abs(summary.tau) < 1e-12);
    QVERIFY(std::abs(summary.agreement.w) < 1e-12); // two opposite judges
    QCOMPARE(summary.trend.l, 2.0 * 3 * 16 / 4);    // what guessing gives
}

void TestRankingSummary::nothingSaid() {
    QCOMPARE(summariseRankings({}).rankings, 0);
    QCOMPARE(summariseGroupRankings({{}, {}}).rankings, 0);
    QVERIFY(std::isnan(summariseRankings({}).tau));
    QVERIFY(std::isnan(summariseRankings({{1, 2, 3}}).tauLow)); // one says nothing of its scatter
}

/// Six people of one mind each, trials by the hundred: the group's intervals are those of six people, not of
/// 600 trials; an adaptive run has none.
void TestRankingSummary::participantsAreDrawn() {
    std::vector<std::vector<SaidRanks>> people;
    for (int person = 0; person < 6; ++person)
        people.push_back(std::vector<SaidRanks>(100, person < 4 ? SaidRanks{1, 2, 3} : SaidRanks{2, 1, 3}));
    const RankingSummary group = summariseGroupRankings(people);
    QVERIFY(std::abs(group.complete.share - 4.0 / 6.0) < 1e-12);
    QVERIFY2(group.complete.high - group.complete.low > 0.5,
             qPrintable(QString::number(group.complete.high - group.complete.low))); // of 600 trials: 0.08
    QVERIFY(group.wLow < group.agreement.w && group.agreement.w <= group.wHigh && group.wLow > 0.3);
    QVERIFY(std::isnan(summariseGroupRankings({people[0], people[5]}).wLow));
    const std::vector<SaidRanks> some{{1, 2, 3}, {1, 2, 3}, {1, 3, 2}, {3, 2, 1}};
    const RankingSummary fixed = summariseRankings(some), adaptive = summariseRankings(some, true);
    QVERIFY(std::isfinite(fixed.complete.low) && std::isfinite(fixed.tauLow) &&
            std::isfinite(fixed.trend.pValue) && std::isfinite(fixed.agreement.pValue));
    QVERIFY(std::isnan(adaptive.complete.low) && std::isnan(adaptive.tauLow) &&
            std::isnan(adaptive.trend.pValue) && std::isnan(adaptive.agreement.exactP));
    QCOMPARE(adaptive.tau, fixed.tau);
    QCOMPARE(adaptive.agreement.w, fixed.agreement.w);
}

QTEST_GUILESS_MAIN(TestRankingSummary)
#include "test_ranking_summary.moc"
