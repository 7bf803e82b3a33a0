// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/event_extractor.h"

#include "session/trace_mark.h"
#include "session/yield_cause.h"

#include "core/contact_bits.h"

#include <array>
#include <charconv>
#include <cmath>

namespace chiron::session {

namespace {

using core::CommandKind;

const char* wordFor(CommandKind kind) {
    switch (kind) {
    case CommandKind::start:
        return "start";
    case CommandKind::pause:
        return "pause";
    case CommandKind::resume:
        return "resume";
    case CommandKind::confirmHold:
        return "confirm_hold";
    case CommandKind::stopForce:
        return "stop_force";
    case CommandKind::rearm:
        return "rearm";
    case CommandKind::mark:
        return "mark_command";
    case CommandKind::end:
        return "end";
    case CommandKind::present:
        return "presented";
    case CommandKind::answer:
        return "answered";
    case CommandKind::report: // reports are contained in the recorded quantities
    case CommandKind::none:
        break;
    }
    return nullptr;
}

constexpr std::array<MarkedGuard, 8> kMarkedGuards{{
    {core::guard_bits::kOverVelocity, "over_velocity", false},
    {core::guard_bits::kBadSample, "bad_sample", false},
    {core::guard_bits::kSampleFault, "sample_fault", true},
    {core::guard_bits::kWatchdog, "watchdog", false},
    {core::guard_bits::kWatchdogFault, "watchdog_fault", true},
    {core::guard_bits::kHeartbeat, "window_frozen", false},
    {core::guard_bits::kPassivity, "passivity", false},
    {core::guard_bits::kDeviceFault, "device_fault", true},
}};

/// In metres, to a micrometre.
std::string placeJson(const core::Vec3& p_W) {
    std::string text = ",\"position_m\":[";
    for (int axis = 0; axis < 3; ++axis) {
        std::array<char, 40> digits{};
        const double rounded_m = std::round(1e6 * p_W[axis]) / 1e6 + 0.0; // + 0: no minus zero
        const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), rounded_m).ptr;
        text.append(axis == 0 ? "" : ",").append(digits.data(), end);
    }
    return text + "]";
}

const char* endWordOf(std::uint32_t events, bool byTrace) {
    using namespace core::event_bits;
    if (events & kCompleted)
        return "completed";
    if (byTrace)
        return "trace_ended_unmarked";
    if (events & kFailed)
        return "failed";
    return (events & kMarked) ? "marked" : "timed_out";
}

} // namespace

std::span<const MarkedGuard> markedGuards() noexcept {
    return kMarkedGuards;
}

void EventExtractor::add(std::span<const core::HapticFrame> frames) {
    for (const core::HapticFrame& frame : frames)
        addFrame(frame);
}

void EventExtractor::addFrame(const core::HapticFrame& frame) {
    const double t_s = m_time.at(frame);
    addCommands(frame, t_s);
    addTrialEvents(frame, t_s);
    addGuards(frame, t_s);
    addYields(frame, t_s);
    addOverForce(frame, t_s);
    ++m_frames;
    m_lastTick = frame.header.index;
    m_finished = m_finished || frame.header.phase == core::TrialPhase::finished;
    m_faulted = frame.header.force == core::ForceState::fault;
}

void EventExtractor::note(const core::HapticFrame& frame, double t_s, const char* kind, int tool) {
    database::EventRecord event;
    event.tick = frame.header.index;
    event.time_s = std::max(0.0, t_s);
    event.tool = tool;
    event.kind = kind;
    event.detailJson = "{\"trial\":" + std::to_string(frame.header.trial) + "}";
    m_events.push_back(std::move(event));
}

void EventExtractor::addCommands(const core::HapticFrame& frame, double t_s) {
    for (const core::Command& command : frame.header.commands) {
        if (const char* word = wordFor(command.kind))
            note(frame, t_s, word);
        m_endCommand = m_endCommand || command.kind == CommandKind::end;
    }
}

void EventExtractor::addTrialEvents(const core::HapticFrame& frame, double t_s) {
    using namespace core::event_bits;
    const std::uint32_t events = frame.header.events;
    if (events & kTrialStarted) {
        note(frame, t_s, "trial_started");
        database::TrialRecord trial;
        trial.index = frame.header.trial;
        trial.seed = m_seed;
        trial.state = database::SessionState::running;
        trial.firstTick = frame.header.index;
        m_trials.push_back(std::move(trial));
    }
    if (!m_trials.empty() && m_trials.back().state == database::SessionState::running)
        m_trials.back().lastTick = frame.header.index;
    if ((events & kStageChanged) && !(events & kCompleted))
        note(frame, t_s, "stage_changed");
    for (const SceneEvent& event : m_sceneEvents)
        if (events & event.bit)
            note(frame, t_s, event.word);
    constexpr std::pair<std::uint32_t, const char*> kGrasps[] = {
        {kGrasped, "grasped"}, {kReleased, "released"}, {kSlipped, "slipped"}, {kDamaged, "damaged"}};
    for (const auto& [bit, word] : kGrasps)
        if (events & bit)
            note(frame, t_s, word);
    if (!(events & kTrialEnds) || m_trials.empty())
        return;
    const bool byTrace = isMarkOfTraceEnd(frame);
    note(frame, t_s, endWordOf(events, byTrace));
    m_trials.back().marked = (events & kCompleted) != 0 || ((events & kMarked) != 0 && !byTrace);
    m_trials.back().timedOut = (events & kTimedOut) != 0;
    m_trials.back().state = database::SessionState::completed;
}

void EventExtractor::addGuards(const core::HapticFrame& frame, double t_s) {
    const std::uint32_t begun = frame.header.guards & ~m_guards;
    for (const MarkedGuard& guard : kMarkedGuards) {
        if (begun & guard.bit)
            note(frame, t_s, guard.word);
    }
    m_guards = frame.header.guards;
}

void EventExtractor::addYields(const core::HapticFrame& frame, double t_s) {
    for (int i = 0; i < m_tools; ++i) {
        const auto tool = static_cast<std::size_t>(i);
        const YieldLoad load = m_loads.at(i, frame.tool[tool]);
        if (core::contactOfStatus(frame.tool[tool].status) & core::contact_bits::kYielded) {
            note(frame, t_s, "tissue_yielded", i);
            const long long torque_mNm = std::llround(1e3 * load.torque_Nm);
            const auto place = yieldPlaceOf(m_positions, i, frame.tool[tool]);
            m_events.back().detailJson =
                "{\"trial\":" + std::to_string(frame.header.trial) +
                ",\"force_mN\":" + std::to_string(std::llround(1e3 * load.force_N)) +
                (torque_mNm > 0 ? ",\"torque_mN_m\":" + std::to_string(torque_mNm) : std::string()) +
                (place ? placeJson(*place) : std::string()) + "}";
        }
    }
}

void EventExtractor::addOverForce(const core::HapticFrame& frame, double t_s) {
    if (frame.header.paused)
        return;
    for (int i = 0; i < m_tools; ++i) {
        const auto tool = static_cast<std::size_t>(i);
        const core::Array6& f = frame.tool[tool].tissue;
        const bool over = std::hypot(f[0], f[1], f[2]) > m_forceLimit_N;
        if (over && !m_over[tool])
            note(frame, t_s, "force_over_limit", i);
        m_over[tool] = over;
    }
}

} // namespace chiron::session
