// SPDX-License-Identifier: GPL-3.0-or-later
#include "mechanisms/fingertip_controller.h"

namespace chiron::mechanisms {

using core::Vec3;

FingertipController::FingertipController(const FingertipGeometry& geometry, const FingertipDriveParameters& drive,
                                         const FingertipControlParameters& control, double forcePeriod_s) noexcept
    : m_kinematics(geometry), m_c(control), m_pad(control.pad), m_forceLimit_N(drive.forceLimit_N),
      m_forcePeriod_s(forcePeriod_s) {}

void FingertipController::reset(const FingertipPose& at) noexcept {
    m_reference = m_kinematics.limited(at);
    m_referenceRate = m_integral = m_speed = Vec3::Zero();
    m_correction_m = m_errorBefore_N = 0.0;
    m_started = false;
}

void FingertipController::rest(const Vec3& encoders_m) noexcept {
    FingertipPose at = m_reference;
    m_kinematics.forward(encoders_m, at);
    reset(at);
}

void FingertipController::moveReference(const core::DisplayPose& wanted) noexcept {
    const double t = std::clamp(wanted.normalForce_N / 0.05, 0.0, 1.0);
    const double near = t * t * (3.0 - 2.0 * t);
    const double depth = m_pad.depthOf(wanted.normalForce_N) - (1.0 - near) * m_c.clearance_m;
    const FingertipLoop leaning = m_kinematics.loop({0.0, m_reference.pitch_rad, m_reference.roll_rad});
    const FingertipPose aim = m_kinematics.limited(
        {m_pad.heightFor(leaning, depth) + m_correction_m, wanted.pitch_rad, wanted.roll_rad});
    const double dt = core::kTickSeconds;
    const Vec3 most = dt * Vec3(m_c.fastest_m_per_s, m_c.fastest_rad_per_s, m_c.fastest_rad_per_s);
    const Vec3 change = (aim.vector() - m_reference.vector()).cwiseMax(-most).cwiseMin(most);
    m_referenceRate = change / dt;
    m_reference = FingertipPose::of(m_reference.vector() + change);
}

Vec3 FingertipController::tick(const core::DisplayPose& wanted, double force_N, bool fresh, const Vec3& encoders_m) noexcept {
    if (fresh) {
        const double error = wanted.normalForce_N - force_N;
        const double change = (error - m_errorBefore_N) / m_forcePeriod_s;
        m_errorBefore_N = error;
        const double stiffness = m_pad.stiffnessAt(std::max(wanted.normalForce_N, force_N));
        const double gain = m_c.forceBandwidth_rad_per_s / std::max(stiffness, m_c.leastStiffness_N_per_m);
        if (wanted.normalForce_N > 0.0)
            m_correction_m = std::clamp(m_correction_m + m_forcePeriod_s * gain * (error + m_c.forceDerivative_s * change),
                                        -m_c.correctionLimit_m, m_c.correctionLimit_m);
        else
            m_correction_m *= 1.0 - std::min(1.0, m_forcePeriod_s / 0.2); // nothing to hold: back to what was measured
    }
    moveReference(wanted);
    const double dt = core::kTickSeconds;
    const Vec3 raw = m_started ? Vec3((encoders_m - m_before) / dt) : Vec3(Vec3::Zero());
    m_before = encoders_m;
    m_started = true;
    m_speed += dt / (dt + m_c.derivativeFilter_s) * (raw - m_speed);
    const FingertipLoop at = m_kinematics.loop(m_reference);
    const Vec3 error = at.drives - encoders_m;
    const Vec3 ahead = FingertipKinematics::driveForces(at, wanted.normalForce_N * m_pad.gradient(at));
    Vec3 force = ahead + m_c.proportional_N_per_m * error + m_integral +
                 m_c.derivative_Ns_per_m * (at.jacobian * m_referenceRate - m_speed);
    for (int i = 0; i < 3; ++i) {
        if (std::abs(force[i]) < m_forceLimit_N) // else the motor cannot follow: no use in summing up
            m_integral[i] = std::clamp(m_integral[i] + dt * m_c.integral_N_per_ms * error[i], -m_c.integralLimit_N,
                                       m_c.integralLimit_N);
    }
    return force;
}

} // namespace chiron::mechanisms
