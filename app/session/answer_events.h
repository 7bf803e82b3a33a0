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

/// The tick and time of each frame of a recording, in the frames' order.
struct FrameTime {
    std::uint64_t tick = 0;
    double t_s = 0.0; ///< device time since the first frame
};

/// Collects events whose tick and time are found later, when the frames are read.
class AnswerEvents {
public:
    /// Adds an event at the frame of this tick; its detail is the trial.
    void addAt(std::uint64_t tick, const char* kind, int trial);
    /// Adds an event at the first frame that is not earlier than this device time.
    void addFrom(double t_s, const char* kind, std::string detailJson);

    bool empty() const noexcept { return m_wanted.empty(); }
    void place(const FrameTime& frame);        ///< call it for each frame, in order
    std::vector<database::EventRecord> take(); ///< the events whose frame was found

private:
    struct Wanted {
        std::optional<std::uint64_t> tick;
        double from_s = 0.0; ///< used if there is no tick
        bool placed = false;
        database::EventRecord event;
    };
    Wanted& want(const char* kind, std::string detailJson);

    std::vector<Wanted> m_wanted;
};

/// The outcomes of a session's answers as events (ExerciseKind::addAnswerEvents). Pure function.
std::vector<database::EventRecord> answerEvents(const ExerciseKind& kind, std::span<const FrameTime> frames,
                                                const scoring::SessionTrace& trace,
                                                std::span<const database::TrialRecord> trials);

} // namespace chiron::session
