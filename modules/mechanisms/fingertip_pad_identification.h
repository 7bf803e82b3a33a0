// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "mechanisms/fingertip_platform_parameters.h"

#include <cstdint>
#include <vector>

namespace chiron::mechanisms {

/// One reading while a finger is pressed: the platform's height from the drives' encoders (m) and the force
/// from the three resistors (N).
struct PadReading {
    double height_m = 0.0;
    double force_N = 0.0;
};

/// Identifies the finger that lies on the platform: fits a, β and z₀ of FingerPadParameters by least squares
/// to F = (a/β)(e^{β(z − z₀)} − 1), which is linear for a given β. Radius, damping and relaxation are those
/// of `nominal`.
/// Errors: badInput if fewer than 20 readings lie between 0.05 and `most_N`, or if they do not rise with the
/// height.
core::Result<FingerPadParameters> fitPad(const std::vector<PadReading>& readings, double most_N,
                                         const FingerPadParameters& nominal);

/// Presses the finger three times up to 2.2 N with a level platform, and fits what the device's own sensors
/// reported while the force rose; readings on the way back, after relaxation, would make the pad look softer
/// than it is at the next press. `parameters.pad` is the finger that is pressed, which the fit does not know.
/// The same seed gives the sensors of FingertipPlatform with that seed. Takes some 10 ms; allocates, not for
/// the tick.
/// Errors: badInput if no finger is met within the travel or the motors do not press it that far, and as for
/// fitPad.
core::Result<FingerPadParameters> identifyPad(const FingertipPlatformParameters& parameters,
                                              std::uint64_t seed);

/// Returns `parameters` with the identified pad in the controller's parameters.
core::Result<FingertipPlatformParameters> worn(FingertipPlatformParameters parameters, std::uint64_t seed);

} // namespace chiron::mechanisms
