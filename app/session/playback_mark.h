// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"
#include "core/haptic_frame.h"
#include "recording/position_of.h"
#include "session/yield_load.h"
#include "simulation/yield.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace chiron::session {

/// The type of event that a mark on the timeline represents.
enum class PlaybackMarkKind : std::uint8_t {
    trialStarted,
    marked,     ///< the person's answer
    timedOut,   ///< penalty: the limit was reached without an answer
    traceEnded, ///< a replayed trace ended without a mark
    contact,    ///< tool and object touched, from t_s to end_s
    overLimit,  ///< penalty: tissue force over the level's limit, from t_s to end_s; value: largest force, N
    paused,     ///< from t_s to end_s
    forceStopped,
    rearmed,
    guard,        ///< the supervisor intervened; `detail` has the reason
    fault,        ///< latched; `detail` has the reason
    ended,        ///< the person ended the session
    completed,    ///< the procedure was completed
    stageChanged, ///< of the procedure; `detail` names the new stage
    landmarkSeen, ///< value: number of landmarks seen so far
    /// Penalty: force across the canal over the level's limit, from t_s to end_s; value: the largest force,
    /// N.
    trauma,
    /// Penalty: the tip moved backwards during the insertion, from t_s to end_s; value: the distance, m.
    reversal,
    /// Penalty: farther from the centre-line than the level's gate allows, from t_s to end_s; value: the
    /// largest distance, m.
    offCentre,
    /// Penalty: torque over the level's gate, from t_s to end_s; value: the largest torque, N·m.
    overTorque,
    grasped,   ///< an instrument gripped an object
    released,  ///< an instrument let go intentionally
    slipped,   ///< penalty: a held object slipped out or was dropped
    damaged,   ///< penalty: over-stretched or over-squeezed
    found,     ///< palpation: a finding was reported; value: its number, from 1
    takenBack, ///< palpation: a finding was taken back; value: its number, from 1
    /// Penalty: tissue gave way; value: the force at which it did, N, or with detail kByTorque the torque,
    /// N·m.
    yielded,
    failed, ///< penalty: the trial could not be continued (torn)
    /// The commanded force was less than the tissue's, from t_s to end_s; value: the largest tissue force, N.
    limited,
    missed,     ///< penalty: the answer missed the target
    falseAlarm, ///< penalty; palpation: a finding without a lump; value: its number, from 1
    /// Penalty; palpation: at the trial's end, a lump that no finding was close enough to.
    lumpMissed,
};

/// `detail` of a time-out in a procedure, which has no answer to mark.
inline constexpr const char* kProcedure = "procedure";

/// `detail` of tissue that gave way to a torque.
inline constexpr const char* kByTorque = "torque";

/// An event at a moment or over a span of time. The screen supplies the words for it.
struct PlaybackMark {
    double t_s = 0.0;   ///< device time since the first frame
    double end_s = 0.0; ///< equal to t_s for a moment
    std::uint64_t tick = 0;
    PlaybackMarkKind kind = PlaybackMarkKind::marked;
    int trial = 0; ///< from 0
    int tool = 0;
    bool critical = false;         ///< counted by the session's metric critical_errors
    std::optional<double> value;   ///< overLimit: largest tissue force, N; for others see PlaybackMarkKind
    std::optional<core::Vec3> p_W; ///< yielded: where, m, W; no value if the packet was refused
    /// guard, fault: stored token of the event ("watchdog", "over_velocity", ...); stageChanged: the stage's
    /// token ("inspection"), empty if unknown; timedOut: kProcedure if the trial did not ask for a mark.
    std::string detail;
};

/// True for penalties: over the limit, timed out, a fault, trauma, a reversal, off centre, torque, slipped,
/// damaged, yielded, failed, missed, a false alarm, a lump missed.
bool isPenalty(PlaybackMarkKind kind) noexcept;

/// Converts stored frames to marks in the order of time, by the rules of EventExtractor, so that playback
/// shows the events that the database lists; spans (contact, over the limit, pause) also get their end.
/// Contact means more than 0.02 N of tissue force, as for every metric; an interruption of less than 0.2 s
/// does not end a contact. Frames must be added in order, chunk by chunk.
class MarkExtractor {
public:
    /// `felt`: the device rendered force, so that the felt force can be smaller than the tissue's. `yield`:
    /// the level's law, which decides whether tissue gave way to force or to torque. `positions`: of the
    /// session's tools; it must outlive the calls of add(). Null: no mark has a place.
    MarkExtractor(double forceLimit_N, int tools, bool felt = false, const simulation::YieldLaw& yield = {},
                  const recording::IPositionOf* positions = nullptr)
        : m_forceLimit_N(forceLimit_N), m_tools(tools), m_felt(felt), m_yield(yield), m_positions(positions) {
    }

    /// `t_s`: the frame's device time since the first frame.
    void add(const core::HapticFrame& frame, double t_s);
    /// Closes open spans at `end_s` and returns the marks in the order of time.
    std::vector<PlaybackMark> take(double end_s);

private:
    /// An open span, or the last one that was open.
    struct Span {
        std::optional<std::size_t> mark; ///< index in m_marks
        bool open = false;
    };
    PlaybackMark& note(const core::HapticFrame& frame, double t_s, PlaybackMarkKind kind, int tool = 0);
    void follow(Span& span, bool on, const core::HapticFrame& frame, double t_s, PlaybackMarkKind kind,
                int tool = 0, double bridge_s = -1.0);
    void addCommands(const core::HapticFrame& frame, double t_s);
    void addTrialEvents(const core::HapticFrame& frame, double t_s);
    void addGrasps(const core::HapticFrame& frame, double t_s);
    void addForces(const core::HapticFrame& frame, double t_s);
    void addGuards(const core::HapticFrame& frame, double t_s);
    void addStandstill(const core::HapticFrame& frame, double t_s);
    void noteYield(const core::HapticFrame& frame, double t_s, int tool, const YieldLoad& load);
    void addLimited(const core::HapticFrame& frame, double t_s, int tool);

    /// The reason why the trial's clock is stopped.
    enum class Standstill : std::uint8_t { none, pause, stop, fault };
    double m_forceLimit_N;
    int m_tools;
    bool m_felt;
    simulation::YieldLaw m_yield;
    const recording::IPositionOf* m_positions;
    Standstill m_standstill = Standstill::none;
    std::optional<std::size_t> m_stop; ///< the mark of the current stop
    std::uint32_t m_guards = 0;
    core::ForceState m_force = core::ForceState::off;
    YieldLoads m_loads;
    Span m_paused;
    std::array<Span, core::kMaxTools> m_over{};
    std::array<Span, core::kMaxTools> m_limited{};
    std::array<Span, core::kMaxTools> m_contact{};
    std::vector<PlaybackMark> m_marks;
};

} // namespace chiron::session
