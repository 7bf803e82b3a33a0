// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "mechanisms/fingertip_platform_parameters.h"

#include <cstdint>
#include <vector>

namespace chiron::mechanisms {

/// One reading while a finger is pressed: height of the platform by the drives' encoders (m), force by the three resistors (N).
struct PadReading {
    double height_m = 0.0;
    double force_N = 0.0;
};

/// What the platform finds of the finger that has been put on it: a, β and z₀ of FingerPadParameters by least squares on
/// F = (a/β)(e^{β(z − z₀)} − 1), which for a given β is linear; radius, damping and relaxation stay what `nominal` says.
/// Failure: badInput where fewer than 20 readings lie between 0.05 and `most_N`, or where they do not rise with the height.
core::Result<FingerPadParameters> fitPad(const std::vector<PadReading>& readings, double most_N, const FingerPadParameters& nominal);

/// Presses the finger three times up to 2.2 N, level, and fits what the device's own sensors said while the force rose: what has
/// relaxed on the way back would make the pad look softer than it is when it is pressed again. `parameters.pad` is the finger that is pressed, which the fit is not told;
/// the same seed gives the sensors of FingertipPlatform with that seed. Some 10 ms; allocates, not in the tick.
/// Failure: badInput where no finger is met within the travel, where the motors do not press it that far, and as fitPad.
core::Result<FingerPadParameters> identifyPad(const FingertipPlatformParameters& parameters, std::uint64_t seed);

/// `parameters`, with the controller told what was identified.
core::Result<FingertipPlatformParameters> worn(FingertipPlatformParameters parameters, std::uint64_t seed);

} // namespace chiron::mechanisms
