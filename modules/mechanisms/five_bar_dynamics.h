// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mechanisms/five_bar_plant_parameters.h"
#include "mechanisms/spherical_joint.h"

#include <Eigen/Core>

namespace chiron::mechanisms {

using FiveBarVector = Eigen::Matrix<double, 5, 1>; ///< (theta1, theta2, pitch, yaw, roll)
using FiveBarMatrix = Eigen::Matrix<double, 5, 5>;

/// Dynamics of the mechanism's links and the endoscope at one configuration (Kane's form, exact):
///   M(q) q̈ + h(q, q̇) + (1 − κ) g(q) = torques at the joints,
/// where M = Σ m v_k·v_l + e_k·I e_l over bodies (v_k, e_k: partial velocities of the centre of mass and
/// partial angular velocities). A uniform tube between ends P and X has kinetic energy m/6 (Ṗ² + Ṗ·Ẋ + Ẋ²).
/// The endoscope is a body of revolution on the spherical joint with its centre of mass c behind the tip,
/// which couples translation and rotation. κ is the share of the weight that is counterbalanced; D's z points
/// up. The generalised coordinates are those of the encoders: the pitch axis counts from its mounting zero.
/// Source: devices.md §5.
/// Thread: haptic; allocates nothing.
class FiveBarDynamics {
public:
    explicit FiveBarDynamics(const FiveBarPlantParameters& parameters) noexcept;

    void place(const FiveBarVector& q) noexcept; ///< sets the configuration to which everything below refers

    const FiveBarLoop& loop() const noexcept { return m_loop; }
    const SphericalJoint& joint() const noexcept { return m_joint; }

    FiveBarMatrix inertia() const noexcept;
    FiveBarVector bias(const FiveBarVector& rates) const noexcept; ///< h: Coriolis and centrifugal terms
    FiveBarVector gravity() const noexcept;                        ///< g, without κ
    double potential_J() const noexcept;                           ///< of the total weight, without κ
    /// Returns the torques at the joints that correspond to a wrench on the tool at the tip.
    FiveBarVector efforts(const core::Wrench& wrench_D) const noexcept;
    /// Returns the wrench that torques at the joints give the tool, without a force normal to the plane.
    core::Wrench wrench_D(const FiveBarVector& efforts) const noexcept;

    /// Returns M⁻¹ b for a symmetric positive definite M, by L D Lᵀ in place; reads the upper half.
    static FiveBarVector solve(FiveBarMatrix m, FiveBarVector b) noexcept;

private:
    core::Vec3
    inertiaTimes(const core::Vec3& w) const noexcept; ///< of the endoscope, about its centre of mass

    FiveBarPlantParameters m_parameters;
    FiveBarKinematics m_kinematics;
    FiveBarLoop m_loop;
    SphericalJoint m_joint;
    core::Vec3 m_behind = core::Vec3::Zero(); ///< from the tip to the endoscope's centre of mass
    std::array<core::Vec3, 5> m_partial{};    ///< partial velocities of that centre
};

} // namespace chiron::mechanisms
