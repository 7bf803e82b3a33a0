// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/tool_positions.h"

#include "devices/kinematics_catalogue.h"

#include <algorithm>

namespace chiron::session {

core::Result<std::unique_ptr<ToolPositions>> ToolPositions::create(const SessionSetup& setup) {
    auto positions = std::make_unique<ToolPositions>();
    for (std::size_t i = 0; i < setup.devices.size(); ++i) {
        auto kinematics = devices::makeKinematics(setup.devices[i]);
        CHIRON_TRY(kinematics);
        const auto& axes = setup.devices[i].axes;
        const bool turns = std::any_of(axes.begin(), axes.end(), [](const devices::AxisDescriptor& axis) {
            return axis.unit == devices::AxisUnit::radian;
        });
        positions->m_tools.push_back(
            {std::move(*kinematics), devices::WorkspaceMap(setup.mappings[i]), turns});
    }
    return positions;
}

core::ToolState ToolPositions::pose(int tool, const core::ToolFrame& frame) const noexcept {
    const Tool& t = m_tools[static_cast<std::size_t>(tool)];
    return t.map.pose(*t.kinematics, sampleOf(frame));
}

core::DeviceSample sampleOf(const core::ToolFrame& frame) noexcept {
    core::DeviceSample sample;
    sample.counts = frame.counts;
    sample.jawCounts = frame.jawCounts;
    sample.buttons = frame.buttons;
    sample.packet = frame.packet;
    sample.status = frame.status;
    sample.deviceTime_us = frame.deviceTime_us;
    sample.measured = frame.measured;
    return sample;
}

} // namespace chiron::session
