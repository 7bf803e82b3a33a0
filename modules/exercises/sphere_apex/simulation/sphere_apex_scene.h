// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "modules/exercises/sphere_apex/simulation/hemisphere_contact.h"
#include "modules/exercises/sphere_apex/simulation/sphere_apex_parameters.h"
#include "modules/exercises/sphere_apex/simulation/sphere_apex_plan.h"
#include "modules/exercises/sphere_apex/simulation/touched_dome.h"
#include "simulation/geometry/mesh/mesh_contact.h"
#include "simulation/objects/contact_yield.h"
#include "simulation/scene.h"
#include "simulation/trial_course.h"

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

/// The running sphere-apex exercise (models.md §2.3). The trials follow the course of TrialCourse:
///
/// - In idle, between and finished there is no object, nothing is touched, and force is zero.
/// - kMarked or kTimedOut ends a trial. The tool's position in its last frame is the answer.
/// - A mark is a rising edge of tool 0's mark button, or the mark command, while running and not paused. A
///   button that has been held since before the trial or since a pause is not a mark. In the tick of the time
///   limit, a mark takes precedence over the time-out.
/// - While paused, contact still produces forces (the supervisor ramps them).
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
    void prepare(std::uint64_t tick) noexcept;
    bool markPressed(const SceneInput& in) noexcept;
    ContactResponse touchWith(std::size_t tool, const core::ToolState& state,
                              double mostDamping_Ns_per_m) noexcept;
    /// Bounds how fast the force changes with position, N/m.
    double steepest(const ContactResponse& response, const core::Vec3& p_WT) const noexcept;
    ContactResponse touchExact(std::size_t tool, const core::ToolState& state,
                               double mostDamping_Ns_per_m) noexcept;
    void touch(const SceneInput& in, SceneOutput& out) noexcept;
    void fillCues(SceneOutput& out) const noexcept;

    SphereApexParameters m_parameters;
    std::vector<SphereApexTrial> m_trials;
    TrialCourse m_course;
    bool m_showsObject;

    bool m_buttonWasDown = true;         ///< so that a button held at the first tick is not an edge
    HemisphereContact m_contact;         ///< for an exact surface
    std::unique_ptr<TouchedDome> m_dome; ///< for the other surfaces; null: exact, or it could not be made
    std::array<BristleFriction, core::kMaxTools> m_bristles{};
    std::array<ContactYield, core::kMaxTools> m_yields{}; ///< for an exact surface
    std::array<bool, core::kMaxTools> m_touching{};
};

} // namespace chiron::simulation
