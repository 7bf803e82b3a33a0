// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "simulation/yield.h"

#include <cstdint>
#include <string>
#include <vector>

namespace chiron::simulation {

/// Surface model of the hemisphere and its plane.
enum class ApexSurface : std::uint8_t {
    exact, ///< a ball and a plane as formulas (HemisphereContact): levels 1 to 4
    mesh,  ///< a watertight mesh with bumps, friction and roughness (P2 "Deformation", figure 6)
    organ, ///< the same mesh as a deformable organ at two rates (P2 "Haptic-Visual Graphic Integration")
};

/// One level of the sphere-apex exercise (models.md §2.3), filled from content by the catalogue, which also
/// checks the ranges. Lengths m, stiffness N/m, damping N·s/m.
struct SphereApexParameters {
    double radius_m = 0.020;             ///< P2: 20 mm
    double planeHeight_m = 0.0;          ///< z of the plane in W
    double centreDiscRadius_m = 0.040;   ///< centres are uniform in this disc around the workspace centre
    double workspaceRadius_m = 0.065;    ///< all of the sphere lies inside this disc (x, y)
    double stiffnessLow_N_per_m = 500.0; ///< each trial draws k uniformly in [low, high]; equal ends fix it
    double stiffnessHigh_N_per_m = 500.0;
    /// Spatial: k(x,y) = k(1 + a·g(x,y)), |g| ≤ 1, 0 ≤ a < 1; U = ½ k(x,y) d².
    double stiffnessVariation = 0.0;
    double stiffnessWavelength_m = 0.030; ///< of g
    double damping_Ns_per_m = 1.0;        ///< along n, weighted by min(1, d/0.5 mm); contact never pulls
    double frictionLow = 0.0;             ///< Coulomb μ; each trial draws in [low, high]
    double frictionHigh = 0.0;
    double bristleStiffness_N_per_m = 1000.0; ///< σ₀ of the clipped bristle (models.md §2.2)
    double dimpleDepth_m = 0.0;               ///< decoy: smooth dimple on the ball; 0 = none
    double dimpleRadius_m = 0.006;            ///< its half-width across the surface
    double dimpleOffset_m = 0.010;            ///< horizontal distance from the apex; direction by seed
    ApexSurface surface = ApexSurface::exact;
    // mesh and organ: the generated dome (geometry/mesh/make_mesh.h); stiffness_* is then that of the local
    // model
    double meshEdge_m = 0.0015; ///< mean edge length
    double bumpHeight_m = 0.0;  ///< of smooth bumps; none at the apex, which stays the highest point
    double bumpWavelength_m = 0.009;
    /// Seed of the bumps' pattern; each trial rotates the pattern about the vertical by its own angle.
    std::uint64_t bumpSeed = 1;
    double roughness_m = 0.0;             ///< rms of the micro-height (attributes/roughness.h)
    double roughnessWavelength_m = 0.002; ///< shortest; >= 1 mm
    // organ: the slow model (deformable/spring_network.h)
    double organStiffness_N_per_m = 900.0; ///< K: a lasting press feels k K/(k + K)
    double organSpread_m = 0.006;
    double organMass_kg = 0.030;
    double organRecoveryTime_s = 0.060;
    double organVolumeKeeping = 0.7;
    double organDeepest_m = 0.008;
    int slowPeriod_ms = 33;  ///< between two requests to the slow model; also the length of its step
    int slowLatency_ms = 33; ///< L, 20 to slowPeriod_ms; blending takes the same time
    int trials = 10;         ///< 1..32
    double trialLimit_s = 60.0;
    double betweenTrials_s = 1.0;  ///< after a mark, before the next scene appears
    double maximumForce_N = 4.0;   ///< the exercise's cap for the supervisor and the limit of force metrics
    YieldLaw yield;                ///< when the touched tissue gives way; by default never
    std::vector<std::string> cues; ///< object, tool, arrow, bars, numbers, plots, sound, coverage
};

} // namespace chiron::simulation
