// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "modules/exercises/sphere_apex/simulation/hemisphere_contact.h"
#include "modules/exercises/sphere_apex/simulation/sphere_apex_parameters.h"
#include "modules/exercises/sphere_apex/simulation/sphere_apex_plan.h"
#include "modules/exercises/sphere_apex/simulation/touched_dome.h"
#include "simulation/geometry/mesh/mesh_contact.h"
#include "simulation/objects/contact_yield.h"
#include "simulation/scene.h"

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace chiron::simulation {

/// Indices into `SceneOutput::quantities` (sphere apex, only with an organ): PredictionError, m.
namespace apex_quantity {
inline constexpr std::size_t kPredictionError = 0;
inline constexpr std::size_t kHeldError = 1;
} // namespace apex_quantity

/// The running sphere-apex exercise (models.md §2.3). The task moves through these states, one trial after
/// the other:
///
///   idle --started--> ready --forceReady--> running --mark or limit--> between --betweenTrials_s--> ready
///   ... finished
///
/// - In idle, between and finished there is no object, nothing is touched, and force is zero.
/// - kSceneChanged comes with the first tick of `ready`, when the next object appears and the supervisor arms
///   again. The forceReady of that tick still belongs to the previous tick, so `ready` lasts at least one
///   tick more.
/// - kTrialStarted comes with the first running tick; kMarked or kTimedOut comes with the last one, which
///   still has the object. The frames from the one to the other are the trial, and the tool's position in the
///   last frame is the answer. kFinished comes with the first tick of `finished`, the one after the end of
///   the last trial; there is no `between` after the last trial.
/// - A mark is a rising edge of tool 0's mark button, or the mark command, while running and not paused. A
///   button that has been held since before the trial or since a pause is not a mark. In the tick of the time
///   limit, a mark takes precedence over the time-out.
/// - The clocks (limit, between) count ticks of 1 ms and stand still while paused; contact still produces
///   forces (the supervisor ramps them). Waiting in `ready` costs no time.
/// - All tools touch the same object, each with its own bristle.
/// - On a level with `mesh` or `organ` (ApexSurface) the object is a TouchedDome; the task is the same. The
///   organ's slow model is asked while the object is there, and kSlowApplied comes in the ticks in which one
///   of its answers takes effect. storedEnergy_J is then the energy of the local model alone, which can come
///   back at once; the energy that the organ itself stores comes back only through the local model.
/// - Tissue gives way under a tool (parameters.yield) at its yield force, or where the tool is deeper than
///   kDeepestShare of the radius: there the nearest point of the surface moves faster than the tool, and the
///   force would turn around the ball's centre. After that nothing is felt until the tool is out again.
///
/// Deterministic; all trials are planned at construction. Not copyable: a session owns one.
/// Thread: haptic for respond(); any for construction.
class SphereApexScene final : public IScene {
public:
    SphereApexScene(const SphereApexParameters& parameters, std::uint64_t seed);
    ~SphereApexScene() override;
    SphereApexScene(const SphereApexScene&) = delete;
    SphereApexScene& operator=(const SphereApexScene&) = delete;

    void respond(const realtime::HapticTick& now, const SceneInput& in, SceneOutput& out) noexcept override;
    ISlowModel* slowModel() noexcept override { return m_dome ? m_dome->organ() : nullptr; }
    bool conservative() const noexcept override {
        return m_parameters.surface == ApexSurface::exact || MeshContact::kConservative;
    }

    /// The truth, for scoring.
    const std::vector<SphereApexTrial>& trials() const noexcept { return m_trials; }

private:
    void advance(std::uint64_t tick, const SceneInput& in, SceneOutput& out) noexcept;
    void enterReady(std::uint64_t tick, SceneOutput& out) noexcept;
    void runTrial(bool pressed, SceneOutput& out) noexcept;
    void leaveTrial(SceneOutput& out) noexcept;
    bool markPressed(const SceneInput& in) noexcept;
    bool objectPresent() const noexcept;
    ContactResponse touchWith(std::size_t tool, const core::ToolState& state,
                              double mostDamping_Ns_per_m) noexcept;
    /// Bounds how fast the force changes with position, N/m.
    double steepest(const ContactResponse& response, const core::Vec3& p_WT) const noexcept;
    ContactResponse touchExact(std::size_t tool, const core::ToolState& state,
                               double mostDamping_Ns_per_m) noexcept;
    void touch(const SceneInput& in, SceneOutput& out) noexcept;
    void fillCues(const SceneInput& in, SceneOutput& out) const noexcept;

    SphereApexParameters m_parameters;
    std::vector<SphereApexTrial> m_trials;
    std::uint64_t m_limitTicks;
    std::uint64_t m_betweenTicks;
    bool m_showsObject;

    core::TrialPhase m_phase = core::TrialPhase::idle;
    std::size_t m_trial = 0;
    std::uint64_t m_clock = 0;           ///< ticks spent in the present phase, without pauses
    bool m_trialOver = false;            ///< the previous tick ended the trial
    bool m_buttonWasDown = true;         ///< so that a button held at the first tick is not an edge
    HemisphereContact m_contact;         ///< for an exact surface
    std::unique_ptr<TouchedDome> m_dome; ///< for the other surfaces; null: exact, or it could not be made
    std::array<BristleFriction, core::kMaxTools> m_bristles{};
    std::array<ContactYield, core::kMaxTools> m_yields{}; ///< for an exact surface
    std::array<bool, core::kMaxTools> m_touching{};
};

} // namespace chiron::simulation
