// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/drivers/cartesian/cartesian_kinematics.h"

#include "devices/rotation_rates.h"

#include <cmath>

namespace chiron::devices {

namespace {

core::Vec3 triple(const AxisValues& values, std::size_t first) noexcept {
    return {values[first], values[first + 1], values[first + 2]};
}

} // namespace

core::Vec3 CartesianKinematics::rotationVector(const core::DeviceSample& sample) const noexcept {
    return {sample.counts[3] * m_resolution[3], sample.counts[4] * m_resolution[4],
            sample.counts[5] * m_resolution[5]};
}

core::ToolState CartesianKinematics::pose(const core::DeviceSample& sample) const noexcept {
    core::ToolState tool;
    tool.p_WT = {sample.counts[0] * m_resolution[0], sample.counts[1] * m_resolution[1],
                 sample.counts[2] * m_resolution[2]};
    if (m_turns) {
        const core::Vec3 r = rotationVector(sample);
        const double angle = r.norm();
        const double s = angle > 0.0 ? std::sin(angle / 2.0) / angle : 0.5;
        tool.q_WT = {std::cos(angle / 2.0), s * r.x(), s * r.y(), s * r.z()};
    }
    tool.jaw_rad = sample.jawCounts * m_jawResolution_rad;
    return tool;
}

void CartesianKinematics::velocity(const core::DeviceSample& sample, const AxisValues& countRates,
                                   core::Vec3& v_DT, core::Vec3& w_DT) const noexcept {
    AxisValues rates{};
    for (std::size_t i = 0; i < rates.size(); ++i)
        rates[i] = countRates[i] * m_resolution[i];
    v_DT = triple(rates, 0);
    w_DT = m_turns ? core::Vec3(leftJacobian(rotationVector(sample)) * triple(rates, 3)) : core::Vec3::Zero();
}

AxisValues CartesianKinematics::efforts(const core::DeviceSample& sample,
                                        const core::Wrench& wrench_D) const noexcept {
    AxisValues efforts{wrench_D.force.x(), wrench_D.force.y(), wrench_D.force.z()};
    if (m_turns) {
        const core::Vec3 generalised = leftJacobian(rotationVector(sample)).transpose() * wrench_D.torque;
        efforts[3] = generalised.x();
        efforts[4] = generalised.y();
        efforts[5] = generalised.z();
    }
    return efforts;
}

} // namespace chiron::devices
