// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

namespace chiron::psychophysics {

/// Returns the probability of each order of three objects at 0, d and 2d that are perceived with independent
/// normal noise of sd 1 (Thurstone 1927, case V): P(a<b<c) = ∫ φ(y-μ_b) Φ(y-μ_a) Φ(μ_c-y) dy. d = D/σ, any
/// finite number. The outcomes are those of outcomeOf(Task::rank3, ...): the ranks given to the true 0, 1, 2,
/// in the order of arrangements(Task::rank3); the first is entirely correct. The probabilities sum to 1
/// within 1e-14.
std::array<double, 6> rankProbabilities(double d) noexcept;

/// The same with lapses, in which each of the six orders is equally likely: (1-λ) P + λ/6.
std::array<double, 6> rankProbabilities(double d, double lapse) noexcept;

} // namespace chiron::psychophysics
