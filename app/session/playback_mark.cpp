// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/playback_mark.h"

#include "core/contact_bits.h"
#include "scoring/force_facts.h"
#include "session/event_extractor.h"
#include "session/trace_mark.h"
#include "session/yield_cause.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace chiron::session {

namespace {

constexpr double kContact_N = 0.02;
constexpr double kBridge_s = 0.2;
// The slew limit acts for one or two ticks at every contact, which nobody can feel.
constexpr double kShortest_s = 0.02;

double tissueOf(const core::ToolFrame& tool) {
    return std::hypot(tool.tissue[0], tool.tissue[1], tool.tissue[2]);
}

double torqueOf(const core::ToolFrame& tool) {
    return std::hypot(tool.tissue[3], tool.tissue[4], tool.tissue[5]);
}

} // namespace

PlaybackMark& MarkExtractor::note(const core::HapticFrame& frame, double t_s, const PlaybackMarkKind& kind,
                                  int tool) {
    PlaybackMark mark;
    mark.t_s = mark.end_s = t_s;
    mark.tick = frame.header.index;
    mark.kind = kind;
    mark.trial = frame.header.trial;
    mark.tool = tool;
    m_marks.push_back(std::move(mark));
    return m_marks.back();
}

void MarkExtractor::follow(Span& span, bool on, const core::HapticFrame& frame, double t_s,
                           const PlaybackMarkKind& kind, int tool, double bridge_s) {
    if (on && !span.open) {
        const bool goesOn = span.mark && m_marks[*span.mark].trial == frame.header.trial &&
                            t_s - m_marks[*span.mark].end_s <= bridge_s;
        if (!goesOn) {
            note(frame, t_s, kind, tool);
            span.mark = m_marks.size() - 1;
        }
    }
    if (span.mark && (on || span.open))
        m_marks[*span.mark].end_s = t_s;
    span.open = on;
}

void MarkExtractor::add(const core::HapticFrame& frame, double t_s) {
    addCommands(frame, t_s);
    addGrasps(frame, t_s);
    addTrialEvents(frame, t_s);
    addGuards(frame, t_s);
    addForces(frame, t_s);
    addStandstill(frame, t_s);
}

// A standstill because force was stopped by a person or by the supervisor is not a pause.
void MarkExtractor::addStandstill(const core::HapticFrame& frame, double t_s) {
    const core::ForceState force = frame.header.force;
    if (frame.header.paused == 0)
        m_standstill = Standstill::none;
    else if (force == core::ForceState::stopped)
        m_standstill = Standstill::stop;
    else if (force == core::ForceState::fault)
        m_standstill = Standstill::fault;
    else if (m_standstill == Standstill::none)
        m_standstill = Standstill::pause;
    if (m_standstill != Standstill::stop)
        m_stop.reset();
    if (m_stop)
        m_marks[*m_stop].end_s = t_s;
    follow(m_paused, m_standstill == Standstill::pause, frame, t_s, mark_kinds::kPaused);
}

void MarkExtractor::addCommands(const core::HapticFrame& frame, double t_s) {
    for (const core::Command& command : frame.header.commands) {
        if (command.kind == core::CommandKind::rearm)
            note(frame, t_s, mark_kinds::kRearmed);
        if (command.kind == core::CommandKind::end)
            note(frame, t_s, mark_kinds::kEnded);
    }
}

void MarkExtractor::addTrialEvents(const core::HapticFrame& frame, double t_s) {
    using namespace core::event_bits;
    const std::uint32_t events = frame.header.events;
    if (events & kTrialStarted)
        note(frame, t_s, mark_kinds::kTrialStarted);
    if ((events & kStageChanged) && !(events & kCompleted))
        note(frame, t_s, mark_kinds::kStageChanged);
    for (const SceneEvent& event : m_sceneEvents)
        if (events & event.bit)
            note(frame, t_s, event.mark);
    if (events & kCompleted)
        note(frame, t_s, mark_kinds::kCompleted);
    else if (events & kMarked)
        note(frame, t_s, isMarkOfTraceEnd(frame) ? mark_kinds::kTraceEnded : mark_kinds::kMarked);
    else if (events & kFailed)
        note(frame, t_s, mark_kinds::kFailed);
    else if (events & kTimedOut)
        note(frame, t_s, mark_kinds::kTimedOut);
}

