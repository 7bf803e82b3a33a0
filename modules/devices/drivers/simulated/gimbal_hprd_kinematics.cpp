// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/drivers/simulated/gimbal_hprd_kinematics.h"

namespace chiron::devices {

GimbalHprdKinematics::GimbalHprdKinematics(const std::array<double, 4>& resolution, double jawResolution_rad,
                                           double pivotHeight_m, mechanisms::PolarMap map) noexcept
    : m_resolution(resolution), m_jawResolution_rad(jawResolution_rad), m_gimbal(pivotHeight_m), m_map(map) {}

mechanisms::GimbalCoordinates
GimbalHprdKinematics::coordinates(const core::DeviceSample& sample) const noexcept {
    return {sample.counts[0] * m_resolution[0], sample.counts[1] * m_resolution[1],
            sample.counts[2] * m_resolution[2], sample.counts[3] * m_resolution[3]};
}

core::ToolState GimbalHprdKinematics::pose(const core::DeviceSample& sample) const noexcept {
    const auto q = coordinates(sample);
    core::ToolState state;
    state.p_WT = m_gimbal.tip_D(q);
    state.q_WT = m_gimbal.orientation_DT(q);
    state.jaw_rad = sample.jawCounts * m_jawResolution_rad;
    state.buttons = sample.buttons;
    return state;
}

void GimbalHprdKinematics::velocity(const core::DeviceSample& sample, const AxisValues& countRates,
                                    core::Vec3& v_DT, core::Vec3& w_DT) const noexcept {
    const mechanisms::GimbalVector rates{countRates[0] * m_resolution[0], countRates[1] * m_resolution[1],
                                         countRates[2] * m_resolution[2], countRates[3] * m_resolution[3]};
    const Eigen::Matrix<double, 6, 1> twist = m_gimbal.jacobian_D(coordinates(sample)) * rates;
    v_DT = twist.head<3>();
    w_DT = twist.tail<3>();
}

AxisValues GimbalHprdKinematics::efforts(const core::DeviceSample& sample,
                                         const core::Wrench& wrench_D) const noexcept {
    const auto tau = mechanisms::GimbalKinematics::efforts(coordinates(sample), wrench_D, m_map);
    AxisValues values{};
    for (std::size_t axis = 0; axis < 4; ++axis)
        values[axis] = tau[static_cast<int>(axis)];
    return values;
}

} // namespace chiron::devices
