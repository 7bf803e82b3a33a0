// SPDX-License-Identifier: GPL-3.0-or-later
#include "psychophysics/measures/ranking_summary.h"

#include "psychophysics/measures/exact_tests.h"
#include "psychophysics/study/arrangement.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace chiron::psychophysics {

namespace {

constexpr std::size_t kObjects = 3;

/// τ of a ranking with the true order: no ties, so each of the three pairs is in order or not.
double tauOf(const SaidRanks& ranks) {
    int inOrder = 0;
    for (std::size_t i = 0; i < kObjects; ++i)
        for (std::size_t j = i + 1; j < kObjects; ++j)
            inOrder += ranks[i] < ranks[j] ? 1 : -1;
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

std::vector<int> mostFirst(const SaidRanks& ranks) {
    std::vector<int> order(kObjects);
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(), [&](int a, int b) { return ranks[static_cast<std::size_t>(a)] > ranks[static_cast<std::size_t>(b)]; });
    return order;
}

void setWorths(RankingSummary& summary, const std::vector<SaidRanks>& rankings) {
    std::vector<Selection> pairs, selections;
    std::vector<std::vector<int>> orders;
    for (const SaidRanks& ranks : rankings) {
        const std::vector<int> order = mostFirst(ranks);
        orders.push_back(order);
        for (const Selection& selection : selectionsOf(order))
            selections.push_back(selection);
        for (std::size_t i = 0; i < kObjects; ++i)
            for (std::size_t j = i + 1; j < kObjects; ++j)
                pairs.push_back({order[i], {order[j]}, 1.0});
    }
    const int objects = static_cast<int>(kObjects);
    summary.bradleyTerry = fitPlackettLuce(objects, pairs);
    summary.plackettLuce = fitPlackettLuce(objects, selections);
    summary.thurstone = fitThurstoneOrders(objects, orders);
}

void setOrders(RankingSummary& summary, const std::vector<SaidRanks>& rankings, const std::vector<SaidRanks>& rows) {
    summary.rankings = static_cast<int>(rankings.size());
    summary.judges = static_cast<int>(rows.size());
    const auto right = std::count_if(rankings.begin(), rankings.end(), [](const SaidRanks& ranks) { return ranks[0] < ranks[1] && ranks[1] < ranks[2]; });
    summary.complete = completeOrders(static_cast<int>(right), summary.rankings);
    summary.agreement = kendallW(rows);
    summary.trend = pageTrend(rows);
    setWorths(summary, rankings);
}

} // namespace

std::vector<SaidRanks> saidRanks(const std::vector<ScoredTrial>& trials) {
    const auto& orders = arrangements(Task::rank3);
    std::vector<SaidRanks> rankings;
    for (const ScoredTrial& trial : trials) {
        const int outcome = trial.answer >= 0 ? outcomeOf(Task::rank3, trial.arrangement, trial.answer) : trial.outcome;
        if (outcome < 0 || static_cast<std::size_t>(outcome) >= orders.size())
            continue;
        SaidRanks ranks;
        for (const int said : orders[static_cast<std::size_t>(outcome)])
            ranks.push_back(said + 1.0);
        rankings.push_back(std::move(ranks));
    }
    return rankings;
}

RankingSummary summariseRankings(const std::vector<SaidRanks>& rankings) {
    RankingSummary summary;
    if (rankings.empty())
        return summary;
    setOrders(summary, rankings, rankings);
    std::vector<double> taus;
    for (const SaidRanks& ranks : rankings)
        taus.push_back(tauOf(ranks));
    setTau(summary, taus);
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
    return summary;
}

} // namespace chiron::psychophysics
