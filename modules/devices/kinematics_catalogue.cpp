// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/kinematics_catalogue.h"

#include "devices/driver_catalogue.h"

namespace chiron::devices {

const KinematicsEntry* findKinematics(std::string_view id) noexcept {
    for (const Driver* driver : driverCatalogue())
        if (const KinematicsEntry* entry = kinematicsOf(*driver, id))
            return entry;
    return nullptr;
}

core::Result<std::unique_ptr<IToolKinematics>> makeKinematics(const DeviceDescriptor& descriptor) {
    if (const KinematicsEntry* entry = findKinematics(descriptor.kinematics))
        return entry->make(descriptor);
    return core::fail(core::ErrorCode::badInput, "unknown kinematics \"" + descriptor.kinematics + "\"");
}

} // namespace chiron::devices
