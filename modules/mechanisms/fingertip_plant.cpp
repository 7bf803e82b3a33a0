// SPDX-License-Identifier: GPL-3.0-or-later
#include "mechanisms/fingertip_plant.h"

namespace chiron::mechanisms {

using core::Vec3;

FingertipPlant::FingertipPlant(const FingertipPlatformParameters& parameters) noexcept
    : m_p(parameters), m_kinematics(parameters.geometry), m_pad(parameters.pad) {
    const double r2 = m_p.geometry.platformRadius_m * m_p.geometry.platformRadius_m;
    const double turning =
        0.25 * m_p.drive.platformMass_kg * r2 + 1.5 * m_p.drive.carriageMass_kg * r2; // a disc
    m_mass = {m_p.drive.platformMass_kg + 3.0 * m_p.drive.carriageMass_kg, turning, turning};
    m_band = m_p.drive.bandStiffness_N_per_m * Vec3(1.0, 0.5 * r2, 0.5 * r2);
    reset({});
}

void FingertipPlant::reset(const FingertipPose& pose) noexcept {
    m_pose = m_kinematics.limited(pose);
    m_loop = m_kinematics.loop(m_pose);
    m_motor = m_loop.drives;
    m_rates = m_motorRate = m_motorForce = Vec3::Zero();
    for (LugreFriction& friction : m_friction)
        friction.reset();
    m_relaxation.reset();
    m_shift_m = 0.0;
    m_padForce_N = m_pad.elasticForce(depth());
    m_saturated = false;
}

double FingertipPlant::gearStretch(int drive) const noexcept {
    const double play = 0.5 * m_p.drive.backlash_m;
    const double e = m_motor[drive] - m_loop.drives[drive];
    return e - std::clamp(e, -play, play);
}

void FingertipPlant::step(double dt_s, const Vec3& motorForces) noexcept {
    const FingertipDriveParameters& a = m_p.drive;
    const Vec3 driveRates = m_loop.jacobian * m_rates;
    const double lag = dt_s / (dt_s + a.amplifierLag_s);
    Vec3 gear = Vec3::Zero();
    m_saturated = false;
    for (int i = 0; i < 3; ++i) {
        const double asked = std::clamp(motorForces[i], -a.forceLimit_N, a.forceLimit_N);
        m_saturated = m_saturated || asked != motorForces[i];
        m_motorForce[i] += lag * (asked - m_motorForce[i]);
        if (const double stretch = gearStretch(i); stretch != 0.0)
            gear[i] =
                a.gearStiffness_N_per_m * stretch + a.gearDamping_Ns_per_m * (m_motorRate[i] - driveRates[i]);
        const double bristle =
            m_friction[static_cast<std::size_t>(i)].advance(a.friction, m_motorRate[i], dt_s);
        m_motorRate[i] = (m_motorRate[i] + dt_s / a.motorMass_kg * (m_motorForce[i] + bristle - gear[i])) /
                         (1.0 + dt_s * a.friction.viscous / a.motorMass_kg);
        m_motor[i] += dt_s * m_motorRate[i];
    }
    const Vec3 gradient = m_pad.gradient(m_loop);
    const double pressed = depth();
    m_relaxation.advance(m_p.pad, m_pad.elasticForce(pressed), dt_s);
    m_padForce_N = m_pad.force(pressed, gradient.dot(m_rates), m_relaxation.force_N());
    const Vec3 joints(0.0, a.jointDamping_Nms_per_rad * m_rates[1], a.jointDamping_Nms_per_rad * m_rates[2]);
    const Vec3 force = m_loop.jacobian.transpose() * gear - m_padForce_N * gradient -
                       m_band.cwiseProduct(m_pose.vector()) - joints;
    m_rates += dt_s * force.cwiseQuotient(m_mass);
    m_pose = FingertipPose::of(m_pose.vector() + dt_s * m_rates);
    stopAtEnds();
    m_loop = m_kinematics.loop(m_pose);
}

/// The slots of the rails and joints end a little beyond the commanded range.
void FingertipPlant::stopAtEnds() noexcept {
    const FingertipGeometry& g = m_p.geometry;
    constexpr double kBeyond_m = 0.0005, kBeyond_rad = 0.07;
    const Vec3 high(g.maximumZ_m + kBeyond_m, g.maximumPitch_rad + kBeyond_rad,
                    g.maximumRoll_rad + kBeyond_rad);
    const Vec3 low(g.minimumZ_m - kBeyond_m, -high[1], -high[2]);
    Vec3 x = m_pose.vector();
    for (int i = 0; i < 3; ++i) {
        if (x[i] >= low[i] && x[i] <= high[i])
            continue;
        x[i] = std::clamp(x[i], low[i], high[i]);
        m_rates[i] = 0.0;
    }
    m_pose = FingertipPose::of(x);
}

double FingertipPlant::energy_J() const noexcept {
    double energy = 0.5 * m_rates.dot(m_mass.cwiseProduct(m_rates)) +
                    0.5 * m_p.drive.motorMass_kg * m_motorRate.squaredNorm() + m_pad.energy_J(depth()) +
                    0.5 * m_pose.vector().dot(m_band.cwiseProduct(m_pose.vector()));
    for (int i = 0; i < 3; ++i)
        energy += 0.5 * m_p.drive.gearStiffness_N_per_m * gearStretch(i) * gearStretch(i) +
                  m_friction[static_cast<std::size_t>(i)].energy_J(m_p.drive.friction);
    return energy;
}

} // namespace chiron::mechanisms
