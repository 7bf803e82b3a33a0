// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/drivers/endoscope_pointer/endoscope_pose_kinematics.h"

namespace chiron::devices {

using core::Vec3;

mechanisms::SphericalJoint EndoscopePoseKinematics::joint(const core::DeviceSample& sample) const noexcept {
    const Vec3 angles = triple(sample.counts, 3);
    return mechanisms::SphericalJoint({angles[0], angles[1], angles[2]});
}

core::ToolState EndoscopePoseKinematics::pose(const core::DeviceSample& sample) const noexcept {
    core::ToolState state;
    state.p_WT = triple(sample.counts, 0);
    state.q_WT = joint(sample).orientation_DT();
    state.buttons = sample.buttons;
    return state;
}

void EndoscopePoseKinematics::velocity(const core::DeviceSample& sample, const AxisValues& countRates,
                                       Vec3& v_DT, Vec3& w_DT) const noexcept {
    v_DT = triple(countRates, 0);
    w_DT = joint(sample).angularVelocity_D(triple(countRates, 3));
}

AxisValues EndoscopePoseKinematics::efforts(const core::DeviceSample& sample,
                                            const core::Wrench& wrench_D) const noexcept {
    const Vec3 angles = joint(sample).efforts(wrench_D.torque);
    return {wrench_D.force.x(), wrench_D.force.y(), wrench_D.force.z(), angles[0], angles[1], angles[2]};
}

} // namespace chiron::devices
