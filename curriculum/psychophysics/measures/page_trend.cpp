// SPDX-License-Identifier: GPL-3.0-or-later
#include "psychophysics/measures/page_trend.h"

#include "core/normal_distribution.h"
#include "psychophysics/measures/agreement.h"

#include <algorithm>
#include <cmath>

namespace chiron::psychophysics {

namespace {

constexpr std::size_t kMostObjects = 7;
constexpr double kMostSums = 12000.0; ///< number of judges times the largest doubled L of one judge: 0.1 s

bool isSmall(std::size_t objects, std::size_t judges) {
    const double k = static_cast<double>(objects);
    return objects <= kMostObjects &&
           static_cast<double>(judges) * k * (k + 1.0) * (2.0 * k + 1.0) / 3.0 <= kMostSums;
}

/// Returns the probability of each doubled Σ j·rank, counted from 0, over all orders of one judge's ranks.
std::vector<double> distributionOf(std::vector<int> doubledRanks) {
    std::sort(doubledRanks.begin(), doubledRanks.end());
    std::vector<double> counts;
    double all = 0.0;
    do {
        std::size_t sum = 0;
        for (std::size_t j = 0; j < doubledRanks.size(); ++j)
            sum += (j + 1) * static_cast<std::size_t>(doubledRanks[j]);
        counts.resize(std::max(counts.size(), sum + 1), 0.0);
        counts[sum] += 1.0;
        all += 1.0;
    } while (std::next_permutation(doubledRanks.begin(), doubledRanks.end()));
    for (double& count : counts)
        count /= all;
    return counts;
}

double exactTail(const std::vector<std::vector<int>>& rows, std::size_t doubledL) {
    std::vector<double> total{1.0};
    for (const std::vector<int>& row : rows) {
        const std::vector<double> one = distributionOf(row);
        std::vector<double> next(total.size() + one.size() - 1, 0.0);
        for (std::size_t i = 0; i < total.size(); ++i)
            for (std::size_t j = 0; total[i] > 0.0 && j < one.size(); ++j)
                next[i + j] += total[i] * one[j];
        total = std::move(next);
    }
    double p = 0.0;
    for (std::size_t sum = total.size(); sum-- > doubledL;)
        p += total[sum];
    return std::min(1.0, p);
}

/// Returns the variance of Σ j·rank of one judge: (k³−k)/12 · Σ(rank − mean)²/(k−1).
double varianceOf(const std::vector<int>& doubledRanks) {
    const double k = static_cast<double>(doubledRanks.size());
    double squares = 0.0;
    for (const int rank : doubledRanks)
        squares += std::pow(0.5 * rank - 0.5 * (k + 1.0), 2);
    return (k * k * k - k) / 12.0 * squares / (k - 1.0);
}

} // namespace

PageTrend pageTrend(const std::vector<std::vector<double>>& judges) {
    PageTrend result;
    std::vector<std::vector<int>> rows;
    std::size_t doubledL = 0;
    double variance = 0.0;
    for (const std::vector<double>& row : judges) {
        if (row.size() != judges.front().size() ||
            !std::all_of(row.begin(), row.end(), [](double v) { return std::isfinite(v); }))
            continue;
        rows.emplace_back();
        for (const double rank : midRanks(row)) {
            rows.back().push_back(static_cast<int>(std::lround(2.0 * rank)));
            doubledL += rows.back().size() * static_cast<std::size_t>(rows.back().back());
        }
        variance += row.size() > 1 ? varianceOf(rows.back()) : 0.0;
    }
    if (rows.size() < judges.size())
        result.warnings.push_back("left_out: " + std::to_string(judges.size() - rows.size()) +
                                  " judges have missing values");
    result.judges = static_cast<int>(rows.size());
    result.objects = rows.empty() ? 0 : static_cast<int>(rows.front().size());
    if (rows.empty() || result.objects < 2 || !(variance > 0.0)) {
        result.warnings.emplace_back(
            "too_few: at least one judge who ranked two objects differently is needed");
        return result;
    }
    const double k = result.objects;
    result.l = 0.5 * static_cast<double>(doubledL);
    result.expected = result.judges * k * (k + 1.0) * (k + 1.0) / 4.0;
    result.z = (result.l - result.expected) / std::sqrt(variance);
    result.normalP = core::normalCumulative(-result.z);
    if (isSmall(rows.front().size(), rows.size()))
        result.exactP = exactTail(rows, doubledL);
    result.pValue = std::isnan(result.exactP) ? result.normalP : result.exactP;
    return result;
}

double pageUpperTail(int objects, int judges, double l) {
    if (objects < 2 || judges < 1 || !std::isfinite(l) ||
        !isSmall(static_cast<std::size_t>(objects), static_cast<std::size_t>(judges)))
        return std::numeric_limits<double>::quiet_NaN();
    std::vector<int> ranks;
    for (int rank = 1; rank <= objects; ++rank)
        ranks.push_back(2 * rank);
    const std::vector<std::vector<int>> rows(static_cast<std::size_t>(judges), ranks);
    return exactTail(rows, static_cast<std::size_t>(std::max(0.0, std::ceil(2.0 * l - 1e-9))));
}

} // namespace chiron::psychophysics
