// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/haptic_frame.h"
#include "recording/position_of.h"
#include "scoring/trace.h"

#include <span>

namespace chiron::session {

/// Stored frames -> what metrics see. Frames are given in order, chunk by chunk, so a long session is never held as
/// frames; a trial runs from its kTrialStarted frame to its kMarked or kTimedOut frame, both included. A trial that has
/// neither end (stopped, interrupted) stays, unmarked. Live scoring, review, verify and export all come through here.
class TraceAssembler {
public:
    TraceAssembler(const recording::IPositionOf& positions, int tools) : m_positions(positions), m_tools(tools) {}

    void add(std::span<const core::HapticFrame> frames);
    std::vector<scoring::TrialTrace> takeTrials() { return std::move(m_trials); }

private:
    void begin(const core::HapticFrame& frame);
    void append(const core::HapticFrame& frame);
    void end(const core::HapticFrame& frame);

    const recording::IPositionOf& m_positions;
    int m_tools;
    bool m_inTrial = false;
    bool m_haveOrigin = false;
    std::uint64_t m_origin_us = 0; ///< device time of tool 0's first frame
    std::vector<scoring::TrialTrace> m_trials;
};

} // namespace chiron::session
