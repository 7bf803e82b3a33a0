// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"

#include <cstddef>
#include <string>
#include <vector>

namespace chiron::simulation {

/// One elevation of a tissue's surface: z rises by height · (1 − t²)³ where t < 1, t² = (x'/rx)² + (y'/ry)²
/// in the bump's own axes (turned by `turn_rad` about z). Twice continuously differentiable, so normals and
/// curvature have no steps.
struct SurfaceBump {
    core::Vec2 centre_m = core::Vec2::Zero(); ///< x, y in W
    core::Vec2 radii_m{0.03, 0.03};
    double turn_rad = 0.0;
    double height_m = 0.01; ///< < 0: a furrow
};

/// The surface z = planeHeight + Σ bumps; the tissue lies below it.
struct SurfaceShape {
    static constexpr std::size_t kMaxBumps = 4;
    double planeHeight_m = 0.0;
    std::vector<SurfaceBump> bumps; ///< none: flat
};

/// One layer of the tissue. Layers are listed from the surface down; the last one has no lower end.
struct TissueLayer {
    std::string name;         ///< "skin", "fat", ...
    double thickness_m = 0.1; ///< > 0; not used for the last layer
    double modulus_Pa = 17e3; ///< Young's modulus
};

/// A stiff ball in the tissue. Its depth is that of its centre below the surface, along the normal there.
struct Lump {
    core::Vec2 place_m = core::Vec2::Zero(); ///< x, y in W of the surface point above it
    double depth_m = 0.012;
    double radius_m = 0.0075;
    double ratio = 10.0; ///< ratio of its modulus to the tissue's; 1: cannot be felt
};

/// A stiffer (or softer) region that is normal anatomy: U = ½ k d² (1 + gain·(1 − t²)³), t as in SurfaceBump.
struct StiffRegion {
    std::string name;
    core::Vec2 centre_m = core::Vec2::Zero();
    core::Vec2 radii_m{0.01, 0.01};
    double turn_rad = 0.0;
    double gain = 0.3; ///< > -1
};

/// How the contact point is found.
enum class TissueContactLaw {
    anchored, ///< nearest surface point; tangential stiffness acts on a clipped bristle (models.md §3)
    /// P3 as worded: the ray along the instrument is cast again in each tick; creates energy (`conservative:
    /// false`).
    p3Recast,
};

/// How a lump is felt.
enum class LumpLaw {
    inclusion, ///< χ of models.md §3 in the potential: felt before it is touched, with its lateral force
    secondSurface, ///< P3: a second surface below adds its own contact force along its own normal
    /// As published elsewhere: (1 + χ)·k·d along the normal, no lateral part; creates energy.
    stiffnessTimesDepth
};

/// A tissue to be palpated, as the finger touches it (P3 and models.md §3). The catalogue checks the ranges.
struct TissueParameters {
    static constexpr std::size_t kMaxLayers = 4;
    static constexpr std::size_t kMaxRegions = 4;
    static constexpr std::size_t kMaxLumps = 6;

    SurfaceShape shape;
    std::vector<TissueLayer> layers{{"gland", 0.1, 17e3}}; ///< 1..kMaxLayers
    double poisson = 0.5;
    double contactRadius_m = 0.005; ///< a, of the finger's pad
    double stiffness_N_per_m = 0.0; ///< along the normal (P3's third of K); 0: from layers and contact radius
    double tangentAlong_N_per_m = 800.0;        ///< K along the fibres, x of the contact frame (P3, fig. 6)
    double tangentAcross_N_per_m = 700.0;       ///< K across them
    core::Vec3 fibreDirection{1.0, 0.0, 0.0};   ///< W; projected on the contact plane
    double friction = 0.2;                      ///< μ; limits the lateral bristle
    core::Vec3 damping_Ns_per_m{2.0, 2.0, 2.0}; ///< B along, across, normal
    double dampingDepth_m = 0.001;              ///< damping fades in with a smoothstep over this depth
    double sinkage = 0.25; ///< λ: share of the depth by which the contact approaches a lump
    TissueContactLaw contact = TissueContactLaw::anchored;
    LumpLaw lumps = LumpLaw::inclusion;
    double secondStiffness_N_per_m = 1200.0; ///< of a lump's own surface, for LumpLaw::secondSurface
    std::vector<StiffRegion> regions;        ///< 0..kMaxRegions: distractors

    /// Says whether its elastic force has a potential: two of the published variants have none.
    bool conservative() const noexcept {
        return contact != TissueContactLaw::p3Recast && lumps != LumpLaw::stiffnessTimesDepth;
    }
};

} // namespace chiron::simulation
