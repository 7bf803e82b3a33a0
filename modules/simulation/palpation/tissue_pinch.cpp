// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/palpation/tissue_pinch.h"

#include "simulation/objects/grasp.h"

#include <algorithm>
#include <cmath>

namespace chiron::simulation {

using core::Vec3;

PinchResponse pinchTissue(const TissueContact& tissue, const PinchParameters& p, const core::ToolState& tool,
                          const TissueResponse& touched, PinchTouch& touch) noexcept {
    PinchResponse out;
    if (!touched.inContact || !(touched.depth_m > 0.0) || !std::isfinite(tool.jaw_rad) ||
        !tool.q_WT.coeffs().allFinite()) {
        touch.release();
        return out;
    }
    const double opening_m = JawGeometry{p.jawLength_m}.opening_m(std::min(tool.jaw_rad, p.widest_rad));
    touch.between_m = touch.inside ? std::max(touch.between_m, opening_m) : opening_m;
    out.compression_m = touch.between_m - opening_m;

    const double x = std::min(1.0, touched.depth_m / p.fullDepth_m);
    const double share = x * x * (3.0 - 2.0 * x), shareSlope_per_m = 6.0 * x * (1.0 - x) / p.fullDepth_m;
    const double half = 0.5 * tissue.normalStiffness_N_per_m() * out.compression_m;
    if (half > 0.0) {
        // The tool's own axes are used, because the surface's nearest point and normal change fast near its
        // centre of curvature.
        const Vec3 across = tool.q_WT * Vec3::UnitX();
        const Vec3 middle =
            tool.p_WT + 0.5 * std::min(touched.depth_m, p.fullDepth_m) * (tool.q_WT * Vec3::UnitZ());
        LumpsAcross lumps;
        for (const double side : {0.5, -0.5})
            tissue.addLumpsAcross(middle + side * opening_m * across, across, lumps);
        const double gain = 0.5 * lumps.gain;
        out.force_N = half * (1.0 + gain) * share;
        out.beyondChecked = lumps.beyondChecked;
        out.squeezeStiffness_N_per_m =
            half * ((1.0 + gain) * shareSlope_per_m + 0.75 * lumps.slope_per_m * share);
    }

    // The hold is a spring from where the tissue was taken, limited by friction.
    if (touch.inside)
        touch.stretch_m += tool.p_WT - touch.previous_W;
    touch.inside = true;
    touch.previous_W = tool.p_WT;
    const double stiffness = tissue.tangentStiffness_N_per_m();
    const double limit_N = gripLimit_N(p.friction, out.force_N);
    const double pull_N = stiffness * touch.stretch_m.norm();
    if (pull_N > limit_N)
        touch.stretch_m *= limit_N / pull_N;
    out.hold = -stiffness * touch.stretch_m;
    out.energy_J = 0.5 * stiffness * touch.stretch_m.squaredNorm();
    if (out.force_N > 0.0)
        out.stiffness_N_per_m = stiffness + 2.0 * p.friction * out.squeezeStiffness_N_per_m;
    return out;
}

} // namespace chiron::simulation
