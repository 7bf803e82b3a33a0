// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/study/arrangement.h"

#include <array>
#include <vector>

namespace chiron::psychophysics {

/// One probability for each of rankings().
using RankingProbabilities = std::array<double, kRankings>;

/// Returns the probability of each ranking of three objects at 0, d and 2d that may be called equal. The
/// percepts of thurstone.h are put in order, and neighbours less than `tie` apart are called equal (Glenn &
/// David 1960, Biometrics 16:86-109, for pairs; Rao & Kupper's threshold on Thurstone's scale). d = D/σ, any
/// finite number; tie ≥ 0 in σ. The ranks are those given to the true 0, 1, 2; the first ranking is entirely
/// correct. The probabilities sum to 1 within 1e-13; with tie 0 the first six are rankProbabilities(d).
RankingProbabilities tiedRankProbabilities(double d, double tie) noexcept;

/// Returns only the first of them: entirely correct, nothing tied.
double rightOrderProbability(double d, double tie) noexcept;

/// A table of tiedRankProbabilities for one `tie`, with cubic interpolation: within 1e-6 for |d| ≤ 12 + tie,
/// and the limit beyond.
class TiedOrderTable {
public:
    explicit TiedOrderTable(double tie);
    RankingProbabilities at(double d) const noexcept;

private:
    std::vector<RankingProbabilities> m_rows; ///< from d = -kStep
};

} // namespace chiron::psychophysics
