// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/drivers/simulated/five_bar_spherical_kinematics.h"

namespace chiron::devices {

using core::Vec2;
using core::Vec3;
using mechanisms::FiveBarKinematics;

mechanisms::FiveBarLoop FiveBarSphericalKinematics::loop(const core::DeviceSample& sample) const noexcept {
    return m_linkage.loop(value(sample, 0), value(sample, 1));
}

mechanisms::SphericalJoint
FiveBarSphericalKinematics::joint(const core::DeviceSample& sample) const noexcept {
    return mechanisms::SphericalJoint(
        {m_mountingPitch_rad + value(sample, 2), value(sample, 3), value(sample, 4)});
}

core::ToolState FiveBarSphericalKinematics::pose(const core::DeviceSample& sample) const noexcept {
    core::ToolState state;
    state.p_WT = FiveBarKinematics::toD(loop(sample).tip);
    state.q_WT = joint(sample).orientation_DT();
    state.jaw_rad = sample.jawCounts * m_jawResolution_rad;
    state.buttons = sample.buttons;
    return state;
}

void FiveBarSphericalKinematics::velocity(const core::DeviceSample& sample, const AxisValues& countRates,
                                          Vec3& v_DT, Vec3& w_DT) const noexcept {
    std::array<double, kAxes> rate{};
    for (std::size_t axis = 0; axis < kAxes; ++axis)
        rate[axis] = countRates[axis] * m_resolution[axis];
    v_DT = FiveBarKinematics::toD(loop(sample).jacobian * Vec2(rate[0], rate[1]));
    w_DT = joint(sample).angularVelocity_D(Vec3(rate[2], rate[3], rate[4]));
}

AxisValues FiveBarSphericalKinematics::efforts(const core::DeviceSample& sample,
                                               const core::Wrench& wrench_D) const noexcept {
    const Vec2 base = FiveBarKinematics::efforts(loop(sample), wrench_D.force);
    const Vec3 angles = joint(sample).efforts(wrench_D.torque);
    return {base[0], base[1], angles[0], angles[1], angles[2]};
}

} // namespace chiron::devices
