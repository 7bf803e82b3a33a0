// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/exercise.h"
#include "core/geometry.h"
#include "simulation/attributes/object_attributes.h"

#include <cstdint>
#include <vector>

namespace chiron::tests {

/// What a level's content says of how far its forces may go and how fast they may change, and of where a hand
/// has to go. Read from the content, not from the scene: the keys that every exercise has in common here,
/// the others by the exercise's own SweepFacts. What a scene states in each tick (stiffness, damping) is not
/// here.
/// Unit: SI.
struct LevelNumbers {
    bool givesWay = true;  ///< its content has to say at which force
    double yield_N = 0.0;  ///< 0: never
    double yield_Nm = 0.0; ///< 0: never
    double fall_ms = 20.0;
    double breaks_N_per_ms = 0.0; ///< how fast the force may fall where something is meant to break
    double friction = 0.0; ///< μ, the largest that may be drawn: what presses harder also drags harder
    /// σ₀ of the bristles that may act at once, where μ > 0: a stiffness across, which scenes do not report.
    double bristle_N_per_m = 0.0;
    /// How fast the slope of a rough surface changes along it, 1/m (roughCurvature_per_m).
    double rough_per_m = 0.0;
    double turn_per_m = 0.0; ///< how fast the normal of a smooth surface turns at most
    /// Of the surfaces that recover and may act at once: their k₁ in all, and their shortest τ.
    double relaxing_N_per_m = 0.0, relaxes_s = 1.0;
    double turn_Nm_per_rad = 0.0; ///< how stiff the tissue turns the tool back; 0: not at all
    /// The same for a way: the canal turns along it, the pivot's lever, and it gets stiffer.
    double turn_Nm_per_m = 0.0;
    double shaft_m = 0.0; ///< radius: at which forces turn the tool, and at which its spin rubs

    std::vector<core::Vec3> way_W{};    ///< a way that nobody meets by chance, to be gone again and again
    std::vector<core::Vec3> places_W{}; ///< to be gone to by chance; empty: anywhere about the origin of W
    /// What a study's runner may present (core/presentation_word.h); 0: the level plans its own trials.
    std::uint64_t candidates = 0;
    std::uint64_t arrangements = 0;
};

LevelNumbers numbersOf(const catalogue::ExerciseLevel& level);

/// Adds one more surface that may be touched at the same time.
void addSurface(LevelNumbers& numbers, const simulation::ObjectAttributes& surface);

/// 2 rms (2π/λ)², four standard deviations of the curvature along a track (waves of one length in all
/// directions: rms (2π/λ)²/√5); 0 where nothing is rough.
double roughCurvature_per_m(double rms_m, double wavelength_m);

} // namespace chiron::tests
