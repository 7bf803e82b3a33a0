// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/haptic_frame.h"

#include <cstdint>

namespace chiron::session {

/// Neither its place nor its time is to be believed, and the clock of those to come must not follow it.
inline bool isRefused(const core::ToolFrame& tool) noexcept {
    return (tool.status & core::sample_status::kRefused) != 0;
}

/// The time that scores, events, playback and export share: the device's clock of tool 0 since its first packet that was
/// not refused. A refused packet brings no time.
class DeviceTime {
public:
    /// s, at this frame. Negative where the device's clock was set back.
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
    bool started() const noexcept { return m_started; } ///< a packet that can be believed has come
    /// s, of a time of any tool; once started.
    double since(std::uint64_t deviceTime_us) const noexcept {
        return static_cast<double>(static_cast<std::int64_t>(deviceTime_us - m_origin_us)) * 1e-6;
    }

private:
    bool m_started = false;
    std::uint64_t m_origin_us = 0;
    double m_last_s = 0.0;
};

} // namespace chiron::session
