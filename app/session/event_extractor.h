// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/haptic_frame.h"
#include "database/repositories/session_types.h"
#include "recording/position_of.h"
#include "session/device_time.h"
#include "session/playback_mark.h"
#include "session/yield_load.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace chiron::session {

/// A guard of the supervisor that playback marks, with its stored word.
struct MarkedGuard {
    std::uint32_t bit = 0;
    const char* word = "";
    bool latched = false; ///< a fault that persists
};
/// Caps, slew limit and arming are not included, because they act all the time and can be read from the
/// channel.
std::span<const MarkedGuard> markedGuards() noexcept;

/// Converts stored frames to the events and trials of a session, as playback marks them and the database
/// stores them: trial starts, marks, time-outs, stages, landmarks, completions, commands, the onset of each
/// guard, tissue that gave way (with its force in mN and torque in mN·m, and where the tip was, in m and W;
/// which of force and torque was the cause follows from the level: yield_cause.h), and the onset of tissue
/// force over the limit. The change of stage that completes a procedure is reported as its completion.
class EventExtractor {
public:
    /// `positions`: of the session's tools; it must outlive the calls of add(). Null: no event has a place.
    /// `sceneEvents`: those of the exercise (ExerciseKind::sceneEvents).
    EventExtractor(double forceLimit_N, std::uint64_t sessionSeed, int tools,
                   const recording::IPositionOf* positions = nullptr,
                   std::span<const SceneEvent> sceneEvents = {})
        : m_forceLimit_N(forceLimit_N), m_seed(sessionSeed), m_tools(tools), m_positions(positions),
          m_sceneEvents(sceneEvents) {}

    void add(std::span<const core::HapticFrame> frames);
    const std::vector<database::EventRecord>& events() const noexcept { return m_events; }
    /// Trials so far; one that has not ended has state `running`.
    const std::vector<database::TrialRecord>& trials() const noexcept { return m_trials; }
    std::uint64_t frames() const noexcept { return m_frames; }
    std::uint64_t lastTick() const noexcept { return m_lastTick; }
    bool finished() const noexcept { return m_finished; } ///< the exercise reached its end by itself
    bool faulted() const noexcept { return m_faulted; }   ///< the last frame is in a latched fault
    bool ended() const noexcept { return m_endCommand; }  ///< the person ended the session

private:
    void addFrame(const core::HapticFrame& frame);
    void addCommands(const core::HapticFrame& frame, double t_s);
    void addGuards(const core::HapticFrame& frame, double t_s);
    void addYields(const core::HapticFrame& frame, double t_s);
    void addOverForce(const core::HapticFrame& frame, double t_s);
    void addTrialEvents(const core::HapticFrame& frame, double t_s);
    void note(const core::HapticFrame& frame, double t_s, const char* kind, int tool = 0);

    double m_forceLimit_N;
    std::uint64_t m_seed;
    int m_tools;
    const recording::IPositionOf* m_positions;
    std::span<const SceneEvent> m_sceneEvents;
    DeviceTime m_time;
    std::uint64_t m_frames = 0;
    std::uint64_t m_lastTick = 0;
    std::uint32_t m_guards = 0;
    std::array<bool, core::kMaxTools> m_over{};
    YieldLoads m_loads;
    bool m_finished = false;
    bool m_faulted = false;
    bool m_endCommand = false;
    std::vector<database::EventRecord> m_events;
    std::vector<database::TrialRecord> m_trials;
};

} // namespace chiron::session
