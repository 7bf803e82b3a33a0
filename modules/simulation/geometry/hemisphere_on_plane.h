// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"

#include <cmath>

namespace chiron::simulation {

/// Distance to the nearest point of a surface, as a contact needs it. `normal` is the outward unit vector;
/// nearest = p − signedDistance·normal.
struct SurfaceDistance {
    double signedDistance_m = 0.0; ///< negative inside; depth d = −signedDistance
    core::Vec3 normal = core::Vec3::UnitZ();
};

/// The union of the half-space under a horizontal plane and a ball whose centre lies in that plane (models.md
/// §2.3).
///
/// The function gives the distance to the *boundary of the union*, with ζ = z − plane height, ρ = horizontal
/// distance from the axis and r = √(ρ²+ζ²):
///   outside (ζ > 0, r > R):  min(r − R, ζ)
///   in the ball, ζ ≥ 0:      −(R − r),                n = (p − c)/r
///   ζ < 0, ρ ≥ R:            ζ,                       n = +z
///   ζ < 0, ρ < R:            −√((R−ρ)² + ζ²),         n towards the rim circle, the nearest point of the
///   union
/// The distance is continuous everywhere. d·n is continuous too (inside, except on the axis below the
/// centre, ≥ R deep), so the force k·d·n changes by at most k·max(1, R/r − 1) per metre and is the gradient
/// of ½ k d²: loops create no energy. (The alternative "the deeper contact wins" jumps at the rim.) On the
/// axis, where the nearest point is not unique, the normal is +z at the centre and +x below it.
/// Unit: m.
/// Frame: W.
struct HemisphereOnPlane {
    double radius_m = 0.020;                  ///< > 0; P2: 20 mm
    double planeHeight_m = 0.0;               ///< z in W
    core::Vec2 centre_m = core::Vec2::Zero(); ///< x, y in W

    /// Pure; defined for every finite p. Always inlined, because a result that is passed through memory is
    /// read back as vectors, which costs a third of the force law.
    /// Thread: any.
    [[gnu::always_inline]] SurfaceDistance distance(const core::Vec3& p_WT) const noexcept {
        const double dx = p_WT.x() - centre_m.x();
        const double dy = p_WT.y() - centre_m.y();
        const double zeta = p_WT.z() - planeHeight_m;
        return zeta >= 0.0 ? above(dx, dy, zeta) : below(dx, dy, zeta);
    }

private:
    [[gnu::always_inline]] SurfaceDistance above(double dx, double dy, double zeta) const noexcept {
        const double r = std::sqrt(dx * dx + dy * dy + zeta * zeta);
        const double toBall = r - radius_m;
        if (toBall > zeta)
            return {zeta, core::Vec3::UnitZ()};
        if (r <= 0.0)
            return {toBall, core::Vec3::UnitZ()};
        const double inverse = 1.0 / r;
        return {toBall, core::Vec3(dx * inverse, dy * inverse, zeta * inverse)};
    }

    SurfaceDistance below(double dx, double dy, double zeta) const noexcept {
        const double rho2 = dx * dx + dy * dy;
        if (rho2 >= radius_m * radius_m)
            return {zeta, core::Vec3::UnitZ()};
        const double rho = std::sqrt(rho2);
        const double toRim = radius_m - rho;
        const double depth = std::sqrt(toRim * toRim + zeta * zeta);
        if (depth <= 0.0) // within rounding of the rim circle itself
            return {0.0, core::Vec3::UnitZ()};
        const double ux = rho > 0.0 ? dx / rho : 1.0;
        const double uy = rho > 0.0 ? dy / rho : 0.0;
        const double inverse = 1.0 / depth;
        return {-depth, core::Vec3(toRim * ux * inverse, toRim * uy * inverse, -zeta * inverse)};
    }
};

} // namespace chiron::simulation
