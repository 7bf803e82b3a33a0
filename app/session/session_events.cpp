// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/session_events.h"

#include <algorithm>

namespace chiron::session {

void SessionEventsBuilder::add(std::span<const core::HapticFrame> frames) {
    m_extractor.add(frames);
    for (const core::HapticFrame& frame : frames)
        m_times.push_back({frame.header.index, m_time.at(frame)});
}

SessionEvents SessionEventsBuilder::take(const ExerciseKind& kind, const scoring::SessionTrace& trace) const {
    SessionEvents out;
    out.events = m_extractor.events();
    out.trials = m_extractor.trials();
    out.frames = m_extractor.frames();
    out.lastTick = m_extractor.lastTick();
    out.finished = m_extractor.finished();
    out.faulted = m_extractor.faulted();
    const auto answers = answerEvents(kind, m_times, trace, out.trials);
    out.events.insert(out.events.end(), answers.begin(), answers.end());
    std::stable_sort(out.events.begin(), out.events.end(),
                     [](const auto& a, const auto& b) { return a.tick < b.tick; });
    return out;
}

} // namespace chiron::session
