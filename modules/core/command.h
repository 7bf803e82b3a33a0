// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace chiron::core {

/// A request to the loop by a person, the study runner or the session. The loop applies it at the start of a
/// tick and records it in that tick's frame, so that a replay applies it at the same tick. At most two are
/// applied per tick; the others wait.
enum class CommandKind : std::uint16_t {
    none = 0,
    start = 1,       ///< begin the first trial (or leave familiarisation)
    pause = 2,       ///< ramp to zero in 0.5 s; ticks and recording continue
    resume = 3,      ///< leave the pause and arm again
    confirmHold = 4, ///< "Resume here": arm by confirmation while the tool is held still
    stopForce = 5,   ///< Esc or button: zero force within 2 ticks, explicit re-arm needed
    rearm = 6,       ///< after a stop or a latched fault
    mark = 7,        ///< a mark by key or click instead of the device's button
    end = 8,         ///< the person ends the session
    report = 9,      ///< a person's report; argument: its word, whose meaning the exercise defines
    present = 10,    ///< next stimulus of a study; argument: a presentation word (presentation_word.h)
    answer = 11,     ///< a participant's answer; argument: the outcome of the task, from 0
};

struct Command {
    CommandKind kind = CommandKind::none;
    std::uint16_t argument = 0;
};

inline constexpr int kMaxCommandsPerTick = 2;

} // namespace chiron::core
