// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "modules/exercises/object_handling/simulation/handling_progress.h"
#include "modules/exercises/object_handling/simulation/handling_world.h"
#include "modules/exercises/object_handling/simulation/object_handling_plan.h"
#include "simulation/geometry/mesh/mesh_contact.h"
#include "simulation/scene.h"
#include "simulation/trial_course.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace chiron::simulation {

/// Indices into `SceneOutput::quantities` (object handling).
namespace handling_quantity {
inline constexpr std::size_t kStep = 0;    ///< core::LaparoscopyStep
inline constexpr std::size_t kDwell = 1;   ///< 0..1
inline constexpr std::size_t kSqueeze = 2; ///< N
inline constexpr std::size_t kHeld = 3;    ///< object number + 1; 0: none
inline constexpr std::size_t kBodies = 4;  ///< x, y, z of each of three objects, m; zero where there is none
inline constexpr std::size_t kBedDepth = 13; ///< m
/// m, PredictionError::predicted_m; zero without a soft bed.
inline constexpr std::size_t kPredictionError = 14;
inline constexpr std::size_t kHeldError = 15; ///< m, PredictionError::held_m
inline constexpr std::size_t kCount = 16;
} // namespace handling_quantity

/// Running object-handling exercise (P2; models.md §2.2). The trials follow the course of TrialCourse;
/// kCompleted or kTimedOut ends one. A mark has no meaning here. In idle, between and finished there is no
/// object and no bed, and force is zero.
///
/// Tool 0 grasps; other tools feel nothing. While paused the clocks stand still and the jaw stays as it was,
/// so that putting the instrument down for a while drops nothing; contact still produces forces. All of tool
/// 0's energy belongs to body 0. An organ that serves as bed is simulated beside the loop (slowModel()).
///
/// Deterministic; all trials are planned at construction. Not copyable.
/// Thread: haptic for respond(); any for construction.
class ObjectHandlingScene final : public IScene {
public:
    ObjectHandlingScene(const ObjectHandlingParameters& parameters, std::uint64_t seed);
    ~ObjectHandlingScene() override;
    ObjectHandlingScene(const ObjectHandlingScene&) = delete;
    ObjectHandlingScene& operator=(const ObjectHandlingScene&) = delete;

    void respond(const realtime::HapticTick& now, const SceneInput& in, SceneOutput& out) noexcept override;
    ISlowModel* slowModel() noexcept override { return m_softBed ? &m_softBed->organ() : nullptr; }
    bool conservative() const noexcept override {
        return !m_parameters.organBed || MeshContact::kConservative;
    }

    /// The truth, for scoring.
    const std::vector<ObjectHandlingTrial>& trials() const noexcept { return m_trials; }
    const HandlingWorld& world() const noexcept { return m_world; } ///< for tests and tables

private:
    void prepare() noexcept;
    void endTrial(SceneOutput& out) noexcept;
    /// False: the organ could not be made.
    bool hasBed() const noexcept { return m_softBed != nullptr || !m_parameters.organBed; }
    void touch(const SceneInput& in, bool running, SceneOutput& out) noexcept;
    void fillQuantities(double bedDepth_m, SceneOutput& out) const noexcept;
    void fillCues(SceneOutput& out) const noexcept;
    void showObjects(core::LaparoscopyCues& cues) const noexcept;

    ObjectHandlingParameters m_parameters;
    std::vector<ObjectHandlingTrial> m_trials;
    TrialCourse m_course;
    bool m_showsObjects;
    bool m_showsBars;

    bool m_touching = false;
    double m_opening_m = 0.0;           ///< of the jaws, kept while paused
    std::unique_ptr<SoftBed> m_softBed; ///< null: the bed is a plane
    std::uint64_t m_tick = 0;
    HandlingWorld m_world;
    HandlingProgress m_task;
};

} // namespace chiron::simulation
