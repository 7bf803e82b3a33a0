// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/haptic_frame.h"
#include "simulation/yield.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace chiron::session {

/// What a mark on the scrubber tells of.
enum class PlaybackMarkKind : std::uint8_t {
    trialStarted,
    marked,      ///< the person's answer
    timedOut,    ///< penalty: the limit was reached without an answer
    traceEnded,  ///< a replayed trace ended without a mark
    contact,     ///< tool and object touched, from t_s to end_s
    overLimit,   ///< penalty: tissue force over the level's limit, from t_s to end_s; value: largest force, N
    paused,      ///< from t_s to end_s
    forceStopped,
    rearmed,
    guard, ///< the supervisor stepped in; `detail` says why
    fault, ///< latched; `detail` says why
    ended, ///< the person ended the session
    completed,    ///< the procedure was done to its end
    stageChanged, ///< of the procedure; `detail` says which stage began
    landmarkSeen, ///< value: how many until then
    trauma,       ///< penalty: force across the canal over the level's limit, from t_s to end_s; value: the largest, N
    reversal,     ///< penalty: the tip went back during the insertion, from t_s to end_s; value: how far, m
    offCentre,    ///< penalty: farther from the centre-line than the level's gate allows, from t_s to end_s; value: the largest, m
    overTorque,   ///< penalty: torque over the level's gate, from t_s to end_s; value: the largest, N·m
    grasped,      ///< an instrument took hold
    released,     ///< it let go, on purpose
    slipped,      ///< penalty: what was held slipped out, or was dropped
    damaged,      ///< penalty: over-stretched or over-squeezed
    found,        ///< palpation: a finding was reported; value: its number, from 1
    takenBack,    ///< palpation: a finding was taken back; value: its number, from 1
    yielded,      ///< penalty: tissue gave way; value: the force at which it did, N, or with detail kByTorque the torque, N·m
    failed,       ///< penalty: the trial could not be done any more (torn)
    limited,      ///< less was commanded than the tissue answered, from t_s to end_s; value: the largest tissue force, N
    missed,       ///< penalty: an answer was given beside what was asked for
    falseAlarm,   ///< penalty; palpation: a finding where nothing was; value: its number, from 1
    lumpMissed,   ///< penalty; palpation: at the trial's end, a lump that no finding was near enough to
};

/// `detail` of a time-out of a procedure, which nobody marks.
inline constexpr const char* kProcedure = "procedure";

/// `detail` of tissue that gave way to a torque.
inline constexpr const char* kByTorque = "torque";

/// One thing that happened, or went on for a while. The words for it are the screen's.
struct PlaybackMark {
    double t_s = 0.0;                ///< device time since the first frame
    double end_s = 0.0;              ///< equal to t_s for a moment
    std::uint64_t tick = 0;
    PlaybackMarkKind kind = PlaybackMarkKind::marked;
    int trial = 0;                   ///< from 0
    int tool = 0;
    bool critical = false;           ///< among what the session's metric critical_errors counts
    std::optional<double> value;     ///< overLimit: largest tissue force, N; others as the kind says
    /// guard, fault: stored token of the event ("watchdog", "over_velocity", ...); stageChanged: the stage's token
    /// ("inspection"), empty where it is not known; timedOut: kProcedure where no mark was asked for.
    std::string detail;
};

/// Whether it costs: over the limit, timed out, a fault, trauma, a reversal, off centre, torque, slipped, damaged, yielded, failed,
/// missed, a false alarm, a lump missed.
bool isPenalty(PlaybackMarkKind kind) noexcept;

/// Stored frames -> marks, in the order of time, by the rules of EventExtractor, so that playback tells what the database
/// lists; spans (contact, over the limit, pause) get their end as well. Contact is more than 0.02 N of tissue force, as
/// for every metric; a touch lost for less than 0.2 s goes on. Frames come in order, chunk by chunk.
class MarkExtractor {
public:
    /// `felt`: the device rendered force, so that less than the tissue's can have been felt. `yield`: the level's, which tells whether tissue
    /// gave way to force or to torque.
    MarkExtractor(double forceLimit_N, int tools, bool felt = false, const simulation::YieldLaw& yield = {})
        : m_forceLimit_N(forceLimit_N), m_tools(tools), m_felt(felt), m_yield(yield) {}

    /// `t_s`: the frame's device time since the first frame.
    void add(const core::HapticFrame& frame, double t_s);
    /// Closes what is still going on at `end_s` and hands the marks over, by time.
    std::vector<PlaybackMark> take(double end_s);

private:
    /// A span that goes on, or the last one that did.
    struct Span {
        std::optional<std::size_t> mark; ///< index in m_marks
        bool open = false;
    };
    PlaybackMark& note(const core::HapticFrame& frame, double t_s, PlaybackMarkKind kind, int tool = 0);
    void follow(Span& span, bool on, const core::HapticFrame& frame, double t_s, PlaybackMarkKind kind, int tool = 0,
                double bridge_s = -1.0);
    void addCommands(const core::HapticFrame& frame, double t_s);
    void addTrialEvents(const core::HapticFrame& frame, double t_s);
    void addGrasps(const core::HapticFrame& frame, double t_s);
    void addForces(const core::HapticFrame& frame, double t_s);
    void addGuards(const core::HapticFrame& frame, double t_s);
    void addStandstill(const core::HapticFrame& frame, double t_s);
    void noteYield(const core::HapticFrame& frame, double t_s, int tool);
    void addLimited(const core::HapticFrame& frame, double t_s, int tool);

    /// Why the clock stands still.
    enum class Standstill : std::uint8_t { none, pause, stop, fault };
    double m_forceLimit_N;
    int m_tools;
    bool m_felt;
    simulation::YieldLaw m_yield;
    Standstill m_standstill = Standstill::none;
    std::optional<std::size_t> m_stop; ///< the mark of the stop that goes on
    std::uint32_t m_guards = 0;
    core::ForceState m_force = core::ForceState::off;
    std::array<double, core::kMaxTools> m_before_N{}; ///< tissue force of the tick before
    std::array<double, core::kMaxTools> m_before_Nm{}; ///< likewise the torque
    Span m_paused;
    std::array<Span, core::kMaxTools> m_over{};
    std::array<Span, core::kMaxTools> m_limited{};
    std::array<Span, core::kMaxTools> m_contact{};
    std::vector<PlaybackMark> m_marks;
};

} // namespace chiron::session
