// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"
#include "core/result.h"

#include <Eigen/Core>

namespace chiron::mechanisms {

/// Generalised coordinates of P2's gimbal: heading h, pitch p, roll r (rad), depth d (m, pivot to tip, > 0).
struct GimbalCoordinates {
    double h = 0.0;
    double p = 0.0;
    double r = 0.0;
    double d = 0.18;
};

using GimbalVector = Eigen::Vector4d;               ///< (h, p, r, d): rates, efforts (N·m, N·m, N·m, N)
using GimbalJacobian = Eigen::Matrix<double, 6, 4>; ///< linear then angular velocity in D from (ḣ, ṗ, ṙ, ḋ)

/// Forces along heading, pitch and depth in newtons: P2's F_h, F_p, F_d. The torques are F_h·d cos p and
/// F_p·d.
struct PolarForces {
    double heading_N = 0.0;
    double pitch_N = 0.0;
    double depth_N = 0.0;
};

/// The map from a Cartesian force to axis efforts.
enum class PolarMap {
    exact,       ///< τ = Jᵀf, conserves power; the default
    asPublished, ///< P2's three formulas, exact only where h or p is zero (models.md §2.1)
};

/// P2's H,P,R,D gimbal, right-handed, SI.
///
/// Vendor axes V (P2, figure 5): the origin is the gimbal's pivot, and z points along the instrument when h =
/// p = 0, so that
///   tip_V = d·u,  u = (sin h cos p, sin p, cos h cos p).
/// D (device base): its origin is the point of the table under the pivot, z up. The gimbal stands over the
/// table and the instrument points down, so V is D turned by 180° about x and lifted; this is the only place
/// where the axes are swapped:
///   p_D = R_DV p_V + (0, 0, pivotHeight),  R_DV = diag(1, −1, −1).
/// Heading to the right is +x_D, pitch towards −y_D. The tool frame T equals D at h = p = r = 0:
///   R_DT = R_DV · R_y(h) R_x(−p) R_z(r) · R_VD.
/// Singular where d cos p = 0. Pure functions. Source: models.md §2.1, devices.md §5.
/// Thread: any; allocates nothing.
class GimbalKinematics {
public:
    explicit GimbalKinematics(double pivotHeight_m = kDefaultPivotHeight_m) noexcept
        : m_pivotHeight_m(pivotHeight_m) {}

    /// Assumption (P2 prints no dimensions): 0.18 m brings a disc of 65 mm radius on the table within ±20° of
    /// the vertical, inside P2's range.
    static constexpr double kDefaultPivotHeight_m = 0.18;

    double pivotHeight_m() const noexcept { return m_pivotHeight_m; }

    /// R_DV = R_VDᵀ = diag(1, −1, −1): directions (and forces) from vendor axes to D, and back.
    static core::Vec3 directionToD(const core::Vec3& v_V) noexcept { return {v_V.x(), -v_V.y(), -v_V.z()}; }
    static core::Vec3 directionToVendor(const core::Vec3& v_D) noexcept { return directionToD(v_D); }

    static core::Vec3 axis_V(double h, double p) noexcept; ///< u, unit, vendor axes
    core::Vec3 tip_D(const GimbalCoordinates& q) const noexcept;
    core::Quat orientation_DT(const GimbalCoordinates& q) const noexcept;

    /// Returns (h, p, d) for a tip in D, with the given roll. |h|, |p| < 90°.
    /// Errors: badInput if the tip is level with or above the pivot, or within 1 mm of it.
    core::Result<GimbalCoordinates> inverse(const core::Vec3& p_DT, double roll_rad = 0.0) const;

    GimbalJacobian jacobian_D(const GimbalCoordinates& q) const noexcept;

    /// Returns the efforts (N·m, N·m, N·m, N) that put `wrench_D` on the tool at the tip. asPublished uses
    /// P2's force formulas with lever arms d cos p and d; torque always goes through Jᵀ.
    static GimbalVector efforts(const GimbalCoordinates& q, const core::Wrench& wrench_D,
                                PolarMap map) noexcept;
    /// Returns the force on the tool in D that heading, pitch and depth efforts really give: J⁻ᵀτ (roll
    /// carries none).
    static core::Vec3 force_D(const GimbalCoordinates& q, const GimbalVector& efforts) noexcept;

    /// P2: F_h = F_x cos h − F_z sin h, F_p = F_y cos p − F_z sin p, F_d = F_x sin h + F_y sin p + F_z cos h
    /// cos p.
    static PolarForces polarAsPublished(double h, double p, const core::Vec3& f_V) noexcept;
    /// The same three from τ = Jᵀf: τ_h/(d cos p), τ_p/d, F_d. Orthonormal: the norm is the force's.
    static PolarForces polarExact(double h, double p, const core::Vec3& f_V) noexcept;
    /// P2's weight: F_h = mg sin h, F_p = mg sin p, F_d = mg cos h cos p, literally. These are not the image
    /// of one force under P2's own map (models.md §2.1), so the function is for evaluation only and is never
    /// rendered.
    static PolarForces weightAsPublished(double h, double p, double mass_kg) noexcept;

private:
    double m_pivotHeight_m;
};

} // namespace chiron::mechanisms
