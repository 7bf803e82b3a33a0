// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/drivers/simulated/fingertip_sliding_kinematics.h"

#include "devices/rotation_rates.h"
#include "mechanisms/rotation_vector.h"

namespace chiron::devices {

using core::Vec3;

Vec3 FingertipSlidingKinematics::triple(const core::DeviceSample& sample, std::size_t first) const noexcept {
    return {sample.counts[first] * m_resolution[first], sample.counts[first + 1] * m_resolution[first + 1],
            sample.counts[first + 2] * m_resolution[first + 2]};
}

core::ToolState FingertipSlidingKinematics::pose(const core::DeviceSample& sample) const noexcept {
    core::ToolState tool;
    tool.q_WT = mechanisms::turned(core::Quat::Identity(), triple(sample, kWrist));
    tool.p_WT = triple(sample, 0) + tool.q_WT * m_pad_T;
    tool.jaw_rad = sample.jawCounts * m_jawResolution_rad;
    tool.buttons = sample.buttons;
    return tool;
}

void FingertipSlidingKinematics::velocity(const core::DeviceSample& sample, const AxisValues& countRates,
                                          Vec3& v_DT, Vec3& w_DT) const noexcept {
    Vec3 p_rate;
    Vec3 r_rate;
    for (std::size_t i = 0; i < 3; ++i) {
        p_rate[static_cast<int>(i)] = countRates[i] * m_resolution[i];
        r_rate[static_cast<int>(i)] = countRates[i + kWrist] * m_resolution[i + kWrist];
    }
    const Vec3 r = triple(sample, kWrist);
    w_DT = leftJacobian(r) * r_rate;
    v_DT = p_rate + w_DT.cross(mechanisms::turned(core::Quat::Identity(), r) * m_pad_T);
}

} // namespace chiron::devices
