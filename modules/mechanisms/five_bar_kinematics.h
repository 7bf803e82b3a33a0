// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"
#include "core/result.h"

#include <Eigen/Core>

#include <array>

namespace chiron::mechanisms {

/// Lengths of the five-bar linkage, m. P1 prints none, so every value is an ASSUMPTION. They come from a
/// search over lengths and base positions, at l1 + l2 = 0.36 m, for the smallest ratio of the Jacobian's
/// largest to its smallest singular value anywhere in the workspace that urethra insertion needs (y_D
/// −75…65 mm, z_D −20…135 mm): ratio 1.9, condition number ≤ 1.85.
struct FiveBarGeometry {
    double proximal_m = 0.140;     ///< l1, base joint to elbow, both legs
    double distal_m = 0.220;       ///< l2, elbow to tip, both legs
    double halfBase_m = 0.060;     ///< half the distance between the base joints
    double baseForward_m = -0.005; ///< y_D of the base's middle
    double baseUp_m = -0.175;      ///< z_D of the base joints: the linkage stands beneath its workspace
};

/// The closed loop at one pair of base angles. Plane vectors are (X_V, Y_V) = (y_D, z_D), m.
struct FiveBarLoop {
    std::array<core::Vec2, 2> elbow{core::Vec2::Zero(), core::Vec2::Zero()};   ///< P_i
    std::array<core::Vec2, 2> tangent{core::Vec2::Zero(), core::Vec2::Zero()}; ///< ∂P_i/∂θ_i
    core::Vec2 tip = core::Vec2::Zero();                                       ///< X
    Eigen::Matrix2d jacobian = Eigen::Matrix2d::Zero();                        ///< Ẋ = J θ̇, m/rad
    double determinant = 0.0; ///< det A, m²: zero where the distal links are in line
    bool closed = true;       ///< the links meet: 0 < D ≤ 2 l2

    /// Returns the acceleration of the tip when the base angles do not accelerate, from (X−P_i)·(Ẍ−P̈_i) =
    /// −|Ẋ−Ṗ_i|².
    core::Vec2 biasAcceleration(const core::Vec2& rates) const noexcept;
    /// Returns the centripetal acceleration of an elbow at constant rate: −l1 θ̇² (cos θ, sin θ).
    core::Vec2 elbowBias(int leg, double rate) const noexcept;
};

/// P1's five-bar linkage in the patient's plane of symmetry (P1 §2; equations devices.md §5):
///   P_i = A_i + l1 (cos θ_i, sin θ_i),  D = |P2 − P1|,  û = (P2 − P1)/D,  X = P1 + û D/2 + û⊥ √(l2² − D²/4);
///   J = A⁻¹B, rows of A: (X − P_i)ᵀ, B_ii = (X − P_i)·l1(−sin θ_i, cos θ_i);  τ = JᵀF
/// It is singular where det A = 0.
/// Vendor axes V: X_V = y_D (into the patient), Y_V = z_D (up), Z_V = x_D (normal to the plane); same origin.
/// Angles are measured from X_V towards Y_V. Leg 1 is on the trainee's side with its elbow towards them, leg
/// 2 beyond: there is one assembly mode. Only toD() and toPlane() convert between V and D. Pure.
/// Thread: any; allocates nothing.
class FiveBarKinematics {
public:
    explicit FiveBarKinematics(const FiveBarGeometry& geometry = {}) noexcept : m_geometry(geometry) {}

    static core::Vec3 toD(const core::Vec2& v_V) noexcept { return {0.0, v_V.x(), v_V.y()}; }
    static core::Vec2 toPlane(const core::Vec3& v_D) noexcept { return {v_D.y(), v_D.z()}; }

    const FiveBarGeometry& geometry() const noexcept { return m_geometry; }
    FiveBarLoop loop(double theta1, double theta2) const noexcept;
    core::Vec3 tip_D(double theta1, double theta2) const noexcept { return toD(loop(theta1, theta2).tip); }

    /// Returns (θ1, θ2) for a tip in D; its x_D is ignored (the linkage cannot leave the plane). θ1 ∈ (0,
    /// 2π), θ2 ∈ (−π, π).
    /// Errors: badInput where a leg cannot reach the tip or the loop would have to be in the other assembly
    /// mode.
    core::Result<std::array<double, 2>> inverse(const core::Vec3& p_DT) const;

    /// Returns the base torques that put the in-plane part of the force on the tool: Jᵀ F (N·m).
    static core::Vec2 efforts(const FiveBarLoop& loop, const core::Vec3& force_D) noexcept {
        return loop.jacobian.transpose() * toPlane(force_D);
    }
    /// Returns the force in D that base torques give: J⁻ᵀ τ.
    static core::Vec3 force_D(const FiveBarLoop& loop, const core::Vec2& efforts) noexcept;
    /// Returns the ratio of J's largest to its smallest singular value, ≥ 1.
    static double conditionNumber(const FiveBarLoop& loop) noexcept;

private:
    FiveBarGeometry m_geometry;
};

} // namespace chiron::mechanisms
