// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/haptic_frame.h"

namespace chiron::session {

/// The last frame of a trial has one of these events, unless the trial was stopped.
inline constexpr std::uint32_t kTrialEnds = core::event_bits::kMarked | core::event_bits::kCompleted |
                                            core::event_bits::kTimedOut | core::event_bits::kFailed;

/// Argument of a mark command that no person gave: a trace ended without a mark, so its last position is the
/// answer.
inline constexpr std::uint16_t kMarkOfTraceEnd = 1;

/// True if no person gave the mark of this frame; such a trial is scored but does not count as marked.
inline bool isMarkOfTraceEnd(const core::HapticFrame& frame) noexcept {
    for (const core::Command& command : frame.header.commands) {
        if (command.kind == core::CommandKind::mark && command.argument == kMarkOfTraceEnd)
            return true;
    }
    return false;
}

} // namespace chiron::session
