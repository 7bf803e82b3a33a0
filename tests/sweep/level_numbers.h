// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/exercise.h"

namespace chiron::tests {

/// What a level's content says of how far its forces may go and how fast they may change. Read from the
/// content, not from the scene. What a scene states in each tick (stiffness, damping) is not here.
/// Unit: SI.
struct LevelNumbers {
    double yield_N = 0.0;  ///< 0: never
    double yield_Nm = 0.0; ///< 0: never
    double fall_ms = 20.0;
    double friction = 0.0; ///< μ, the largest that may be drawn: what presses harder also drags harder
    /// σ₀ of the bristles that may act at once, where μ > 0: a stiffness across, which scenes do not report.
    /// (Palpation reports its own.)
    double bristle_N_per_m = 0.0;
    /// How fast the slope of a rough surface changes along it, 1/m: 2 rms (2π/λ)², four standard deviations
    /// of the curvature along a track (waves of one length in all directions: rms (2π/λ)²/√5).
    double rough_per_m = 0.0;
    double turn_Nm_per_rad = 0.0; ///< how stiff the tissue turns the tool back; 0: not at all
    /// The same for a way: the canal turns along it, the pivot's lever, and it gets stiffer.
    double turn_Nm_per_m = 0.0;
    double shaft_m = 0.0; ///< radius: at which forces turn the tool, and at which its spin rubs
};

LevelNumbers numbersOf(const catalogue::ExerciseLevel& level);

} // namespace chiron::tests