void MarkExtractor::addGrasps(const core::HapticFrame& frame, double t_s) {
    using namespace core::event_bits;
    constexpr std::pair<std::uint32_t, PlaybackMarkKind> kKinds[] = {{kGrasped, mark_kinds::kGrasped},
                                                                     {kReleased, mark_kinds::kReleased},
                                                                     {kSlipped, mark_kinds::kSlipped},
                                                                     {kDamaged, mark_kinds::kDamaged}};
    for (const auto& [bit, kind] : kKinds)
        if (frame.header.events & bit)
            note(frame, t_s, kind);
}

void MarkExtractor::addGuards(const core::HapticFrame& frame, double t_s) {
    const std::uint32_t begun = frame.header.guards & ~m_guards;
    for (const MarkedGuard& guard : markedGuards()) {
        if (begun & guard.bit)
            note(frame, t_s, guard.latched ? mark_kinds::kFault : mark_kinds::kGuard).detail = guard.word;
    }
    m_guards = frame.header.guards;
    if (frame.header.force == core::ForceState::stopped && m_force != core::ForceState::stopped) {
        note(frame, t_s, mark_kinds::kForceStopped);
        m_stop = m_marks.size() - 1;
    }
    m_force = frame.header.force;
}

void MarkExtractor::addForces(const core::HapticFrame& frame, double t_s) {
    const bool scored = frame.header.paused == 0;
    for (int tool = 0; tool < m_tools; ++tool) {
        const auto i = static_cast<std::size_t>(tool);
        const double tissue = tissueOf(frame.tool[i]);
        const YieldLoad load = m_loads.at(tool, frame.tool[i]);
        if (core::contactOfStatus(frame.tool[i].status) & core::contact_bits::kYielded)
            noteYield(frame, t_s, tool, load);
        follow(m_contact[i], tissue > kContact_N, frame, t_s, mark_kinds::kContact, tool, kBridge_s);
        const bool over = scored && tissue > m_forceLimit_N;
        follow(m_over[i], over, frame, t_s, mark_kinds::kOverLimit, tool);
        if (over) {
            std::optional<double>& worst = m_marks[*m_over[i].mark].value;
            worst = std::max(worst.value_or(0.0), tissue);
        }
        addLimited(frame, t_s, tool);
    }
}

/// Tissue that gives way before a trial runs, or during a pause, does not count as an error, and none does
/// where errors are not counted.
void MarkExtractor::noteYield(const core::HapticFrame& frame, double t_s, int tool, const YieldLoad& load) {
    const auto i = static_cast<std::size_t>(tool);
    const bool byTorque =
        gaveWayToTorque(m_yield, tissueOf(frame.tool[i]), torqueOf(frame.tool[i])); // at this tick
    PlaybackMark& mark = note(frame, t_s, mark_kinds::kYielded, tool);
    mark.value = byTorque ? load.torque_Nm : load.force_N;
    if (byTorque)
        mark.detail = kByTorque;
    mark.critical =
        m_countsErrors && frame.header.phase == core::TrialPhase::running && frame.header.paused == 0;
    mark.p_W = yieldPlaceOf(m_positions, tool, frame.tool[i]);
}

void MarkExtractor::addLimited(const core::HapticFrame& frame, double t_s, int tool) {
    const auto i = static_cast<std::size_t>(tool);
    const core::Array6& f = frame.tool[i].commanded;
    const double tissue = tissueOf(frame.tool[i]);
    const bool running = frame.header.phase == core::TrialPhase::running && frame.header.paused == 0;
    const bool limited = m_felt && running && tissue > std::hypot(f[0], f[1], f[2]) + scoring::kLimited_N;
    follow(m_limited[i], limited, frame, t_s, mark_kinds::kLimited, tool, kBridge_s);
    if (!limited)
        return;
    std::optional<double>& largest = m_marks[*m_limited[i].mark].value;
    largest = std::max(largest.value_or(0.0), tissue);
}

std::vector<PlaybackMark> MarkExtractor::take(double end_s) {
    const auto close = [&](Span& span) {
        if (span.open)
            m_marks[*span.mark].end_s = end_s;
        span = {};
    };
    close(m_paused);
    std::for_each(m_over.begin(), m_over.end(), close);
    std::for_each(m_contact.begin(), m_contact.end(), close);
    std::for_each(m_limited.begin(), m_limited.end(), close);
    std::erase_if(m_marks, [](const PlaybackMark& mark) {
        return mark.kind == mark_kinds::kLimited && mark.end_s - mark.t_s < kShortest_s;
    });
    std::stable_sort(m_marks.begin(), m_marks.end(),
                     [](const PlaybackMark& a, const PlaybackMark& b) { return a.t_s < b.t_s; });
    return std::move(m_marks);
}

} // namespace chiron::session
