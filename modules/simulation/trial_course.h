// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session_state.h"
#include "simulation/scene.h"

#include <cstddef>
#include <cstdint>
#include <limits>

namespace chiron::simulation {

/// The course of a session's trials, which the scenes of all exercises share:
///
///   idle --next--> ready --forceReady--> running --end()--> between --interval, next--> ready ... finished
///
/// - In `ready` and `running` the trial's objects are there (present()). In idle, between and finished there
///   are none.
/// - kSceneChanged comes with the first tick of `ready`, when the next objects appear and the supervisor arms
///   again. The forceReady of that tick still belongs to the previous tick, so `ready` lasts at least one
///   tick more. Waiting in `ready` costs no time.
/// - kTrialStarted comes with the first running tick, and the event of end() with the last one, which still
///   has the objects: the frames from the one to the other are the trial. The state changes with the tick
///   after that. kFinished comes with the first tick of `finished`; there is no `between` after the last
///   trial.
/// - The clocks (of the trial, of the interval) count ticks of 1 ms and stand still while paused.
///
/// A scene calls advance() once per tick, sets its objects up when it `prepares`, follows its task while it
/// `runs`, and ends the trial with end() in the same tick.
/// Thread: haptic for everything but construction; allocates nothing.
class TrialCourse {
public:
    static constexpr std::uint64_t kNoLimit = std::numeric_limits<std::uint64_t>::max();
    /// For a session whose trials are not planned: it ends when Signals::stop is set.
    static constexpr std::size_t kUnplanned = std::numeric_limits<std::size_t>::max();

    /// What decides in a tick whether the course goes on.
    struct Signals {
        bool paused = false;
        bool forceReady = false;
        bool next = false; ///< the next trial may begin
        bool stop = false; ///< no further trial is wanted; a running one ends by end() alone
    };
    /// What a tick brings.
    enum class Turn : std::uint8_t {
        waits,    ///< nothing
        prepares, ///< the first tick of `ready`: trial() is the one to set up
        runs,     ///< a tick of the running trial, also its first
        leaves,   ///< the first tick without the trial
    };

    TrialCourse(std::size_t trials, std::uint64_t limit_ticks, std::uint64_t between_ticks) noexcept
        : m_trials(trials), m_limitTicks(limit_ticks), m_betweenTicks(between_ticks) {}

    Turn advance(const Signals& now, SceneOutput& out) noexcept;
    /// The same for planned trials: the first begins with the start command, each other one after the
    /// interval.
    Turn advance(const SceneInput& in, SceneOutput& out) noexcept;
    /// Ends the running trial with this tick and adds the event that says how. Precondition: the tick `runs`.
    void end(std::uint32_t event, SceneOutput& out) noexcept;
    /// Writes trial, phase and state of the force into the output and its cues.
    void write(const SceneInput& in, SceneOutput& out) const noexcept;

    core::TrialPhase phase() const noexcept { return m_phase; }
    std::size_t trial() const noexcept { return m_trial; } ///< from 0
    bool present() const noexcept {
        return m_phase == core::TrialPhase::ready || m_phase == core::TrialPhase::running;
    }
    /// Ticks spent in the present phase, without pauses: in `ready` 0; while running, between and finished
    /// with the first tick counted.
    std::uint64_t clock() const noexcept { return m_clock; }
    std::uint64_t limit_ticks() const noexcept { return m_limitTicks; } ///< of a running trial
    bool timeIsUp() const noexcept { return m_clock >= m_limitTicks; }
    double timeLeft_s() const noexcept; ///< until then, ≥ 0

private:
    Turn prepare(SceneOutput& out) noexcept;
    Turn leave(bool stop, SceneOutput& out) noexcept;
    void finish(SceneOutput& out) noexcept;

    std::size_t m_trials;
    std::uint64_t m_limitTicks;
    std::uint64_t m_betweenTicks;
    core::TrialPhase m_phase = core::TrialPhase::idle;
    std::size_t m_trial = 0;
    std::uint64_t m_clock = 0;
    bool m_over = false; ///< the previous tick ended the trial
};

} // namespace chiron::simulation
