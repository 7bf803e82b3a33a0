// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/recorded_inputs.h"

#include "core/contact_bits.h"

namespace chiron::haptics {

void RecordedInputs::gather(const realtime::HapticTick& now, std::span<devices::IDevice* const> devices,
                            TickInputs& inputs) noexcept {
    inputs.commands = m_frame.header.commands;
    inputs.heartbeatAge_ms = m_frame.header.heartbeatAge_ms;
    inputs.slow = (m_frame.header.events & core::event_bits::kSlowApplied) != 0
                      ? simulation::SlowUpdate::now
                      : simulation::SlowUpdate::notNow;
    for (std::size_t i = 0; i < devices.size() && i < inputs.tools.size(); ++i) {
        const core::ToolFrame& recorded = m_frame.tool[i];
        ToolInput& tool = inputs.tools[i];
        tool.sample.counts = recorded.counts;
        tool.sample.jawCounts = recorded.jawCounts;
        tool.sample.buttons = recorded.buttons;
        tool.sample.packet = recorded.packet;
        // The supervisor and the scene set these bits anew.
        tool.sample.status = recorded.status & ~(core::sample_status::kRefused | core::kContactStatusMask);
        tool.sample.deviceTime_us = recorded.deviceTime_us;
        tool.sample.arrival_ns = now.now_ns() - static_cast<std::int64_t>(recorded.age_us) * 1'000;
        tool.sample.measured = recorded.measured;
        tool.age_us = recorded.age_us;
    }
}

} // namespace chiron::haptics
