// SPDX-License-Identifier: GPL-3.0-or-later
#include "psychophysics/observers/tied_orders.h"

#include "core/normal_distribution.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

namespace chiron::psychophysics {

namespace {

using core::normalCumulative;
using core::normalDensity;

constexpr double kReach = 9.0; ///< sd; the density outside is below 1e-18
constexpr double kStep = 0.4;  ///< sd, width of the trapezoids; their error for such integrands is below
                               ///< 1e-14
constexpr int kPoints = 46;

constexpr double kTableStep = 0.05; ///< step of d in the table
constexpr double kTableEnd = 12.0;

/// Probabilities, given the percept of the middle object, that another object lies below or above it, each
/// split into near enough to tie and farther.
struct Neighbour {
    double farBelow, nearBelow, nearAbove, farAbove;

    Neighbour(double y, double mean, double tie) noexcept
        : farBelow(normalCumulative(y - tie - mean)), nearBelow(normalCumulative(y - mean) - farBelow),
          nearAbove(normalCumulative(mean - y)), farAbove(normalCumulative(mean - y - tie)) {
        nearAbove -= farAbove;
    }
};

/// A perceived order of three objects, with the indices of the possible answers: no ties, the lower two tied,
/// the upper two tied, all tied.
struct Felt {
    std::array<std::size_t, 4> said;

    Felt(int low, int middle, int high) noexcept
        : said{index(low, middle, high, 1, 2), index(low, middle, high, 0, 1), index(low, middle, high, 1, 1),
               index(low, middle, high, 0, 0)} {}
    void add(RankingProbabilities& p, double weight, const Neighbour& low,
             const Neighbour& high) const noexcept {
        p[said[0]] += weight * low.farBelow * high.farAbove;
        p[said[1]] += weight * low.nearBelow * high.farAbove;
        p[said[2]] += weight * low.farBelow * high.nearAbove;
        p[said[3]] += weight * low.nearBelow * high.nearAbove;
    }

private:
    static std::size_t index(int low, int middle, int high, int middleRank, int highRank) noexcept {
        Ranking ranks{};
        ranks[static_cast<std::size_t>(low)] = 0;
        ranks[static_cast<std::size_t>(middle)] = static_cast<std::int8_t>(middleRank);
        ranks[static_cast<std::size_t>(high)] = static_cast<std::int8_t>(highRank);
        return static_cast<std::size_t>(rankingOf(ranks));
    }
};

/// Returns the same seen from the other end: objects 0 and 2 are exchanged and the ranks reversed.
RankingProbabilities mirrored(const RankingProbabilities& p) noexcept {
    static const std::array<std::size_t, kRankings> from = [] {
        std::array<std::size_t, kRankings> index{};
        for (std::size_t i = 0; i < index.size(); ++i) {
            const Ranking& r = rankings()[i];
            index[i] = static_cast<std::size_t>(rankingOf({r[2], r[1], r[0]}));
        }
        return index;
    }();
    RankingProbabilities turned{};
    for (std::size_t i = 0; i < turned.size(); ++i)
        turned[i] = p[from[i]];
    return turned;
}

} // namespace

RankingProbabilities tiedRankProbabilities(double d, double tie) noexcept {
    RankingProbabilities p{};
    for (int middle = 0; middle < 3; ++middle) {
        const int one = middle == 0 ? 1 : 0;
        const int other = middle == 2 ? 1 : 2;
        const Felt rising(one, middle, other);
        const Felt falling(other, middle, one);
        for (int i = 0; i < kPoints; ++i) {
            const double y = -kReach + kStep * i;
            const Neighbour first(y, (one - middle) * d, tie);
            const Neighbour second(y, (other - middle) * d, tie);
            const double weight = kStep * normalDensity(y);
            rising.add(p, weight, first, second);
            falling.add(p, weight, second, first);
        }
    }
    const double total = std::accumulate(p.begin(), p.end(), 0.0);
    for (double& value : p)
        value = std::max(0.0, value / total);
    return p;
}

double rightOrderProbability(double d, double tie) noexcept {
    double sum = 0.0;
    for (int i = 0; i < kPoints; ++i) {
        const double y = -kReach + kStep * i;
        sum += kStep * normalDensity(y) * normalCumulative(y - tie + d) * normalCumulative(d - y - tie);
    }
    return std::min(1.0, sum);
}

TiedOrderTable::TiedOrderTable(double tie) {
    const int rows = static_cast<int>(std::ceil((kTableEnd + tie) / kTableStep)) + 3;
    for (int i = -1; i < rows - 1; ++i)
        m_rows.push_back(tiedRankProbabilities(kTableStep * i, tie));
}

RankingProbabilities TiedOrderTable::at(double d) const noexcept {
    if (d < 0.0)
        return mirrored(at(-d));
    const double place = d / kTableStep;
    if (!(place < static_cast<double>(m_rows.size() - 3))) {
        RankingProbabilities limit{};
        if (std::isnan(d))
            limit.fill(d);
        else
            limit[0] = 1.0;
        return limit;
    }
    const auto row = static_cast<std::size_t>(place);
    const double u = place - static_cast<double>(row);
    const std::array<double, 4> weight{-u * (u - 1.0) * (u - 2.0) / 6.0,
                                       (u + 1.0) * (u - 1.0) * (u - 2.0) / 2.0,
                                       -(u + 1.0) * u * (u - 2.0) / 2.0, (u + 1.0) * u * (u - 1.0) / 6.0};
    RankingProbabilities p{};
    for (std::size_t i = 0; i < p.size(); ++i) {
        for (std::size_t k = 0; k < weight.size(); ++k)
            p[i] += weight[k] * m_rows[row + k][i];
        p[i] = std::max(0.0, p[i]);
    }
    return p;
}

} // namespace chiron::psychophysics
