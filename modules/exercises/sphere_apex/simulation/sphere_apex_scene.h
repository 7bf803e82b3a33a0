// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "modules/exercises/sphere_apex/simulation/hemisphere_contact.h"
#include "modules/exercises/sphere_apex/simulation/sphere_apex_parameters.h"
#include "modules/exercises/sphere_apex/simulation/sphere_apex_plan.h"
#include "modules/exercises/sphere_apex/simulation/touched_dome.h"
#include "simulation/objects/contact_yield.h"
#include "simulation/scene.h"

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace chiron::simulation {

/// Where each of `SceneOutput::quantities` stands (sphere apex, on an organ alone): PredictionError, m.
namespace apex_quantity {
inline constexpr std::size_t kPredictionError = 0;
inline constexpr std::size_t kHeldError = 1;
} // namespace apex_quantity

/// The sphere-apex exercise running (models.md §2.3). Task state, one trial after the other:
///
///   idle --started--> ready --forceReady--> running --mark or limit--> between --betweenTrials_s--> ready
///   ... finished
///
/// - idle, between and finished: there is no object, nothing is touched, force is zero.
/// - kSceneChanged comes with the first tick of `ready`, when the next object appears; the supervisor arms
/// again. The
///   forceReady of that tick is of the tick before, so `ready` lasts at least one tick more.
/// - kTrialStarted comes with the first running tick; kMarked or kTimedOut with the last one, which still has
/// the object:
///   frames from the one to the other are the trial, and the tool's place in the last is the answer.
///   kFinished comes with the first tick of `finished`, the one after the last trial's end; there is no
///   `between` after the last trial.
/// - A mark is a rising edge of tool 0's mark button, or the mark command, while running and not paused. A
/// button held
///   from before the trial or from a pause is no mark. At the limit's tick a mark counts before the time-out.
/// - The clocks (limit, between) count ticks of 1 ms and stand still while paused; contact still answers (the
/// supervisor
///   ramps). Waiting in `ready` costs no time.
/// - All tools touch the same object, each with its own bristle.
/// - On a level `mesh` or `organ` (ApexSurface) the object is a TouchedDome; the task is the same. The organ's slow model is
///   asked while the object is there, and kSlowApplied comes in the ticks in which an answer of it takes effect.
///   storedEnergy_J is then that of the local model alone: what can come back at once; what the organ itself holds comes
///   back only through it.
///
/// - Tissue gives way under a tool (parameters.yield) at its yield force, or where the tool is deeper than kDeepestShare of the radius:
///   there the nearest place of the surface runs faster than the tool and the force would turn round the ball's middle. Nothing is
///   felt then until the tool is out again.
///
/// Deterministic; all trials are planned at construction. Thread: respond() haptic; construction anywhere.
/// Not copied: a session owns one.
class SphereApexScene final : public IScene {
public:
    SphereApexScene(const SphereApexParameters& parameters, std::uint64_t seed);
    ~SphereApexScene() override;
    SphereApexScene(const SphereApexScene&) = delete;
    SphereApexScene& operator=(const SphereApexScene&) = delete;

    void respond(const realtime::HapticTick& now, const SceneInput& in, SceneOutput& out) noexcept override;
    ISlowModel* slowModel() noexcept override { return m_dome ? m_dome->organ() : nullptr; }

    const std::vector<SphereApexTrial>& trials() const noexcept {
        return m_trials;
    } ///< the truth, for scoring

private:
    void advance(std::uint64_t tick, const SceneInput& in, SceneOutput& out) noexcept;
    void enterReady(std::uint64_t tick, SceneOutput& out) noexcept;
    void runTrial(bool pressed, SceneOutput& out) noexcept;
    void leaveTrial(SceneOutput& out) noexcept;
    bool markPressed(const SceneInput& in) noexcept;
    bool objectPresent() const noexcept;
    ContactResponse touchWith(std::size_t tool, const core::ToolState& state, double mostDamping_Ns_per_m) noexcept;
    double steepest(const ContactResponse& response, const core::Vec3& p_WT) const noexcept; ///< N/m
    ContactResponse touchExact(std::size_t tool, const core::ToolState& state, double mostDamping_Ns_per_m) noexcept;
    void touch(const SceneInput& in, SceneOutput& out) noexcept;
    void fillCues(const SceneInput& in, SceneOutput& out) const noexcept;

    SphereApexParameters m_parameters;
    std::vector<SphereApexTrial> m_trials;
    std::uint64_t m_limitTicks;
    std::uint64_t m_betweenTicks;
    bool m_showsObject;

    core::TrialPhase m_phase = core::TrialPhase::idle;
    std::size_t m_trial = 0;
    std::uint64_t m_clock = 0;   ///< ticks spent in the present phase, pauses left out
    bool m_trialOver = false;    ///< the tick before ended the trial
    bool m_buttonWasDown = true; ///< so that a button held at the first tick is no edge
    HemisphereContact m_contact;         ///< of an exact surface
    std::unique_ptr<TouchedDome> m_dome; ///< of the others; null: exact, or it could not be made
    std::array<BristleFriction, core::kMaxTools> m_bristles{};
    std::array<ContactYield, core::kMaxTools> m_yields{}; ///< of an exact surface
    std::array<bool, core::kMaxTools> m_touching{};
};

} // namespace chiron::simulation
