// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/drivers/simulated/gimbal_hprd_kinematics.h"

#include <cmath>
#include <string>

namespace chiron::devices {

core::Result<std::unique_ptr<IToolKinematics>> GimbalHprdKinematics::make(const DeviceDescriptor& descriptor) {
    const auto wrong = [](const std::string& what) {
        return core::fail(core::ErrorCode::badInput, "kinematics gimbal_hprd: " + what);
    };
    if (descriptor.kinematics != kId)
        return wrong("descriptor says '" + descriptor.kinematics + "'");
    if (descriptor.axes.size() != 4)
        return wrong("axes: " + std::to_string(descriptor.axes.size()) + " found, 4 expected (h, p, r, d)");
    std::array<double, 4> resolution{};
    for (std::size_t axis = 0; axis < 4; ++axis) {
        resolution[axis] = descriptor.axes[axis].resolution;
        if (!(resolution[axis] > 0.0) || !std::isfinite(resolution[axis]))
            return wrong("axes[" + std::to_string(axis) + "].resolution: a finite number above 0 expected");
    }
    const auto& parameters = descriptor.kinematicsParameters;
    if (parameters.size() != 2 || !std::isfinite(parameters[0]) || (parameters[1] != 0.0 && parameters[1] != 1.0))
        return wrong("parameters: {pivot height in m, force map 0 (exact) or 1 (as published)} expected");
    const auto map = parameters[1] == 0.0 ? mechanisms::PolarMap::exact : mechanisms::PolarMap::asPublished;
    return std::make_unique<GimbalHprdKinematics>(resolution, descriptor.jawResolution_rad, parameters[0], map);
}

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

void GimbalHprdKinematics::velocity(const core::DeviceSample& sample, const AxisValues& countRates, core::Vec3& v_DT,
                                    core::Vec3& w_DT) const noexcept {
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
