// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/drivers/simulated/simulated_fingertip_device.h"

namespace chiron::devices {

void SimulatedFingertipDevice::resetPlant() noexcept {
    m_arm.reset(m_configuration.start_D);
    m_finger.reset();
}

void SimulatedFingertipDevice::stepDisplay(const ForceCommand& command) noexcept {
    // Position of the fingers at the end of this tick; the lever follows in the next one.
    m_arm.holdLever(jaw_rad());
    m_finger.tick(command);
}

void SimulatedFingertipDevice::addToSample(core::DeviceSample& sample) const noexcept {
    sample.jawCounts = m_arm.jawCounts();
    m_finger.addToSample(m_kinematics, m_padMap, sample);
}

} // namespace chiron::devices
