// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/study/run_estimate.h"

namespace chiron::psychophysics {

/// Estimates from adjustments: the PSE from the mean of the settings, σ = sd/√2 (reference and comparison are
/// each perceived with noise σ), and from it the Weber fraction W and the JND.
void takeSettings(RunEstimate& result, const Condition& condition, const std::vector<ScoredTrial>& trials);

/// Estimates from the magnitude estimates of one participant: the exponent, with the regression in log10
/// units as the curve. There is no Weber fraction.
void takeMagnitudes(RunEstimate& result, const Condition& condition, const std::vector<ScoredTrial>& trials);

} // namespace chiron::psychophysics
