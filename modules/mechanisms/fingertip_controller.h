// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tool_state.h"
#include "mechanisms/finger_pad.h"

namespace chiron::mechanisms {

/// What drives the three motors (FingertipControlParameters). The lean goes to the position loop alone; the force loop moves the
/// height at which that lean is held:
///   z_ref = height at which the pad that was measured gives F_ref at this lean + u,  u˙ = Kp(F_ref − F) + Kd d/dt(F_ref − F),
///   f = PID(q(z_ref, β, α) − q_encoder) + G⁻ᵀ F_ref ∂δ/∂x.
/// Haptic thread; no allocation. Source: P3 §2.1 (PID for the position, PD for the force).
class FingertipController {
public:
    FingertipController(const FingertipGeometry& geometry, const FingertipDriveParameters& drive,
                        const FingertipControlParameters& control, double forcePeriod_s) noexcept;

    void reset(const FingertipPose& at) noexcept; ///< holds nothing; the platform is there
    /// Motors off: what has been summed up is forgotten; the next tick begins where the encoders are.
    void rest(const core::Vec3& encoders_m) noexcept;
    /// Once a tick; `fresh`: `force_N` is a new reading. Answers motor forces, N.
    core::Vec3 tick(const core::DisplayPose& wanted, double force_N, bool fresh, const core::Vec3& encoders_m) noexcept;
    const FingertipPose& reference() const noexcept { return m_reference; }

private:
    void moveReference(const core::DisplayPose& wanted) noexcept;

    FingertipKinematics m_kinematics;
    FingertipControlParameters m_c;
    FingerPad m_pad;
    double m_forceLimit_N;
    double m_forcePeriod_s;
    FingertipPose m_reference;
    core::Vec3 m_referenceRate = core::Vec3::Zero();
    core::Vec3 m_integral = core::Vec3::Zero();
    core::Vec3 m_before = core::Vec3::Zero(); ///< encoders
    core::Vec3 m_speed = core::Vec3::Zero();
    double m_correction_m = 0.0;
    double m_errorBefore_N = 0.0;
    bool m_started = false;
};

} // namespace chiron::mechanisms
