// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/drivers/keyboard_mouse/keyboard_mouse_device.h"

#include "core/units.h"

#include <algorithm>
#include <cmath>

namespace chiron::devices {

core::DeviceSample KeyboardMouseDevice::read(const realtime::HapticTick& now) noexcept {
    const std::array<double, 4> hand = m_intake.take(m_mailbox.read()); // m, m, m, rad
    core::DeviceSample sample;
    for (std::size_t i = 0; i < 3; ++i) {
        m_position_m[i] =
            std::clamp(m_position_m[i] + m_ratio * hand[i], m_settings.minimum_m[i], m_settings.maximum_m[i]);
        sample.counts[i] = static_cast<std::int32_t>(std::lround(m_position_m[i] / kGrid_m));
    }
    m_jaw_rad = std::clamp(m_jaw_rad + hand[3], 0.0, m_settings.widestJaw_rad);
    sample.jawCounts = static_cast<std::int32_t>(std::lround(m_jaw_rad / kJawGrid_rad));
    sample.buttons = m_intake.buttons();
    sample.packet = ++m_packet;
    sample.status = core::sample_status::kHomed;
    sample.deviceTime_us = now.index() * 1000;
    sample.arrival_ns = now.now_ns();
    return sample;
}

void KeyboardMouseDevice::show(const realtime::HapticTick&, const core::VisibleCues& cues) noexcept {
    m_ratio = m_settings.pseudoHaptics.ratio(cues.shownForce_N);
}

} // namespace chiron::devices
