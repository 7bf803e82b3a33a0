// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/recorded_device.h"

#include "devices/kinematics_catalogue.h"

namespace chiron::devices {

core::Result<std::unique_ptr<RecordedDevice>> RecordedDevice::create(const DeviceDescriptor& descriptor) {
    auto kinematics = makeKinematics(descriptor);
    CHIRON_TRY(kinematics);
    return std::unique_ptr<RecordedDevice>(new RecordedDevice(descriptor, std::move(*kinematics)));
}

RecordedDevice::RecordedDevice(const DeviceDescriptor& descriptor,
                               std::unique_ptr<IToolKinematics> kinematics)
    : m_descriptor(descriptor), m_kinematics(std::move(kinematics)) {}

RecordedDevice::~RecordedDevice() = default;

} // namespace chiron::devices
