// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "database/repositories/session_types.h"
#include "scoring/trace.h"
#include "session/device_time.h"

#include <cstdint>
#include <span>
#include <vector>

namespace chiron::session {

/// When each frame of a recording was, in its order.
struct FrameTime {
    std::uint64_t tick = 0;
    double t_s = 0.0; ///< device time since the first frame
};

/// What a session's answers were worth, as events among the others: "missed" (a mark beside the sphere, or in the air), "false_alarm"
/// (where a finding was marked that found no lump; detail: finding, from 1) and "lump_missed" (at the end of a trial that came to
/// one). By the same judgement as the scores. Pure.
std::vector<database::EventRecord> answerEvents(std::span<const FrameTime> frames, const scoring::SessionTrace& trace,
                                                std::span<const database::TrialRecord> trials);

} // namespace chiron::session
