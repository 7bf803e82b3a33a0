// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/drivers/keyboard_mouse/keyboard_mouse_device.h"

#include "core/units.h"

#include <algorithm>
#include <cmath>

namespace chiron::devices {

core::DeviceSample KeyboardMouseDevice::read(const realtime::HapticTick& now) noexcept {
    const PointerTotals& totals = m_mailbox.read();
    core::DeviceSample sample;
    for (std::size_t i = 0; i < 3; ++i) {
        m_pending_m[i] += totals.moved_m[i] - m_seen.moved_m[i];
        const double followed_m = m_share * m_pending_m[i];
        m_pending_m[i] -= followed_m;
        const double hand_m = followed_m + totals.rate_m_per_s[i] * core::kTickSeconds;
        m_position_m[i] =
            std::clamp(m_position_m[i] + m_ratio * hand_m, m_settings.minimum_m[i], m_settings.maximum_m[i]);
        sample.counts[i] = static_cast<std::int32_t>(std::lround(m_position_m[i] / kGrid_m));
    }
    sample.buttons = buttons(totals);
    m_seen = totals;
    sample.packet = ++m_packet;
    sample.status = core::sample_status::kHomed;
    sample.deviceTime_us = now.index() * 1000;
    sample.arrival_ns = now.now_ns();
    return sample;
}

std::uint32_t KeyboardMouseDevice::buttons(const PointerTotals& totals) noexcept {
    std::uint32_t buttons = totals.held;
    // A click that begins and ends between two ticks still shows for one.
    if (totals.markPresses != m_seen.markPresses)
        buttons |= core::kButtonMark;
    if (totals.stopPresses != m_seen.stopPresses)
        buttons |= core::kButtonStop;
    return buttons;
}

void KeyboardMouseDevice::show(const realtime::HapticTick&, const core::VisibleCues& cues) noexcept {
    const double share = std::clamp(cues.shownForce_N / m_settings.slowestAt_N, 0.0, 1.0);
    m_ratio = std::isfinite(share) ? 1.0 - (1.0 - m_settings.slowestRatio) * share : m_settings.slowestRatio;
}

} // namespace chiron::devices
