// SPDX-License-Identifier: GPL-3.0-or-later
#include "mechanisms/fingertip_platform.h"

namespace chiron::mechanisms {

FingertipPlatform::FingertipPlatform(const FingertipPlatformParameters& parameters,
                                     std::uint64_t seed) noexcept
    : m_parameters(parameters), m_plant(parameters), m_force(parameters.force, seed),
      m_imu(parameters.imu, seed),
      m_controller(parameters.geometry, parameters.drive, parameters.control,
                   core::kTickSeconds * std::max(parameters.force.period_ticks, 1)) {
    m_parameters.substeps = std::max(parameters.substeps, 8);
    reset();
}

void FingertipPlatform::reset() noexcept {
    const FingertipPose clear{m_parameters.control.pad.surface_m - m_parameters.control.clearance_m, 0.0,
                              0.0};
    m_plant.reset(clear);
    m_force.reset();
    m_imu.reset();
    m_controller.reset(clear);
    m_truth = {};
    m_saturated = m_fresh = false;
}

core::Vec3 FingertipPlatform::encoders() const noexcept {
    const double count = m_parameters.drive.encoder_m;
    core::Vec3 sensed;
    for (int i = 0; i < 3; ++i)
        sensed[i] = count * std::floor(m_plant.motors()[i] / count + 0.5);
    return sensed;
}

void FingertipPlatform::tick(const core::DisplayPose& wanted, bool enabled) noexcept {
    core::Vec3 motors = core::Vec3::Zero();
    if (enabled)
        motors = m_controller.tick(wanted, m_force.force_N(), m_fresh, encoders());
    else
        m_controller.rest(encoders());
    m_saturated = false;
    double force = 0.0;
    const double dt = core::kTickSeconds / m_parameters.substeps;
    for (int n = 0; n < m_parameters.substeps; ++n) {
        m_plant.step(dt, motors);
        m_saturated = m_saturated || m_plant.saturated();
        force += m_plant.padForce_N();
    }
    m_truth = {force / m_parameters.substeps, m_plant.pose().pitch_rad, m_plant.pose().roll_rad};
    m_fresh = m_force.tick(m_truth.normalForce_N, m_plant.padPlace());
    m_imu.tick(m_plant.pose());
}

} // namespace chiron::mechanisms
