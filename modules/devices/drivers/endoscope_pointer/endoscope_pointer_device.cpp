// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/drivers/endoscope_pointer/endoscope_pointer_device.h"

#include <algorithm>
#include <cmath>

namespace chiron::devices {

using core::Vec3;

void EndoscopePointerDevice::move(const EndoscopeMovement& hand) noexcept {
    const mechanisms::SphericalJoint joint({m_angles_rad[0], m_angles_rad[1], m_angles_rad[2]});
    const core::Quat& q = joint.orientation_DT();
    Vec3 moved = q * Vec3(hand.right_m, hand.up_m, -m_ratio * hand.advance_m);
    if (m_settings.planar)
        moved.x() = 0.0;
    const Vec3 turned = joint.rates(q * Vec3(hand.turnUp_rad, -hand.turnRight_rad, -hand.spin_rad));
    for (int i = 0; i < 3; ++i) {
        const auto axis = static_cast<std::size_t>(i);
        m_position_m[i] =
            std::clamp(m_position_m[i] + moved[i], m_settings.minimum_m[axis], m_settings.maximum_m[axis]);
        m_angles_rad[i] = std::clamp(m_angles_rad[i] + turned[i], m_settings.minimum_rad[axis],
                                     m_settings.maximum_rad[axis]);
    }
}

core::DeviceSample EndoscopePointerDevice::read(const realtime::HapticTick& now) noexcept {
    move(EndoscopeMailbox::toMovement(m_intake.take(m_mailbox.read())));
    core::DeviceSample sample;
    for (int i = 0; i < 3; ++i) {
        const auto axis = static_cast<std::size_t>(i);
        sample.counts[axis] = static_cast<std::int32_t>(std::lround(m_position_m[i] / kGrid_m));
        sample.counts[axis + 3] = static_cast<std::int32_t>(std::lround(m_angles_rad[i] / kGrid_rad));
    }
    sample.buttons = m_intake.buttons();
    sample.packet = ++m_packet;
    sample.status = core::sample_status::kHomed;
    sample.deviceTime_us = now.index() * 1000;
    sample.arrival_ns = now.now_ns();
    return sample;
}

void EndoscopePointerDevice::show(const realtime::HapticTick&, const core::VisibleCues& cues) noexcept {
    m_ratio = m_settings.pseudoHaptics.ratio(cues.shownForce_N);
}

} // namespace chiron::devices
