// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/kinematics_catalogue.h"

#include "devices/driver_catalogue.h"

#include <algorithm>

namespace chiron::devices {

const KinematicsEntry* findKinematics(std::string_view id) noexcept {
    for (const Driver* driver : driverCatalogue())
        if (const KinematicsEntry* entry = kinematicsOf(*driver, id))
            return entry;
    return nullptr;
}

std::vector<std::string_view> forceMapIds() {
    std::vector<std::string_view> ids{kExactForceMap};
    for (const Driver* driver : driverCatalogue())
        for (const KinematicsEntry& kinematics : driver->kinematics) {
            if (kinematics.forceMaps == nullptr)
                continue;
            for (const ForceMap& map : kinematics.forceMaps->maps)
                if (std::find(ids.begin(), ids.end(), map.id) == ids.end())
                    ids.push_back(map.id);
        }
    return ids;
}

core::Result<std::unique_ptr<IToolKinematics>> makeKinematics(const DeviceDescriptor& descriptor) {
    if (const KinematicsEntry* entry = findKinematics(descriptor.kinematics))
        return entry->make(descriptor);
    return core::fail(core::ErrorCode::badInput, "unknown kinematics \"" + descriptor.kinematics + "\"");
}

} // namespace chiron::devices
