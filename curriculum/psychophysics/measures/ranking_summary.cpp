// SPDX-License-Identifier: GPL-3.0-or-later
#include "psychophysics/measures/ranking_summary.h"

#include "psychophysics/measures/exact_tests.h"
#include "psychophysics/measures/random_effects.h"
#include "psychophysics/measures/sample_moments.h"
#include "psychophysics/study/arrangement.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <numeric>
#include <utility>

namespace chiron::psychophysics {

namespace {

constexpr std::size_t kObjects = 3;

/// Returns τ_a of a ranking with the true order: each of the three pairs is in order, reversed, or tied and
/// counts 0.
double tauOf(const SaidRanks& ranks) {
    int inOrder = 0;
    for (std::size_t i = 0; i < kObjects; ++i)
        for (std::size_t j = i + 1; j < kObjects; ++j)
            inOrder += ranks[i] < ranks[j] ? 1 : ranks[i] > ranks[j] ? -1 : 0;
    return inOrder / 3.0;
}

double meanTau(const std::vector<SaidRanks>& rankings) {
    double sum = 0.0;
    for (const SaidRanks& ranks : rankings)
        sum += tauOf(ranks);
    return sum / static_cast<double>(rankings.size());
}

void setTau(RankingSummary& summary, const std::vector<double>& taus) {
    const auto n = static_cast<double>(taus.size());
    if (taus.empty())
        return;
    summary.tau = std::accumulate(taus.begin(), taus.end(), 0.0) / n;
    if (taus.size() < 2)
        return;
    double squares = 0.0;
    for (const double tau : taus)
        squares += (tau - summary.tau) * (tau - summary.tau);
    const double half = studentQuantile(0.975, n - 1.0) * std::sqrt(squares / (n - 1.0) / n);
    summary.tauLow = std::max(-1.0, summary.tau - half);
    summary.tauHigh = std::min(1.0, summary.tau + half);
}

/// Returns the strict orders, most first, that agree with a ranking: one or, if objects are tied, two or six.
std::vector<std::vector<int>> ordersOf(const SaidRanks& ranks) {
    std::vector<int> order(kObjects);
    std::iota(order.begin(), order.end(), 0);
    std::vector<std::vector<int>> orders;
    do {
        if (std::is_sorted(order.begin(), order.end(), [&](int a, int b) {
                return ranks[static_cast<std::size_t>(a)] > ranks[static_cast<std::size_t>(b)];
            }))
            orders.push_back(order);
    } while (std::next_permutation(order.begin(), order.end()));
    return orders;
}

/// Counts for each pair of objects how often each was ranked higher, or tied.
std::vector<PairCount> pairsOf(const std::vector<SaidRanks>& rankings) {
    std::vector<PairCount> pairs{{0, 1}, {0, 2}, {1, 2}};
    for (const SaidRanks& ranks : rankings)
        for (PairCount& pair : pairs) {
            const double above =
                ranks[static_cast<std::size_t>(pair.first)] - ranks[static_cast<std::size_t>(pair.second)];
            (above > 0.0 ? pair.wins : above < 0.0 ? pair.losses : pair.ties) += 1.0;
        }
    return pairs;
}

bool isTied(const SaidRanks& ranks) {
    return ranks[0] == ranks[1] || ranks[1] == ranks[2] || ranks[0] == ranks[2];
}

void setPairs(RankingSummary& summary, const std::vector<SaidRanks>& rankings) {
    const std::vector<PairCount> pairs = pairsOf(rankings);
    if (summary.tied > 0) {
        const TiedWorthEstimate davidson =
            fitTiedPairs(TieModel::davidson, static_cast<int>(kObjects), pairs);
        summary.bradleyTerry = davidson;
        summary.davidsonTie = davidson.tie;
        return;
    }
    std::vector<Selection> wins;
    for (const PairCount& pair : pairs) {
        if (pair.wins > 0.0)
            wins.push_back({pair.first, {pair.second}, pair.wins});
        if (pair.losses > 0.0)
            wins.push_back({pair.second, {pair.first}, pair.losses});
    }
    summary.bradleyTerry = fitPlackettLuce(static_cast<int>(kObjects), wins);
}

void setWorths(RankingSummary& summary, const std::vector<SaidRanks>& rankings) {
    std::vector<Selection> selections;
    // Shares of the orders, by pair, so that many rankings cost no more than a few.
    std::map<std::pair<int, int>, double> ahead;
    for (const SaidRanks& ranks : rankings) {
        const auto orders = ordersOf(ranks);
        const double share = 1.0 / static_cast<double>(orders.size());
        for (const std::vector<int>& order : orders) {
            for (const Selection& selection : selectionsOf(order, share))
                selections.push_back(selection);
            for (std::size_t i = 0; i < kObjects; ++i)
                for (std::size_t j = i + 1; j < kObjects; ++j)
                    ahead[{order[i], order[j]}] += share;
        }
    }
    std::vector<Selection> halves;
    for (const auto& [pair, count] : ahead)
        halves.push_back({pair.first, {pair.second}, count});
    setPairs(summary, rankings);
    summary.plackettLuce = fitPlackettLuce(static_cast<int>(kObjects), selections);
    summary.thurstone = fitThurstonePairs(static_cast<int>(kObjects), halves);
    // The pairs of one ranking are not independent.
    std::fill(summary.thurstone.standardError.begin(), summary.thurstone.standardError.end(),
              std::numeric_limits<double>::quiet_NaN());
}
void setOrders(RankingSummary& summary, const std::vector<SaidRanks>& rankings,
               const std::vector<SaidRanks>& rows) {
    summary.rankings = static_cast<int>(rankings.size());
    summary.judges = static_cast<int>(rows.size());
    const auto right = std::count_if(rankings.begin(), rankings.end(), [](const SaidRanks& ranks) {
        return ranks[0] < ranks[1] && ranks[1] < ranks[2];
    });
    summary.complete = completeOrders(static_cast<int>(right), summary.rankings);
    summary.agreement = kendallW(rows);
    summary.trend = pageTrend(rows);
    summary.tied = static_cast<int>(std::count_if(rankings.begin(), rankings.end(), isTied));
    setWorths(summary, rankings);
}

/// Sets the intervals of W and of the share of complete orders from participants drawn with replacement.
void setIntervalsOfParticipants(RankingSummary& summary,
                                const std::vector<std::vector<SaidRanks>>& participants,
                                const std::vector<SaidRanks>& means) {
    std::vector<double> right, of, shares;
    for (const std::vector<SaidRanks>& rankings : participants) {
        if (rankings.empty())
            continue;
        of.push_back(static_cast<double>(rankings.size()));
        right.push_back(
            static_cast<double>(std::count_if(rankings.begin(), rankings.end(), [](const SaidRanks& r) {
                return r[0] < r[1] && r[1] < r[2];
            })));
        shares.push_back(right.back() / of.back());
    }
    const int people = static_cast<int>(means.size());
    constexpr std::uint64_t kSeed = 1; // fixed, so that the same answers give the same interval
    const auto ofW = bootstrapSubjects(
        people,
        [&](const std::vector<int>& drawn) {
            std::vector<SaidRanks> rows;
            for (const int index : drawn)
                rows.push_back(means[static_cast<std::size_t>(index)]);
            return kendallW(rows).w;
        },
        kSeed);
    summary.wLow = ofW.low;
    summary.wHigh = ofW.high;
    const auto ofShare = bootstrapSubjects(
        people,
        [&](const std::vector<int>& drawn) {
            double all = 0.0, whole = 0.0;
            for (const int index : drawn) {
                all += of[static_cast<std::size_t>(index)];
                whole += right[static_cast<std::size_t>(index)];
            }
            return whole / all;
        },
        kSeed);
    summary.complete.low = ofShare.low;
    summary.complete.high = ofShare.high;
    const SampleMoments m = momentsOf(shares);
    const double error = m.sd / std::sqrt(static_cast<double>(people));
    summary.complete.pValue = people >= 3 && error > 0.0
                                  ? studentUpperTail((m.mean - 1.0 / 6.0) / error, people - 1.0)
                                  : std::numeric_limits<double>::quiet_NaN();
}

} // namespace

std::vector<SaidRanks> saidRanks(const std::vector<ScoredTrial>& trials) {
    std::vector<SaidRanks> said;
    for (const ScoredTrial& trial : trials) { // rankings without ties are counted in the same way in both
                                              // tasks
        const int outcome =
            trial.answer >= 0 ? outcomeOf(Task::rank3Ties, trial.arrangement, trial.answer) : trial.outcome;
        if (outcome < 0 || outcome >= kRankings)
            continue;
        const Ranking& given = rankings()[static_cast<std::size_t>(outcome)];
        SaidRanks ranks;
        for (const int own : given) { // tied objects share their mean rank
            const auto below =
                std::count_if(given.begin(), given.end(), [own](int other) { return other < own; });
            const auto alike = std::count(given.begin(), given.end(), own);
            ranks.push_back(static_cast<double>(below) + 0.5 * static_cast<double>(alike + 1));
        }
        said.push_back(std::move(ranks));
    }
    return said;
}

RankingSummary summariseRankings(const std::vector<SaidRanks>& rankings, bool adaptive) {
    RankingSummary summary;
    if (rankings.empty())
        return summary;
    setOrders(summary, rankings, rankings);
    std::vector<double> taus;
    for (const SaidRanks& ranks : rankings)
        taus.push_back(tauOf(ranks));
    setTau(summary, taus);
    summary.adaptive = adaptive;
    if (adaptive) {
        constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
        summary.complete.low = summary.complete.high = summary.complete.pValue = kNone;
        summary.tauLow = summary.tauHigh = kNone;
        summary.agreement.pValue = summary.agreement.exactP = kNone;
        summary.trend.pValue = summary.trend.exactP = summary.trend.normalP = kNone;
    }
    return summary;
}

RankingSummary summariseGroupRankings(const std::vector<std::vector<SaidRanks>>& participants) {
    RankingSummary summary;
    std::vector<SaidRanks> all, means;
    std::vector<double> taus;
    for (const std::vector<SaidRanks>& rankings : participants) {
        if (rankings.empty())
            continue;
        SaidRanks mean(kObjects, 0.0);
        for (const SaidRanks& ranks : rankings)
            for (std::size_t i = 0; i < kObjects; ++i)
                mean[i] += ranks[i] / static_cast<double>(rankings.size());
        means.push_back(std::move(mean));
        taus.push_back(meanTau(rankings));
        all.insert(all.end(), rankings.begin(), rankings.end());
    }
    if (all.empty())
        return summary;
    setOrders(summary, all, means);
    setTau(summary, taus);
    setIntervalsOfParticipants(summary, participants, means);
    return summary;
}

} // namespace chiron::psychophysics
