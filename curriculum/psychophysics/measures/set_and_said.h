// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/study/run_estimate.h"

namespace chiron::psychophysics {

/// Adjustment: PSE from the settings' mean, σ = sd/√2 (reference and comparison are each felt with noise σ), W and JND from it.
void takeSettings(RunEstimate& result, const Condition& condition, const std::vector<ScoredTrial>& trials);

/// Magnitude estimation of one participant: exponent, with the regression in log10 units as the curve. No Weber fraction.
void takeMagnitudes(RunEstimate& result, const Condition& condition, const std::vector<ScoredTrial>& trials);

} // namespace chiron::psychophysics
