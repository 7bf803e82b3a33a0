// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/haptic_frame.h"
#include "recording/position_of.h"

#include <vector>

namespace chiron::tests {

/// A tip whose coordinates are its counts in millimetres; the second tool's lie 100 mm to the side.
class MillimetreCounts final : public recording::IPositionOf {
public:
    core::Vec3 p_WT_m(int tool, const core::ToolFrame& frame) const noexcept override {
        return {1e-3 * frame.counts[0] + 0.1 * tool, 1e-3 * frame.counts[1], 1e-3 * frame.counts[2]};
    }
};

/// `count` ticks from `first` on, a millisecond of device time each, x counting up with the tick.
inline std::vector<core::HapticFrame> someFrames(std::size_t count, std::uint64_t first = 0,
                                                 std::uint32_t tools = 1) {
    std::vector<core::HapticFrame> frames(count);
    for (std::size_t i = 0; i < count; ++i) {
        core::HapticFrame& frame = frames[i];
        frame.tools = tools;
        frame.header.index = first + i;
        frame.header.phase = core::TrialPhase::running;
        frame.header.force = core::ForceState::on;
        for (std::uint32_t t = 0; t < tools; ++t) {
            frame.tool[t].deviceTime_us = 5'000'000 + (first + i) * 1000;
            frame.tool[t].counts[0] = static_cast<std::int32_t>(first + i);
        }
    }
    return frames;
}

} // namespace chiron::tests
