// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"
#include "core/result.h"
#include "core/units.h"

#include <array>

namespace chiron::mechanisms {

/// Lengths of P3's reverse linear delta, m. P3 prints none. r is that of devices.md §5; the rest are
/// ASSUMPTIONS: rails beside a finger 16 mm wide, and legs at 13° to the vertical when level, so that they
/// push straight.
struct FingertipGeometry {
    double railRadius_m = 0.017;     ///< R0: distance of the three vertical rails from the finger's axis
    double platformRadius_m = 0.012; ///< r: radius of the joints on the platform
    double leg_m = 0.022;            ///< L
    double minimumZ_m = -0.008;      ///< travel of the platform's middle; 0: level, just touching a pad
    double maximumZ_m = 0.008;
    double maximumPitch_rad = core::radFromDeg(30.0); ///< P3
    double maximumRoll_rad = core::radFromDeg(20.0);  ///< P3
};

/// Pose of the platform: height along the rails (m), pitch β about x, roll α about y (rad).
struct FingertipPose {
    double z_m = 0.0;
    double pitch_rad = 0.0;
    double roll_rad = 0.0;
    core::Vec3 vector() const noexcept { return {z_m, pitch_rad, roll_rad}; }
    static FingertipPose of(const core::Vec3& v) noexcept { return {v[0], v[1], v[2]}; }
};

/// All kinematic quantities at one pose. Frame F: x across the finger, y along it, z towards the pad; its
/// origin lies on the axis of the rails.
struct FingertipLoop {
    core::Vec3 centre = core::Vec3::Zero();   ///< c = (c_x, c_y, z)
    core::Mat3 turn = core::Mat3::Identity(); ///< M
    core::Vec3 normal{0.0, 0.0, 1.0};         ///< of the platform: (sin α, −sin β cos α, cos β cos α)
    core::Vec3 drives = core::Vec3::Zero();   ///< q_i, m
    core::Mat3 jacobian = core::Mat3::Identity(); ///< G = ∂q/∂(z, β, α)
    core::Mat3 centreBy = core::Mat3::Zero();     ///< ∂c/∂(z, β, α), columns
    core::Mat3 normalBy = core::Mat3::Zero();     ///< ∂n/∂(z, β, α), columns
    bool reached = true;                          ///< every leg is long enough
};

/// P3's platform: three vertical rails at radius R0 and angles φ_i = 0°, 120°, 240°, with legs of length L to
/// the joints at radius r (devices.md §5):
///   p_i = c + M r (cos φ_i, sin φ_i, 0),  s_i = R0 − (cos φ_i p_ix + sin φ_i p_iy),  q_i = p_iz − √(L² −
///   s_i²).
/// Legs that are confined to radial planes force M₁₂ = M₂₁, c_x = r(M₁₁ − M₂₂)/2, c_y = −r M₂₁ with M =
/// R_x(β) R_y(α) R_z(γ), γ = atan2(M⁰₁₂ − M⁰₂₁, M⁰₁₁ + M⁰₂₂) from M⁰ = R_x(β) R_y(α). P3 does not state which
/// joints it used. With q˙ = G (z˙, β˙, α˙), drive forces f give the platform the force Gᵀ f. The pose is
/// singular where det G = 0 or a leg lies flat. Pure.
/// Thread: any; allocates nothing.
class FingertipKinematics {
public:
    explicit FingertipKinematics(const FingertipGeometry& geometry = {}) noexcept : m_geometry(geometry) {}

    const FingertipGeometry& geometry() const noexcept { return m_geometry; }
    FingertipLoop loop(const FingertipPose& pose) const noexcept;
    /// Returns q_i, m.
    /// Errors: badInput beyond the travel, where a leg does not reach, or near a singular pose.
    core::Result<core::Vec3> inverse(const FingertipPose& pose) const;
    /// Finds the pose for three drive positions by Newton's method, with the given `pose` as first guess;
    /// returns true if it converged within 1e-14 m.
    bool forward(const core::Vec3& drives, FingertipPose& pose) const noexcept;
    /// Starts from level.
    /// Errors: badInput as for inverse().
    core::Result<FingertipPose> forward(const core::Vec3& drives) const;

    /// Returns the drive forces (N) that give the platform the generalised force Q = (F_z, τ_β, τ_α): G⁻ᵀ Q.
    static core::Vec3 driveForces(const FingertipLoop& loop, const core::Vec3& onPlatform) noexcept {
        return loop.jacobian.transpose().partialPivLu().solve(onPlatform);
    }
    static core::Vec3 onPlatform(const FingertipLoop& loop, const core::Vec3& driveForces) noexcept {
        return loop.jacobian.transpose() * driveForces;
    }
    FingertipPose limited(const FingertipPose& pose) const noexcept; ///< clamps to the travel

    static constexpr double kLeastLegRise = 0.2; ///< √(L² − s²)/L below which a leg lies too flat to push
    static constexpr double kLeastDeterminant = 0.02; ///< of det G/r², which is 3√3/2 at level

private:
    FingertipGeometry m_geometry;
};

} // namespace chiron::mechanisms
