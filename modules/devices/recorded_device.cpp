// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/recorded_device.h"

namespace chiron::devices {

core::DeviceSample RecordedDevice::read(const realtime::HapticTick&) noexcept {
    return m_sample;
}

} // namespace chiron::devices
