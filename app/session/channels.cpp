// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/channels.h"

#include "session/exercise_kind.h"

namespace chiron::session {

core::Result<recording::ChannelTable> channelTableFor(const SessionSetup& setup) {
    std::vector<recording::ToolChannels> tools;
    for (const devices::DeviceDescriptor& device : setup.devices) {
        recording::ToolChannels channels;
        for (const devices::AxisDescriptor& axis : device.axes)
            channels.axes.push_back(
                {axis.id, axis.unit == devices::AxisUnit::metre ? "m" : "rad", axis.resolution});
        channels.jawResolution_rad = device.jawResolution_rad;
        channels.period_us = device.period_us;
        tools.push_back(std::move(channels));
    }
    const auto kind = exerciseKind(setup.level.exercise);
    CHIRON_TRY(kind);
    return recording::ChannelTable::forTools(
        tools, {(*kind)->quantities(setup.level), (*kind)->recordsEnergy(setup.level)});
}

} // namespace chiron::session
