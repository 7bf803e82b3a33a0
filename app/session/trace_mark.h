// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/haptic_frame.h"

namespace chiron::session {

/// A trial's last frame has one of these, unless it was stopped.
inline constexpr std::uint32_t kTrialEnds =
    core::event_bits::kMarked | core::event_bits::kCompleted | core::event_bits::kTimedOut |
    core::event_bits::kFailed;

/// Argument of a mark command that nobody gave: a trace ended without a mark, so its last position is the
/// answer.
inline constexpr std::uint16_t kMarkOfTraceEnd = 1;

/// Whether the mark of this frame is one that nobody gave; such a trial is scored but does not count as
/// marked.
inline bool isMarkOfTraceEnd(const core::HapticFrame& frame) noexcept {
    for (const core::Command& command : frame.header.commands) {
        if (command.kind == core::CommandKind::mark && command.argument == kMarkOfTraceEnd)
            return true;
    }
    return false;
}

} // namespace chiron::session
