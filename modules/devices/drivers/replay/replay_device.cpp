// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/drivers/replay/replay_device.h"

#include <algorithm>

namespace chiron::devices {

core::DeviceSample ReplayDevice::read(const realtime::HapticTick& now) noexcept {
    const std::size_t last = m_samples.size() - 1;
    const Step& step = m_samples[std::min(m_next, last)];
    if (m_next > last)
        m_finished.store(true, std::memory_order_release);
    else
        ++m_next;
    core::DeviceSample sample;
    std::copy(step.counts.begin(), step.counts.end(), sample.counts.begin());
    sample.jawCounts = step.jawCounts;
    sample.buttons = step.buttons;
    sample.packet = ++m_packet;
    sample.status = core::sample_status::kHomed;
    sample.deviceTime_us = now.index() * 1000;
    sample.arrival_ns = now.now_ns();
    return sample;
}

} // namespace chiron::devices
