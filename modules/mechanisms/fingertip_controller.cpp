// SPDX-License-Identifier: GPL-3.0-or-later
#include "mechanisms/fingertip_controller.h"

namespace chiron::mechanisms {

using core::Vec3;

FingertipController::FingertipController(const FingertipGeometry& geometry,
                                         const FingertipDriveParameters& drive,
                                         const FingertipControlParameters& control,
                                         double forcePeriod_s) noexcept
    : m_kinematics(geometry), m_c(control), m_pad(control.pad), m_forceLimit_N(drive.forceLimit_N),
      m_forcePeriod_s(forcePeriod_s) {}

void FingertipController::reset(const FingertipPose& at) noexcept {
    m_reference = m_kinematics.limited(at);
    m_referenceRate = m_integral = m_speed = Vec3::Zero();
    m_correction_m = m_errorBefore_N = 0.0;
    m_depth_m = m_pad.penetration(m_kinematics.loop(m_reference));
    m_depthRate_m_per_s = m_depthAcceleration_m_per_s2 = m_expected_N = m_expectedBefore_N = m_turn = 0.0;
    m_expectedLine.fill(0.0);
    m_lean = {m_reference.pitch_rad, m_reference.roll_rad};
    m_leanRate = m_leanAcceleration = {};
    m_turning = 0.0;
    m_started = m_limited = false;
}

void FingertipController::rest(const Vec3& encoders_m) noexcept {
    FingertipPose at = m_reference;
    m_kinematics.forward(encoders_m, at);
    reset(at);
}

std::size_t FingertipController::lateIndex() const noexcept {
    return (m_now + kLine -
            static_cast<std::size_t>(std::clamp(m_c.senseDelay_ticks, 0, static_cast<int>(kLine) - 1))) %
           kLine;
}

/// Returns the speed towards the target: proportional to the distance near it, v² = 2 a |e| farther away, and
/// at most `fastest`.
namespace {
double boundedSpeed(double error, double rate, double acceleration, double fastest) noexcept {
    const double way = std::abs(error), knee = acceleration / (rate * rate);
    return std::copysign(
        std::min(way < knee ? rate * way : std::sqrt(acceleration * (2.0 * way - knee)), fastest), error);
}
} // namespace

void FingertipController::shape(double wanted_N) noexcept {
    const double t = std::clamp(wanted_N / 0.05, 0.0, 1.0);
    const double near = t * t * (3.0 - 2.0 * t);
    const double error = m_pad.depthOf(wanted_N) - (1.0 - near) * m_c.clearance_m - m_depth_m;
    const double a = m_c.acceleration_m_per_s2, dt = core::kTickSeconds;
    const double speed = std::min(boundedSpeed(error, m_c.approach_per_s, a, m_c.fastest_m_per_s),
                                  m_c.fastest_N_per_s / m_pad.stiffnessAt(m_expected_N));
    m_depthAcceleration_m_per_s2 = std::clamp(m_c.smoothing_per_s * (speed - m_depthRate_m_per_s), -a, a);
    m_depthRate_m_per_s += dt * m_depthAcceleration_m_per_s2;
    m_depth_m += dt * m_depthRate_m_per_s;
    m_expected_N = m_pad.force(m_depth_m, m_depthRate_m_per_s);
    m_now = (m_now + 1) % kLine;
    m_expectedLine[m_now] = m_expected_N;
}

/// Returns the reading without the resistors' hysteresis. The hysteresis is taken to follow the expected
/// force, because the readings' noise would erase its state.
double FingertipController::unhysteretic(double reading_N, double expected_N) noexcept {
    const double change = (expected_N - m_expectedBefore_N) / m_c.sensorHysteresisForce_N;
    m_expectedBefore_N = expected_N;
    m_turn = (m_turn + change) / (1.0 + std::abs(change));
    return reading_N / (1.0 - m_c.sensorHysteresis * m_turn);
}

void FingertipController::correct(double reading_N) noexcept {
    const double expected = m_expectedLine[lateIndex()];
    const double force_N = unhysteretic(reading_N, expected);
    const double error = expected - force_N;
    const double change = (error - m_errorBefore_N) / m_forcePeriod_s;
    m_errorBefore_N = error;
    const double stiffness = m_pad.stiffnessAt(std::max(expected, force_N));
    const double gain = m_c.forceBandwidth_rad_per_s / std::max(stiffness, m_c.leastStiffness_N_per_m);
    if (m_limited && error > 0.0)
        return; // the motors are already at their limit
    if (expected > 0.0)
        m_correction_m =
            std::clamp(m_correction_m + m_forcePeriod_s * gain * (error + m_c.forceDerivative_s * change),
                       -m_c.correctionLimit_m, m_c.correctionLimit_m);
    else
        // No force to hold: return to what was identified.
        m_correction_m *= 1.0 - std::min(1.0, m_forcePeriod_s / 0.2);
}

/// Moves the angles like the depth, with bounded speed and acceleration. They move more slowly where a stiff
/// pad turns what is unknown of the finger's shape into newtons.
void FingertipController::turn(const core::DisplayPose& wanted) noexcept {
    const double dt = core::kTickSeconds, rate = m_c.leanApproach_per_s;
    const FingertipPose aim = m_kinematics.limited({0.0, wanted.pitch_rad, wanted.roll_rad});
    const std::array<double, 2> to{aim.pitch_rad, aim.roll_rad};
    constexpr double kStill_rad = 0.05, kAbove_N = 0.05;
    m_turning = std::min(1.0, std::hypot(to[0] - m_lean[0], to[1] - m_lean[1]) / kStill_rad);
    const double stiffness =
        m_pad.stiffnessAt(std::max(m_expected_N, std::min(wanted.normalForce_N, mostWanted_N())));
    const bool waits = m_expected_N > mostWanted_N() + kAbove_N; // the force has to decrease first
    const double fastest =
        waits ? 0.0 : m_c.fastest_rad_per_s * std::min(1.0, m_c.turningStiffness_N_per_m / stiffness);
    for (std::size_t i = 0; i < 2; ++i) {
        const double speed = boundedSpeed(to[i] - m_lean[i], rate, m_c.acceleration_rad_per_s2, fastest);
        m_leanAcceleration[i] = std::clamp(m_c.leanSmoothing_per_s * (speed - m_leanRate[i]),
                                           -m_c.acceleration_rad_per_s2, m_c.acceleration_rad_per_s2);
        m_leanRate[i] += dt * m_leanAcceleration[i];
        m_lean[i] += dt * m_leanRate[i];
    }
}

void FingertipController::moveReference() noexcept {
    const FingertipLoop leaning = m_kinematics.loop({0.0, m_lean[0], m_lean[1]});
    const FingertipPose next =
        m_kinematics.limited({m_pad.heightFor(leaning, m_depth_m + m_correction_m), m_lean[0], m_lean[1]});
    const Vec3 rate = (next.vector() - m_reference.vector()) / core::kTickSeconds;
    m_referenceRate = rate;
    m_reference = next;
}

Vec3 FingertipController::tick(const core::DisplayPose& wanted, double force_N, bool fresh,
                               const Vec3& encoders_m) noexcept {
    turn(wanted);
    shape(std::min(wanted.normalForce_N, mostWanted_N()));
    if (fresh)
        correct(force_N);
    moveReference();
    const double dt = core::kTickSeconds;
    const Vec3 raw = m_started ? Vec3((encoders_m - m_before) / dt) : Vec3(Vec3::Zero());
    m_before = encoders_m;
    m_started = true;
    m_speed += dt / (dt + m_c.derivativeFilter_s) * (raw - m_speed);
    const FingertipLoop at = m_kinematics.loop(m_reference);
    const Vec3 error = at.drives - encoders_m;
    const Vec3 acceleration(m_depthAcceleration_m_per_s2, m_leanAcceleration[0], m_leanAcceleration[1]);
    const Vec3 rates = at.jacobian * m_referenceRate;
    Vec3 ahead = FingertipKinematics::driveForces(at, m_expected_N * m_pad.gradient(at)) +
                 m_c.movedMass_kg / 3.0 * (at.jacobian * acceleration);
    for (int i = 0; i < 3; ++i)
        ahead[i] += m_c.friction_N * rates[i] / std::hypot(rates[i], m_c.frictionTurns_m_per_s);
    Vec3 force =
        ahead + m_c.proportional_N_per_m * error + m_integral + m_c.derivative_Ns_per_m * (rates - m_speed);
    const double excess_N =
        FingertipKinematics::onPlatform(at, force).x() - m_c.pressingLimit_N * m_pad.gradient(at).x();
    m_limited = excess_N > 0.0;
    if (m_limited) // whatever the sensors report
        force -= FingertipKinematics::driveForces(at, Vec3(excess_N, 0.0, 0.0));
    for (int i = 0; i < 3; ++i) {
        // It cannot follow, so the error is not integrated.
        if (std::abs(force[i]) >= m_forceLimit_N || (m_limited && error[i] > 0.0))
            continue;
        m_integral[i] = std::clamp(m_integral[i] + dt * m_c.integral_N_per_ms * error[i],
                                   -m_c.integralLimit_N, m_c.integralLimit_N);
    }
    return force;
}

} // namespace chiron::mechanisms
