// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mechanisms/fingertip_arm_parameters.h"

namespace chiron::mechanisms {

using FingertipArmDynamics = SerialChain<FingertipArmParameters::kJoints>;
using FingertipArmJoints = FingertipArmDynamics::Vector; ///< yaw, shoulder, elbow, wrist pitch, roll, yaw, jaw; rad

/// The links of the arm as a chain in D.
FingertipArmDynamics::Links fingertipArmLinks(const FingertipArmParameters& parameters) noexcept;

/// Where the wrist's axes meet, by the three joints that carry it:
///   p = s + R_z(q₁) (0, −ρ, −h),  ρ = l₁ cos q₂ + l₂ cos(q₂ + q₃),  h = l₁ sin q₂ + l₂ sin(q₂ + q₃),
/// s the shoulder. Pure, no allocation; any thread.
class FingertipArmPlace {
public:
    explicit FingertipArmPlace(const FingertipArmGeometry& geometry = {}) noexcept : m_geometry(geometry) {}
    core::Vec3 place_D(const core::Vec3& joints) const noexcept;
    core::Mat3 jacobian(const core::Vec3& joints) const noexcept; ///< ∂p/∂q, m/rad
    /// Ratio of the largest to the smallest singular value; infinite where singular: the arm stretched or folded, or the pad above the shoulder.
    static double conditionNumber(const core::Mat3& jacobian) noexcept;
    const FingertipArmGeometry& geometry() const noexcept { return m_geometry; }

private:
    FingertipArmGeometry m_geometry;
};

/// Why a pose has no joint angles.
enum class ArmReach {
    reached,
    notANumber,
    tooFar,      ///< beyond the stretched arm, or nearer than the folded one
    overShoulder, ///< straight above or below the shoulder: the yaw is anything
    gimbalLock,  ///< the wrist's first and third axes are in line: only their sum is determined
    beyondTravel ///< a joint would have to be beyond its travel
};
const char* wordsFor(ArmReach reach) noexcept;

struct ArmPosture {
    ArmReach reach = ArmReach::notANumber;
    FingertipArmJoints q = FingertipArmJoints::Zero(); ///< valid where reached; beyond travel: what it would have to be
    int joint = -1;                                    ///< beyond travel: the first of them
};

/// Joint angles of a pose of T, the jaw as given; elbow up, as the arm is built. Closed form: law of cosines in the arm's plane, then
/// R₃ᵀ R_DT = R_x R_y R_z. Singular within 1e-6 of it. Pure, no allocation; any thread.
ArmPosture fingertipArmPosture(const FingertipArmParameters& parameters, const core::Vec3& p_DT, const core::Quat& q_DT, double jaw_rad = 0.0) noexcept;

} // namespace chiron::mechanisms
