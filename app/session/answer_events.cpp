// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/answer_events.h"

#include "session/exercise_kind.h"

#include <algorithm>

namespace chiron::session {

void AnswerEvents::addAt(std::uint64_t tick, const char* kind, int trial) {
    want(kind, "{\"trial\":" + std::to_string(trial) + "}").tick = tick;
}

void AnswerEvents::addFrom(double t_s, const char* kind, std::string detailJson) {
    want(kind, std::move(detailJson)).from_s = t_s;
}

AnswerEvents::Wanted& AnswerEvents::want(const char* kind, std::string detailJson) {
    Wanted& wanted = m_wanted.emplace_back();
    wanted.event.kind = kind;
    wanted.event.detailJson = std::move(detailJson);
    return wanted;
}

void AnswerEvents::place(const FrameTime& frame) {
    constexpr double kSameTime_s = 0.6e-6; // traces have times in whole microseconds
    for (Wanted& wanted : m_wanted) {
        const bool here = wanted.tick ? frame.tick >= *wanted.tick : frame.t_s + kSameTime_s >= wanted.from_s;
        if (wanted.placed || !here)
            continue;
        wanted.placed = true;
        wanted.event.tick = frame.tick;
        wanted.event.time_s = std::max(0.0, frame.t_s);
    }
}

std::vector<database::EventRecord> AnswerEvents::take() {
    std::vector<database::EventRecord> events;
    for (Wanted& wanted : m_wanted)
        if (wanted.placed)
            events.push_back(std::move(wanted.event));
    return events;
}

std::vector<database::EventRecord> answerEvents(const ExerciseKind& kind, std::span<const FrameTime> frames,
                                                const scoring::SessionTrace& trace,
                                                std::span<const database::TrialRecord> trials) {
    AnswerEvents events;
    for (std::size_t i = 0; i < std::min(trace.trials.size(), trials.size()); ++i)
        kind.addAnswerEvents(trace.trials[i], trials[i], events);
    if (events.empty())
        return {};
    for (const FrameTime& frame : frames)
        events.place(frame);
    return events.take();
}

} // namespace chiron::session
