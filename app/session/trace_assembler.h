// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/haptic_frame.h"
#include "recording/position_of.h"
#include "scoring/trace.h"
#include "session/device_time.h"
#include "session/orientation_of.h"
#include "session/recorded_quantities.h"

#include <array>
#include <span>
#include <utility>
#include <vector>

namespace chiron::session {

/// Distinguishes packets of one tool that advance its time from packets that were read before.
class SampleClock {
public:
    bool advances(std::uint64_t deviceTime_us) noexcept {
        if (m_started && deviceTime_us <= m_last_us)
            return false;
        m_started = true;
        m_last_us = deviceTime_us;
        return true;
    }

private:
    bool m_started = false;
    std::uint64_t m_last_us = 0;
};

/// Converts stored frames to the traces that metrics use. Frames are added in order, chunk by chunk, so a
/// long session is never held as frames. A trial runs from its kTrialStarted frame to its kMarked,
/// kCompleted, kTimedOut or kFailed frame, both included. A trial without an end (stopped, interrupted) is
/// kept as unmarked, as is one that ended with its trace (trace_mark.h). A packet that was read twice (device
/// time not later than the last kept one of that tool, over the whole recording) gives one sample. A packet
/// that the supervisor refused gives none, and a mark that arrived with it is placed where the last good
/// packet left the tool. Orientation and torque are kept for tools that can turn; the scene's quantities are
/// kept at the samples of tool 0, which represents the tick. Live scoring, review and verify all use this
/// class.
class TraceAssembler {
public:
    /// `orientations` may be null: then no tool turns. `quantities`: those of the recording.
    TraceAssembler(const recording::IPositionOf& positions, int tools,
                   const IOrientationOf* orientations = nullptr, RecordedQuantities quantities = {})
        : m_positions(positions), m_orientations(orientations), m_tools(tools),
          m_quantities(std::move(quantities)) {}

    void add(std::span<const core::HapticFrame> frames);
    std::vector<scoring::TrialTrace> takeTrials() { return std::move(m_trials); }
    /// True if the last trial has no end because it was cut off by a stop or by the end of the program.
    bool lastIsCutOff() const { return m_inTrial; }

private:
    void begin(const core::HapticFrame& frame);
    void append(const core::HapticFrame& frame);
    void appendTool(const core::HapticFrame& frame, std::size_t tool);
    void hold(std::size_t tool); ///< counts one more running tick for the newest sample
    void end(const core::HapticFrame& frame);

    const recording::IPositionOf& m_positions;
    const IOrientationOf* m_orientations;
    int m_tools;
    RecordedQuantities m_quantities;
    bool m_inTrial = false;
    DeviceTime m_time;
    std::array<SampleClock, core::kMaxTools> m_clocks{};
    /// Running ticks of the trial before its first sample.
    std::array<std::uint32_t, core::kMaxTools> m_ticksBefore{};
    core::ToolFrame m_lastGood{}; ///< of tool 0: the position of a mark
    std::vector<scoring::TrialTrace> m_trials;
};

} // namespace chiron::session
