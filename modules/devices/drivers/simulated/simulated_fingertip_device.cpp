// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/drivers/simulated/simulated_fingertip_device.h"

namespace chiron::devices {

void SimulatedFingertipDevice::resetPlant() noexcept {
    m_arm.reset(m_configuration.start_D);
    m_finger.reset();
}

void SimulatedFingertipDevice::addToSample(core::DeviceSample& sample) const noexcept {
    m_finger.addToSample(m_kinematics, m_padMap, sample);
}

} // namespace chiron::devices
