// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/procedures/quest_plus.h"

namespace chiron::psychophysics {

/// JND of 75 % correct in 2AFC for an internal noise: √2 z(0.75) σ (2AFC: pc = Φ(D/(√2 σ))).
inline constexpr double kJndPerSigma = 0.9538725524089398;

/// QUEST+ of rankings of three (0, D, 2D) over (log10 σ, λ), where ties are allowed over (log10 σ, tie, λ), by Thurstone's observer; outcomes as rankProbabilities.
/// Failure: badInput naming the key and what was expected.
core::Result<std::shared_ptr<const QuestPlusModel>> rank3Model(const Rank3Spec& spec);
/// Whether rank3Model makes one; fails as that does. Its tables, a second of work for two grids of 41, are not made.
core::Result<void> checkRank3(const Rank3Spec& spec);

} // namespace chiron::psychophysics
