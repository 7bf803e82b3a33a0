// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/haptic_frame.h"
#include "database/repositories/session_types.h"
#include "scoring/trace.h"
#include "session/answer_events.h"
#include "session/device_time.h"
#include "session/event_extractor.h"

#include <cstdint>
#include <span>
#include <vector>

namespace chiron::session {

class ExerciseKind;

/// What happened in a session by its recording, as the end of the session stores it.
struct SessionEvents {
    std::vector<database::EventRecord> events; ///< in the order of their ticks, outcomes of answers included
    std::vector<database::TrialRecord> trials; ///< one that has not ended has state `running`
    std::uint64_t frames = 0;
    std::uint64_t lastTick = 0;
    bool finished = false; ///< the exercise reached its end by itself
    bool faulted = false;  ///< the last frame is in a latched fault
};

/// Collects the events of a recording from its frames, in order, chunk by chunk.
class SessionEventsBuilder {
public:
    /// `positions`: of the session's tools; it must outlive the calls of add(). `sceneEvents`: those of the
    /// exercise.
    SessionEventsBuilder(double forceLimit_N, std::uint64_t sessionSeed, int tools,
                         const recording::IPositionOf* positions, std::span<const SceneEvent> sceneEvents)
        : m_extractor(forceLimit_N, sessionSeed, tools, positions, sceneEvents) {}
    void add(std::span<const core::HapticFrame> frames);
    /// `trace`: of the same recording; the outcomes of answers are judged by it.
    SessionEvents take(const ExerciseKind& kind, const scoring::SessionTrace& trace) const;

private:
    EventExtractor m_extractor;
    DeviceTime m_time;
    std::vector<FrameTime> m_times;
};

} // namespace chiron::session
