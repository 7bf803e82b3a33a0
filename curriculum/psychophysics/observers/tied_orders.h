// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/study/arrangement.h"

#include <array>
#include <vector>

namespace chiron::psychophysics {

/// A probability for each of rankings().
using RankingProbabilities = std::array<double, kRankings>;

/// How often each ranking is said of three objects at 0, d and 2d that may be called equal: percepts as in thurstone.h, put in order, and
/// neighbours less than `tie` apart are said to be equal (Glenn & David 1960, Biometrics 16:86-109, for pairs; Rao & Kupper's threshold
/// on Thurstone's scale). d = D/σ, any finite number; tie ≥ 0 in σ. Ranks are those given to the true 0, 1, 2; the first is all correct. Sums to 1
/// within 1e-13; with tie 0 the first six are rankProbabilities(d).
RankingProbabilities tiedRankProbabilities(double d, double tie) noexcept;

/// The first of them alone: all correct, nothing tied.
double rightOrderProbability(double d, double tie) noexcept;

/// tiedRankProbabilities of one `tie` from a table by cubic interpolation: within 1e-6 for |d| ≤ 12 + tie, the limit beyond.
class TiedOrderTable {
public:
    explicit TiedOrderTable(double tie);
    RankingProbabilities at(double d) const noexcept;

private:
    std::vector<RankingProbabilities> m_rows; ///< from d = -kStep
};

} // namespace chiron::psychophysics
