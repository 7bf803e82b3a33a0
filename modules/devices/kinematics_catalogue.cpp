// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/kinematics_catalogue.h"

#include "devices/driver_catalogue.h"

namespace chiron::devices {

core::Result<std::unique_ptr<IToolKinematics>> makeKinematics(const DeviceDescriptor& descriptor) {
    for (const Driver* driver : driverCatalogue())
        for (const KinematicsEntry& entry : driver->kinematics)
            if (entry.id == descriptor.kinematics)
                return entry.make(descriptor);
    return core::fail(core::ErrorCode::badInput, "unknown kinematics \"" + descriptor.kinematics + "\"");
}

} // namespace chiron::devices
