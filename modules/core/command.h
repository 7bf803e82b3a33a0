// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace chiron::core {

/// What a person, the study runner or the session asks of the loop. Applied at the start of a tick, recorded in that
/// tick's frame, so that a replay applies it at the same place. At most two a tick; the rest wait.
enum class CommandKind : std::uint16_t {
    none = 0,
    start = 1,       ///< begin the first trial (or leave familiarisation)
    pause = 2,       ///< ramp to zero in 0.5 s; ticks and recording go on
    resume = 3,      ///< leave pause through arming
    confirmHold = 4, ///< "Resume here": arming by confirmation with the tool held still
    stopForce = 5,   ///< Esc, button: zero within 2 ticks, explicit re-arm
    rearm = 6,       ///< after stop or a latched fault
    mark = 7,        ///< mark by key or click instead of the device's button
    end = 8,         ///< the person ends the session
    report = 9,      ///< what was found; argument: a report word (palpation_cues.h)
    present = 10,    ///< a study's next stimulus; argument: a presentation word (presentation_word.h)
    answer = 11,     ///< what a participant answered; argument: the outcome of the task, from 0
};

struct Command {
    CommandKind kind = CommandKind::none;
    std::uint16_t argument = 0;
};

inline constexpr int kMaxCommandsPerTick = 2;

} // namespace chiron::core
