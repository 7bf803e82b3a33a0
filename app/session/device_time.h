// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/haptic_frame.h"

#include <cstdint>

namespace chiron::session {

/// True for a sample whose position and time cannot be trusted; the clock of later samples must not depend on
/// it.
inline bool isRefused(const core::ToolFrame& tool) noexcept {
    return (tool.status & core::sample_status::kRefused) != 0;
}

/// The time base that scores, events, playback and export share: the device clock of tool 0 since its first
/// packet that was not refused. A refused packet does not advance the time.
class DeviceTime {
public:
    /// The time at this frame, s. Negative if the device's clock was set back.
    double at(const core::HapticFrame& frame) noexcept {
        const core::ToolFrame& tool = frame.tool[0];
        if (isRefused(tool))
            return m_last_s;
        if (!m_started) {
            m_started = true;
            m_origin_us = tool.deviceTime_us;
        }
        m_last_s = since(tool.deviceTime_us);
        return m_last_s;
    }
    bool started() const noexcept { return m_started; } ///< a trustworthy packet has arrived
    /// Converts a device time of any tool to seconds; call it only once started() is true.
    double since(std::uint64_t deviceTime_us) const noexcept {
        return static_cast<double>(static_cast<std::int64_t>(deviceTime_us - m_origin_us)) * 1e-6;
    }

private:
    bool m_started = false;
    std::uint64_t m_origin_us = 0;
    double m_last_s = 0.0;
};

} // namespace chiron::session
