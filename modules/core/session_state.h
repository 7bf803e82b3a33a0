// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace chiron::core {

/// State of a trial. It is stored in every frame: the numbers are part of the recording's format.
enum class TrialPhase : std::uint8_t {
    idle = 0,     ///< before the start command
    ready = 1,    ///< the scene is there; waits until force is armed
    running = 2,  ///< the person works; this time is scored
    between = 3,  ///< marked or timed out; the next scene follows
    finished = 4, ///< the last trial is over
};

/// State of the supervisor's force output. Stored in every frame.
enum class ForceState : std::uint8_t {
    off = 0,     ///< never armed yet
    arming = 1,  ///< waits for a small requested force or a confirmation
    ramping = 2, ///< 2 s ramp to full
    on = 3,
    pausing = 4, ///< ramp to zero in 0.5 s
    paused = 5,
    stopped = 6,         ///< stop pressed; needs a re-arm
    fault = 7,           ///< latched
    heldByWatchdog = 8,  ///< ramped down or zero because samples are late, not yet latched
    heldByHeartbeat = 9, ///< the window is silent: ramped to zero; resumes by arming
};

/// The guards of the supervisor that act at this tick, one bit each, in every frame (`TickHeader::guards`).
namespace guard_bits {
inline constexpr std::uint32_t kCap = 1u << 0;
inline constexpr std::uint32_t kSlew = 1u << 1;
inline constexpr std::uint32_t kArming = 1u << 2;
inline constexpr std::uint32_t kOverVelocity = 1u << 3;
inline constexpr std::uint32_t kBadSample = 1u << 4;
inline constexpr std::uint32_t kSampleFault = 1u << 5;
inline constexpr std::uint32_t kWatchdog = 1u << 6;
inline constexpr std::uint32_t kWatchdogFault = 1u << 7;
inline constexpr std::uint32_t kStop = 1u << 8;
inline constexpr std::uint32_t kHeartbeat = 1u << 9;
inline constexpr std::uint32_t kPassivity = 1u << 10;
inline constexpr std::uint32_t kNotFinite = 1u << 11;
inline constexpr std::uint32_t kDeviceFault = 1u << 12;
inline constexpr std::uint32_t kPause = 1u << 13;
} // namespace guard_bits

/// The events of the scene at this tick, one bit each, in every frame (`TickHeader::events`).
namespace event_bits {
inline constexpr std::uint32_t kSceneChanged = 1u << 0; ///< geometry moved: the supervisor arms again
inline constexpr std::uint32_t kTrialStarted = 1u << 1; ///< ready -> running
inline constexpr std::uint32_t kMarked = 1u << 2;       ///< the tool's position at this tick is the answer
inline constexpr std::uint32_t kTimedOut = 1u << 3;
inline constexpr std::uint32_t kContactBegan = 1u << 4;
inline constexpr std::uint32_t kContactEnded = 1u << 5;
inline constexpr std::uint32_t kFinished = 1u << 6;     ///< the last trial ended
inline constexpr std::uint32_t kCompleted = 1u << 7;    ///< the trial's procedure is done; ends the trial,
                                                        ///< as a mark does
inline constexpr std::uint32_t kStageChanged = 1u << 8; ///< the task went on to its next stage or step; each
                                                        ///< exercise has its own
// 1u << 9 is left to the exercises: each may give it a meaning of its own.
inline constexpr std::uint32_t kGrasped = 1u << 10;  ///< an instrument took hold of something
inline constexpr std::uint32_t kReleased = 1u << 11; ///< an instrument released something on purpose
inline constexpr std::uint32_t kSlipped = 1u
                                          << 12; ///< something slipped out of an instrument, or was dropped
inline constexpr std::uint32_t kDamaged = 1u << 13; ///< a limit of the tissue was exceeded
                                                    ///< (over-stretched, over-squeezed)
inline constexpr std::uint32_t kFailed = 1u << 14;  ///< the trial can no longer be completed (torn);
                                                    ///< ends it, as a time-out does
/// The slow model's answer took effect in this tick: a replay applies it at the same tick (architecture.md,
/// Determinism).
inline constexpr std::uint32_t kSlowApplied = 1u << 15;
} // namespace event_bits

} // namespace chiron::core
