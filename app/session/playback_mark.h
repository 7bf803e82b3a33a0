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
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace chiron::session {

/// What a kind of mark tells, which decides its colour.
enum class MarkTone : std::uint8_t {
    event,   ///< what happened, neither good nor bad
    success, ///< an answer, or something that was reached
    safety,  ///< the force supervisor acted
    penalty, ///< counts against the person
};

/// The kind of event that a mark on the timeline represents: one constant for each. mark_kinds below has
/// those that every recording can have; those of one exercise stand in its folder, in the same namespace.
/// Their words are rows as well (session_report::MarkWords). Two kinds are the same if their ids are.
struct PlaybackMarkKind {
    std::string_view id;   ///< snake_case, unique among all kinds; static storage
    std::string_view icon; ///< name of its icon in the theme (Breeze)
    MarkTone tone = MarkTone::event;
    bool flag = false; ///< a flag on the time bar: an answer, or something that was completed

    friend constexpr bool operator==(const PlaybackMarkKind& a, const PlaybackMarkKind& b) noexcept {
        return a.id == b.id;
    }
};

namespace mark_kinds {
inline constexpr PlaybackMarkKind kTrialStarted{"trial_started", "go-next"};
inline constexpr PlaybackMarkKind kMarked{"marked", "flag", MarkTone::success, true}; ///< the person's answer
/// The limit was reached without an answer.
inline constexpr PlaybackMarkKind kTimedOut{"timed_out", "chronometer", MarkTone::penalty};
/// A replayed trace ended without a mark.
inline constexpr PlaybackMarkKind kTraceEnded{"trace_ended", "media-playback-stop"};
/// Tool and object touched, from t_s to end_s.
inline constexpr PlaybackMarkKind kContact{"contact", "draw-circle"};
/// Tissue force over the level's limit, from t_s to end_s; value: largest force, N.
inline constexpr PlaybackMarkKind kOverLimit{"over_limit", "dialog-warning", MarkTone::penalty};
inline constexpr PlaybackMarkKind kPaused{"paused", "media-playback-pause"}; ///< from t_s to end_s
inline constexpr PlaybackMarkKind kForceStopped{"force_stopped", "process-stop"};
inline constexpr PlaybackMarkKind kRearmed{"rearmed", "media-playback-start"};
/// The supervisor intervened; `detail` has the reason.
inline constexpr PlaybackMarkKind kGuard{"guard", "security-medium", MarkTone::safety};
/// Latched; `detail` has the reason.
inline constexpr PlaybackMarkKind kFault{"fault", "dialog-error", MarkTone::penalty};
/// The person ended the session.
inline constexpr PlaybackMarkKind kEnded{"ended", "media-playback-stop"};
/// The procedure was completed.
inline constexpr PlaybackMarkKind kCompleted{"completed", "flag", MarkTone::success, true};
/// Of the procedure; `detail` names the new stage.
inline constexpr PlaybackMarkKind kStageChanged{"stage_changed", "go-next"};
inline constexpr PlaybackMarkKind kGrasped{"grasped", "object-locked"}; ///< an instrument gripped an object
inline constexpr PlaybackMarkKind kReleased{"released", "object-unlocked"}; ///< it let go intentionally
/// A held object slipped out or was dropped.
inline constexpr PlaybackMarkKind kSlipped{"slipped", "go-down", MarkTone::penalty};
/// Over-stretched or over-squeezed.
inline constexpr PlaybackMarkKind kDamaged{"damaged", "dialog-warning", MarkTone::penalty};
/// Tissue gave way; value: the force at which it did, N, or with detail kByTorque the torque, N·m.
inline constexpr PlaybackMarkKind kYielded{"yielded", "dialog-error", MarkTone::penalty};
/// The trial could not be continued (torn).
inline constexpr PlaybackMarkKind kFailed{"failed", "dialog-error", MarkTone::penalty};
/// The commanded force was less than the tissue's, from t_s to end_s; value: the largest tissue force, N.
inline constexpr PlaybackMarkKind kLimited{"limited", "security-medium", MarkTone::safety};
} // namespace mark_kinds

/// `detail` of tissue that gave way to a torque.
inline constexpr const char* kByTorque = "torque";

/// An event at a moment or over a span of time. The screen supplies the words for it.
struct PlaybackMark {
    double t_s = 0.0;   ///< device time since the first frame
    double end_s = 0.0; ///< equal to t_s for a moment
    std::uint64_t tick = 0;
    PlaybackMarkKind kind = mark_kinds::kMarked;
    int trial = 0; ///< from 0
    int tool = 0;
    bool critical = false;       ///< counted by the session's metric critical_errors
    std::optional<double> value; ///< overLimit: largest tissue force, N; for others see PlaybackMarkKind
    /// yielded: where, m, W; no value if the packet was refused. Playback crosses the place.
    std::optional<core::Vec3> p_W;
    /// guard, fault: stored token of the event ("watchdog", "over_velocity", ...); stageChanged: the stage's
    /// token ("inspection"), empty if unknown.
    std::string detail;
};

/// True if it counts against the person.
constexpr bool isPenalty(const PlaybackMarkKind& kind) noexcept {
    return kind.tone == MarkTone::penalty;
}

/// An event that the scene of an exercise has of its own, beside core::event_bits (TickHeader::events).
/// Static data.
struct SceneEvent {
    std::uint32_t bit = 0;
    const char* word = ""; ///< stored in the database's list of events; never changes
    PlaybackMarkKind mark;
};

/// Converts stored frames to marks in the order of time, by the rules of EventExtractor, so that playback
/// shows the events that the database lists; spans (contact, over the limit, pause) also get their end.
/// Contact means more than 0.02 N of tissue force, as for every metric; an interruption of less than 0.2 s
/// does not end a contact. Frames must be added in order, chunk by chunk.
class MarkExtractor {
public:
    /// `felt`: the device rendered force, so that the felt force can be smaller than the tissue's. `yield`:
    /// the level's law, which decides whether tissue gave way to force or to torque. `positions`: of the
    /// session's tools; it must outlive the calls of add(). Null: no mark has a place. `sceneEvents`: those
    /// of the exercise (ExerciseKind::sceneEvents). `countsErrors`: the level has the metric critical_errors,
    /// which no level of a study has.
    MarkExtractor(double forceLimit_N, int tools, bool felt = false, const simulation::YieldLaw& yield = {},
                  const recording::IPositionOf* positions = nullptr,
                  std::span<const SceneEvent> sceneEvents = {}, bool countsErrors = true)
        : m_forceLimit_N(forceLimit_N), m_tools(tools), m_felt(felt), m_countsErrors(countsErrors),
          m_yield(yield), m_positions(positions), m_sceneEvents(sceneEvents) {}

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
    PlaybackMark& note(const core::HapticFrame& frame, double t_s, const PlaybackMarkKind& kind,
                       int tool = 0);
    void follow(Span& span, bool on, const core::HapticFrame& frame, double t_s, const PlaybackMarkKind& kind,
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
    bool m_countsErrors;
    simulation::YieldLaw m_yield;
    const recording::IPositionOf* m_positions;
    std::span<const SceneEvent> m_sceneEvents;
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
