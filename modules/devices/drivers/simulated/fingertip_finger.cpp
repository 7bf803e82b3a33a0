// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/drivers/simulated/fingertip_finger.h"

#include "devices/drivers/simulated/fingertip_arm_kinematics.h"

#include <cmath>

namespace chiron::devices {

void FingertipFinger::addToSample(const IToolKinematics& kinematics, const WorkspaceMap& map,
                                  core::DeviceSample& sample) const noexcept {
    constexpr std::size_t kPitch = FingertipArmKinematics::kPlatform;
    const auto count = [this](double angle_rad) {
        return static_cast<std::int32_t>(std::floor(angle_rad / m_angleResolution_rad + 0.5));
    };
    sample.counts[kPitch] = count(m_platform.sensedPitch_rad());
    sample.counts[kPitch + 1] = count(m_platform.sensedRoll_rad());
    core::Wrench sensed_D;
    sensed_D.force = kinematics.pose(sample).q_WT * core::Vec3(0.0, 0.0, m_platform.sensedForce_N());
    sample.measured = core::toArray(map.wrenchToW(sensed_D));
    sample.status |= core::sample_status::kMeasuredForce;
    if (m_platform.saturated())
        sample.status |= core::sample_status::kSaturated;
}

} // namespace chiron::devices
