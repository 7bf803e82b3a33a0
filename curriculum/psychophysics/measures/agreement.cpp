// SPDX-License-Identifier: GPL-3.0-or-later
#include "psychophysics/measures/agreement.h"

#include "core/normal_distribution.h"
#include "psychophysics/measures/exact_tests.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numeric>

namespace chiron::psychophysics {

namespace {

constexpr std::size_t kMostStates = 200000;
constexpr std::size_t kMostWork = 2000000; ///< number of additions: takes about a second
constexpr std::size_t kMostPermuted = 7;   ///< objects: 5,040 orders

bool allFinite(const std::vector<double>& values) {
    return std::all_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); });
}

double tieTerm(std::vector<double> values) { // Σ(t³ − t)
    std::sort(values.begin(), values.end());
    double sum = 0.0;
    for (std::size_t first = 0; first < values.size();) {
        std::size_t last = first;
        while (last < values.size() && values[last] == values[first])
            ++last;
        const double t = static_cast<double>(last - first);
        sum += t * t * t - t;
        first = last;
    }
    return sum;
}

/// Returns Σ(R − R̄)² of doubled rank sums.
double spread(const std::vector<int>& sums) {
    double total = 0.0;
    double squares = 0.0;
    for (const int sum : sums) {
        total += sum;
        squares += static_cast<double>(sum) * sum;
    }
    return squares - total * total / static_cast<double>(sums.size());
}

/// Returns P(S ≥ observed) if each judge assigns the ranks to the objects in random order. Sums are kept
/// sorted because the objects are exchangeable.
double exactConcordance(const std::vector<std::vector<int>>& doubledRanks) {
    if (doubledRanks.front().size() > kMostPermuted)
        return std::numeric_limits<double>::quiet_NaN();
    std::map<std::vector<int>, double> states{{std::vector<int>(doubledRanks.front().size(), 0), 1.0}};
    std::vector<int> observed(doubledRanks.front().size(), 0);
    std::size_t work = 0;
    for (std::vector<int> ranks : doubledRanks) {
        std::transform(observed.begin(), observed.end(), ranks.begin(), observed.begin(), std::plus<>());
        std::sort(ranks.begin(), ranks.end());
        std::vector<std::vector<int>> orders;
        do
            orders.push_back(ranks);
        while (std::next_permutation(ranks.begin(), ranks.end()));
        work += states.size() * orders.size();
        if (work > kMostWork)
            return std::numeric_limits<double>::quiet_NaN();
        std::map<std::vector<int>, double> next;
        for (const auto& [sums, share] : states)
            for (const std::vector<int>& order : orders) {
                std::vector<int> moved(sums.size());
                std::transform(sums.begin(), sums.end(), order.begin(), moved.begin(), std::plus<>());
                std::sort(moved.begin(), moved.end());
                next[moved] += share / static_cast<double>(orders.size());
            }
        states = std::move(next);
        if (states.size() > kMostStates)
            return std::numeric_limits<double>::quiet_NaN();
    }
    const double least = spread(observed) - 1e-9;
    return std::min(1.0, std::accumulate(states.begin(), states.end(), 0.0, [&](double p, const auto& state) {
                        return spread(state.first) >= least ? p + state.second : p;
                    }));
}

/// Returns concordant minus discordant pairs.
double score(const std::vector<double>& x, const std::vector<double>& y) {
    const auto sign = [](double v) { return v > 0.0 ? 1.0 : (v < 0.0 ? -1.0 : 0.0); };
    double s = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            s += sign(x[i] - x[j]) * sign(y[i] - y[j]);
    return s;
}

/// Returns P(|S| ≥ |observed|) without ties: the numbers of inversions of permutations (Kendall 1970), by
/// convolution.
double exactWithoutTies(std::size_t n, double observed) {
    std::vector<double> share{1.0};
    for (std::size_t k = 2; k <= n; ++k) {
        std::vector<double> next(share.size() + k - 1, 0.0);
        for (std::size_t i = 0; i < share.size(); ++i)
            for (std::size_t j = 0; j < k; ++j)
                next[i + j] += share[i] / static_cast<double>(k);
        share = std::move(next);
    }
    const double most = 0.5 * static_cast<double>(n * (n - 1));
    double p = 0.0;
    for (std::size_t inversions = 0; inversions < share.size(); ++inversions)
        p += std::abs(most - 2.0 * static_cast<double>(inversions)) >= std::abs(observed) - 1e-9
                 ? share[inversions]
                 : 0.0;
    return std::min(1.0, p);
}

double exactWithTies(const std::vector<double>& x, std::vector<double> y, double observed) {
    std::sort(y.begin(), y.end());
    double all = 0.0;
    double extreme = 0.0;
    do {
        all += 1.0;
        extreme += std::abs(score(x, y)) >= std::abs(observed) - 1e-9 ? 1.0 : 0.0;
    } while (std::next_permutation(y.begin(), y.end()));
    return extreme / all;
}

/// Sums over groups of tied values, as needed for the variance of S.
struct TieSums {
    double pairs = 0.0;    ///< Σ t(t−1)/2
    double triples = 0.0;  ///< Σ t(t−1)(t−2)
    double variance = 0.0; ///< Σ t(t−1)(2t+5)
};

