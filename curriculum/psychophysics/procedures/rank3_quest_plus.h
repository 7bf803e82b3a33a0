// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/procedures/quest_plus.h"

namespace chiron::psychophysics {

/// JND at 75 % correct in 2AFC per unit of internal noise: √2 z(0.75) σ (2AFC: pc = Φ(D/(√2 σ))).
inline constexpr double kJndPerSigma = 0.9538725524089398;

/// Makes the QUEST+ model for rankings of three objects (0, D, 2D) by Thurstone's observer: over (log10 σ, λ)
/// or, if ties are allowed, over (log10 σ, tie, λ). The outcomes are those of rankProbabilities.
/// Errors: badInput naming the key and what was expected.
core::Result<std::shared_ptr<const QuestPlusModel>> rank3Model(const Rank3Spec& spec);
/// Returns whether rank3Model would make a model; fails as that does. It does not make the tables, which take
/// a second for two grids of 41.
core::Result<void> checkRank3(const Rank3Spec& spec);

} // namespace chiron::psychophysics
