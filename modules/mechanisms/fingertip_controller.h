// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tool_state.h"
#include "mechanisms/finger_pad.h"

#include <array>

namespace chiron::mechanisms {

/// The controller of the three motors (FingertipControlParameters). The lean goes to the position loop alone;
/// the force loop moves the height at which that lean is held:
///   F_ref = min(F_wanted, limit/(1 + doubt)),  d* = depth at which the identified pad gives F_ref,
///   s follows d* with bounded speed and acceleration,  F_s = force of that pad at s, the expected force,
///   z_ref = height at which this lean presses by s + u,  u˙ = Kp e + Kd ė,  e = F_s (delayed) − F,
///   f = PID(q(z_ref, β, α) − q_encoder) + G⁻ᵀ F_s ∂δ/∂x + m/3 · G ẍ_ref + a share of friction along q˙_ref.
/// Without the bounds on s a step of 1 N put 1.9 N on the pad; without F_s the loop would integrate the lag
/// as an error. Source: P3 §2.1 (PID for the position, PD for the force).
/// Thread: haptic; allocates nothing.
class FingertipController {
public:
    FingertipController(const FingertipGeometry& geometry, const FingertipDriveParameters& drive,
                        const FingertipControlParameters& control, double forcePeriod_s) noexcept;

    void reset(const FingertipPose& at) noexcept; ///< holds nothing; the platform is at this pose
    /// The motors are off: discards the integrals; the next tick starts from the encoders' position.
    void rest(const core::Vec3& encoders_m) noexcept;
    /// Runs one tick and returns the motor forces, N. `fresh` means that `force_N` is a new reading.
    core::Vec3 tick(const core::DisplayPose& wanted, double force_N, bool fresh,
                    const core::Vec3& encoders_m) noexcept;
    const FingertipPose& reference() const noexcept { return m_reference; }

    double mostWanted_N() const noexcept { ///< larger requests are cut to this; it is lower while the
                                           ///< platform turns
        return m_c.padLimit_N / (1.0 + m_c.forceDoubt + m_c.turningDoubt * m_turning);
    }

private:
    void shape(double wanted_N) noexcept;
    double unhysteretic(double reading_N, double expected_N) noexcept;
    void correct(double reading_N) noexcept;
    void turn(const core::DisplayPose& wanted) noexcept;
    void moveReference() noexcept;
    std::size_t lateIndex() const noexcept;

    FingertipKinematics m_kinematics;
    FingertipControlParameters m_c;
    FingerPad m_pad;
    double m_forceLimit_N;
    double m_forcePeriod_s;
    FingertipPose m_reference;
    core::Vec3 m_referenceRate = core::Vec3::Zero();
    core::Vec3 m_integral = core::Vec3::Zero();
    core::Vec3 m_before = core::Vec3::Zero(); ///< encoder values of the previous tick
    core::Vec3 m_speed = core::Vec3::Zero();
    double m_depth_m = 0.0; ///< s
    double m_depthRate_m_per_s = 0.0;
    double m_depthAcceleration_m_per_s2 = 0.0;
    double m_expected_N = 0.0;      ///< F_s
    std::array<double, 2> m_lean{}; ///< pitch, roll
    std::array<double, 2> m_leanRate{};
    std::array<double, 2> m_leanAcceleration{};
    double m_turning = 0.0; ///< 0 where the platform leans as requested, 1 from 3° off
    static constexpr std::size_t kLine = 64;
    std::array<double, kLine> m_expectedLine{};
    std::size_t m_now = 0;
    double m_expectedBefore_N = 0.0;
    double m_turn = 0.0; ///< state of the resistors' hysteresis, −1..1
    double m_correction_m = 0.0;
    double m_errorBefore_N = 0.0;
    bool m_started = false;
    bool m_limited = false; ///< the three motors together press as hard as they may
};

} // namespace chiron::mechanisms