TieSums tieSums(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    TieSums sums;
    for (std::size_t first = 0; first < values.size();) {
        const auto last = static_cast<std::size_t>(
            std::upper_bound(values.begin(), values.end(), values[first]) - values.begin());
        const double t = static_cast<double>(last - first);
        sums.pairs += 0.5 * t * (t - 1.0);
        sums.triples += t * (t - 1.0) * (t - 2.0);
        sums.variance += t * (t - 1.0) * (2.0 * t + 5.0);
        first = last;
    }
    return sums;
}

double normalP(double s, double n, const TieSums& a, const TieSums& b) {
    const double variance = (n * (n - 1.0) * (2.0 * n + 5.0) - a.variance - b.variance) / 18.0 +
                            (n > 2.0 ? a.triples * b.triples / (9.0 * n * (n - 1.0) * (n - 2.0)) : 0.0) +
                            2.0 * a.pairs * b.pairs / (n * (n - 1.0));
    return 2.0 * core::normalCumulative(-std::abs(s) / std::sqrt(variance));
}

} // namespace

std::vector<double> midRanks(const std::vector<double>& values) {
    std::vector<double> ranks(values.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
        double below = 0.0;
        double same = 0.0;
        for (const double other : values) {
            below += other < values[i] ? 1.0 : 0.0;
            same += other == values[i] ? 1.0 : 0.0;
        }
        ranks[i] = below + 0.5 * (same + 1.0);
    }
    return ranks;
}

Concordance kendallW(const std::vector<std::vector<double>>& judges) {
    Concordance result;
    std::vector<std::vector<int>> ranks;
    double ties = 0.0;
    for (const std::vector<double>& row : judges) {
        if (row.size() != judges.front().size() || !allFinite(row))
            continue;
        ties += tieTerm(row);
        ranks.emplace_back();
        for (const double rank : midRanks(row))
            ranks.back().push_back(static_cast<int>(std::lround(2.0 * rank)));
    }
    if (ranks.size() < judges.size())
        result.warnings.push_back("left_out: " + std::to_string(judges.size() - ranks.size()) +
                                  " judges have missing values");
    result.judges = static_cast<int>(ranks.size());
    result.objects = ranks.empty() ? 0 : static_cast<int>(ranks.front().size());
    if (result.judges < 2 || result.objects < 2) {
        result.warnings.emplace_back("too_few: at least two judges and two objects are needed");
        return result;
    }
    std::vector<int> sums(ranks.front().size(), 0);
    for (const std::vector<int>& row : ranks)
        std::transform(sums.begin(), sums.end(), row.begin(), sums.begin(), std::plus<>());
    const double m = result.judges;
    const double k = result.objects;
    const double below = m * m * (k * k * k - k) - m * ties;
    if (!(below > 0.0)) {
        result.warnings.emplace_back("all_tied: every judge gave every object the same");
        return result;
    }
    result.w = 12.0 * spread(sums) / 4.0 / below; // the rank sums are doubled
    result.chiSquare = m * (k - 1.0) * result.w;
    result.pValue = chiSquareUpperTail(result.chiSquare, k - 1.0);
    result.exactP = exactConcordance(ranks);
    return result;
}

RankCorrelation kendallTau(const std::vector<double>& x, const std::vector<double>& y) {
    RankCorrelation result;
    std::vector<double> a;
    std::vector<double> b;
    for (std::size_t i = 0; i < std::min(x.size(), y.size()); ++i)
        if (std::isfinite(x[i]) && std::isfinite(y[i])) {
            a.push_back(x[i]);
            b.push_back(y[i]);
        }
    result.pairs = static_cast<int>(a.size());
    const double n = static_cast<double>(a.size());
    const double most = 0.5 * n * (n - 1.0);
    const TieSums ta = tieSums(a);
    const TieSums tb = tieSums(b);
    if (!((most - ta.pairs) * (most - tb.pairs) > 0.0)) {
        result.warnings.emplace_back("too_few: at least two pairs that differ in both values are needed");
        return result;
    }
    const double s = score(a, b);
    const bool tied = ta.pairs + tb.pairs > 0.0;
    result.tau = s / std::sqrt((most - ta.pairs) * (most - tb.pairs));
    result.exact = a.size() <= (tied ? 8U : 100U);
    result.pValue = !result.exact ? normalP(s, n, ta, tb)
                                  : (tied ? exactWithTies(a, b, s) : exactWithoutTies(a.size(), s));
    if (result.pairs < 5)
        result.warnings.push_back("few_pairs: only " + std::to_string(result.pairs) + " pairs");
    return result;
}

CompleteOrders completeOrders(int right, int of) {
    CompleteOrders result{right, of};
    if (of <= 0 || right < 0 || right > of)
        return result;
    const ProportionInterval interval = exactInterval(right, of);
    result.share = static_cast<double>(right) / of;
    result.low = interval.low;
    result.high = interval.high;
    result.pValue = binomialUpperTail(right, of, 1.0 / 6.0);
    return result;
}

} // namespace chiron::psychophysics
