// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/urethra_insertion/session/device_friction.h"

#include "devices/kinematics_catalogue.h"

#include <algorithm>
#include <cmath>

namespace chiron::session {

double tipCount_m(const devices::DeviceDescriptor& device) {
    const auto kinematics = devices::makeKinematics(device);
    if (!kinematics)
        return 0.0;
    core::DeviceSample sample;
    for (std::size_t i = 0; i < device.axes.size(); ++i) {
        const devices::AxisDescriptor& axis = device.axes[i];
        sample.counts[i] =
            static_cast<std::int32_t>(std::lround(0.5 * (axis.minimum + axis.maximum) / axis.resolution));
    }
    double largest = 0.0;
    for (std::size_t i = 0; i < device.axes.size(); ++i) {
        devices::AxisValues oneCount{}; // one count per second, so that m/s equal metres per count
        oneCount[i] = 1.0;
        core::Vec3 v_DT = core::Vec3::Zero();
        core::Vec3 w_DT = core::Vec3::Zero();
        (*kinematics)->velocity(sample, oneCount, v_DT, w_DT);
        largest = std::max(largest, v_DT.norm());
    }
    return std::isfinite(largest) ? largest : 0.0;
}

simulation::UrethraForceSettings onDevice(simulation::UrethraForceSettings law,
                                          const devices::DeviceDescriptor& device,
                                          const devices::WorkspaceMapping& mapping) {
    if (device.maximumDamping_Ns_per_m > 0.0)
        law.maximumDamping_Ns_per_m =
            std::min(law.maximumDamping_Ns_per_m, device.maximumDamping_Ns_per_m / mapping.scale);
    if (const double count_m = tipCount_m(device); count_m > 0.0)
        law.count_m = count_m * mapping.scale;
    return law;
}

} // namespace chiron::session
