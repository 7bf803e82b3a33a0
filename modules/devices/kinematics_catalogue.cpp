// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/kinematics_catalogue.h"

#include "devices/drivers/cartesian/cartesian_kinematics.h"
#include "devices/drivers/endoscope_pointer/endoscope_pose_kinematics.h"
#include "devices/drivers/simulated/fingertip_arm_kinematics.h"
#include "devices/drivers/simulated/fingertip_sliding_kinematics.h"
#include "devices/drivers/simulated/five_bar_spherical_kinematics.h"
#include "devices/drivers/simulated/gimbal_hprd_kinematics.h"

namespace chiron::devices {

namespace {
template <class Kinematics>
core::Result<std::unique_ptr<IToolKinematics>> make(const DeviceDescriptor& descriptor) {
    auto made = Kinematics::create(descriptor);
    if (!made)
        return tl::unexpected(made.error());
    return std::make_unique<Kinematics>(*made);
}
} // namespace

core::Result<std::unique_ptr<IToolKinematics>> makeKinematics(const DeviceDescriptor& descriptor) {
    if (descriptor.kinematics == "cartesian")
        return make<CartesianKinematics>(descriptor);
    if (descriptor.kinematics == GimbalHprdKinematics::kId)
        return make<GimbalHprdKinematics>(descriptor);
    if (descriptor.kinematics == FiveBarSphericalKinematics::kId)
        return make<FiveBarSphericalKinematics>(descriptor);
    if (descriptor.kinematics == FingertipArmKinematics::kId) {
        // Sessions of models id 1 and 2 have an arm of three sliding axes under the same id.
        const bool slides = !descriptor.axes.empty() && descriptor.axes.front().unit == AxisUnit::metre;
        return slides ? make<FingertipSlidingKinematics>(descriptor) : make<FingertipArmKinematics>(descriptor);
    }
    if (descriptor.kinematics == EndoscopePoseKinematics::kId)
        return make<EndoscopePoseKinematics>(descriptor);
    return core::fail(core::ErrorCode::badInput, "unknown kinematics \"" + descriptor.kinematics + "\"");
}

} // namespace chiron::devices
