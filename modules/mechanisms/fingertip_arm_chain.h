// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mechanisms/fingertip_arm_parameters.h"

namespace chiron::mechanisms {

using FingertipArmDynamics = SerialChain<FingertipArmParameters::kJoints>;
/// Yaw, shoulder, elbow, wrist pitch, roll, yaw, jaw; rad.
using FingertipArmJoints = FingertipArmDynamics::Vector;

/// The links of the arm as a chain in D.
FingertipArmDynamics::Links fingertipArmLinks(const FingertipArmParameters& parameters) noexcept;

/// Position of the point where the wrist's axes meet, from the three joints that carry it:
///   p = s + R_z(q₁) (0, −ρ, −h),  ρ = l₁ cos q₂ + l₂ cos(q₂ + q₃),  h = l₁ sin q₂ + l₂ sin(q₂ + q₃),
/// where s is the shoulder. Pure.
/// Thread: any; allocates nothing.
class FingertipArmPlace {
public:
    explicit FingertipArmPlace(const FingertipArmGeometry& geometry = {}) noexcept : m_geometry(geometry) {}
    core::Vec3 place_D(const core::Vec3& joints) const noexcept;
    core::Mat3 jacobian(const core::Vec3& joints) const noexcept; ///< ∂p/∂q, m/rad
    /// Returns the ratio of the largest to the smallest singular value. It is infinite at a singularity: the
    /// arm is stretched or folded, or the pad is above the shoulder.
    static double conditionNumber(const core::Mat3& jacobian) noexcept;
    const FingertipArmGeometry& geometry() const noexcept { return m_geometry; }

private:
    FingertipArmGeometry m_geometry;
};

/// The reason why a pose has no joint angles.
enum class ArmReach {
    reached,
    notANumber,
    tooFar,       ///< beyond the stretched arm, or nearer than the folded one
    overShoulder, ///< straight above or below the shoulder: the yaw is undetermined
    gimbalLock,   ///< the wrist's first and third axes are in line: only their sum is determined
    beyondTravel  ///< a joint would have to exceed its travel
};
const char* wordsFor(ArmReach reach) noexcept;

struct ArmPosture {
    ArmReach reach = ArmReach::notANumber;
    FingertipArmJoints q = FingertipArmJoints::Zero(); ///< valid if reached; if beyond travel, the angles
                                                       ///< that would be needed
    int joint = -1;                                    ///< if beyond travel: the first such joint
};

/// Returns the joint angles for a pose of T, with the jaw as given and the elbow up, as the arm is built.
/// Closed form: law of cosines in the arm's plane, then R₃ᵀ R_DT = R_x R_y R_z. Poses within 1e-6 of a
/// singularity are refused.
/// Thread: any; allocates nothing.
ArmPosture fingertipArmPosture(const FingertipArmParameters& parameters, const core::Vec3& p_DT,
                               const core::Quat& q_DT, double jaw_rad = 0.0) noexcept;

} // namespace chiron::mechanisms
