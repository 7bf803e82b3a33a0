// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "database/repositories/session_types.h"
#include "scoring/trace.h"
#include "session/device_time.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace chiron::session {

class ExerciseKind;

/// When each frame of a recording was, in its order.
struct FrameTime {
    std::uint64_t tick = 0;
    double t_s = 0.0; ///< device time since the first frame
};

/// Events whose tick and time are still to be read from the frames.
class AnswerEvents {
public:
    /// At the frame of this tick; the detail is the trial.
    void addAt(std::uint64_t tick, const char* kind, int trial);
    /// At the first frame that is not earlier than this, device time.
    void addFrom(double t_s, const char* kind, std::string detailJson);

    bool empty() const noexcept { return m_wanted.empty(); }
    void place(const FrameTime& frame); ///< each frame, in order
    std::vector<database::EventRecord> take(); ///< those that were placed

private:
    struct Wanted {
        std::optional<std::uint64_t> tick;
        double from_s = 0.0; ///< without a tick
        bool placed = false;
        database::EventRecord event;
    };
    Wanted& want(const char* kind, std::string detailJson);

    std::vector<Wanted> m_wanted;
};

/// What a session's answers were worth, as events among the others (ExerciseKind::addAnswerEvents). Pure.
std::vector<database::EventRecord> answerEvents(const ExerciseKind& kind, std::span<const FrameTime> frames,
                                                const scoring::SessionTrace& trace, std::span<const database::TrialRecord> trials);

} // namespace chiron::session
