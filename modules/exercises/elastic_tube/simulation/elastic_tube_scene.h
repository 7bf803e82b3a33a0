// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "modules/exercises/elastic_tube/simulation/elastic_tube_parameters.h"
#include "modules/exercises/elastic_tube/simulation/elastic_tube_plan.h"
#include "modules/exercises/elastic_tube/simulation/tube_chain.h"
#include "modules/exercises/elastic_tube/simulation/tube_grips.h"
#include "modules/exercises/elastic_tube/simulation/tube_task.h"
#include "simulation/scene.h"
#include "simulation/trial_course.h"

#include <array>
#include <cstdint>
#include <vector>

namespace chiron::simulation {

/// The quantities that the scene records, in this order (SceneOutput::quantities).
enum class TubeQuantity : std::uint8_t {
    tension_N,
    stretch_m,
    grip0,
    grip1,
    grip2,
    freeEndX_m,
    freeEndY_m,
    freeEndZ_m,
    step,
    dwell,
    retraction_N,
    foldOpen,
    foldEdgeX_m,
    foldEdgeY_m,
    foldEdgeZ_m,
    count
};

/// The running elastic-tube exercise (P2 "Elastic Tube Model", "Control Algorithm for Multiple Instruments";
/// models.md §2.4). The trials follow the course of TrialCourse:
///
/// - With the first tick of `ready` the next tube appears. Nobody holds it, and jaws have to open first. The
///   tube may be grasped while force is armed; the task (tube_task.h) begins with kTrialStarted.
/// - kCompleted (held to the end), kFailed (torn) or kTimedOut ends a trial; in the tick of the time limit,
///   done and torn take precedence. kGrasped and kReleased come with the jaws,
///   kSlipped with a release that drops the tube (then kReleased comes too), kDamaged with an over-stretch,
///   and kStageChanged with a step of the task.
/// - After a trial the tube's pull fades within 0.3 s, so that no hand is let go with a jerk. A tube that
///   tears gives way within parameters.yield.fall_s, which core::contact_bits of the tools that hold it
///   report. A tube that is let go of slides out of the jaws within 0.1 s.
/// - The checked range (kBeyondChecked outside it) is a tube or fold that is whole, stretched up to the limit
///   of its law, and pulls with no more than the yield force.
/// - During a pause the clocks and the task stand still, and the tube follows the hands (the supervisor ramps
///   the force).
/// - Where the level has a fold of tissue over the tube, the last tool takes hold of its edge and draws it
///   back (tissueFoldShape); the fold is body 1. While its pull is too small, the tube cannot be taken hold
///   of, and no goal is met.
/// - All other tools touch the same body 0. A tool feels the sum of the segments at its place and no torque:
///   the place that it holds keeps its distance from the tip in W (tube_grips.h).
///
/// Deterministic; all trials are planned at construction.
/// Thread: haptic for respond(); any for construction.
class ElasticTubeScene final : public IScene {
public:
    ElasticTubeScene(const ElasticTubeParameters& parameters, std::uint64_t seed);
    ~ElasticTubeScene() override;
    ElasticTubeScene(const ElasticTubeScene&) = delete;
    ElasticTubeScene& operator=(const ElasticTubeScene&) = delete;

    void respond(const realtime::HapticTick& now, const SceneInput& in, SceneOutput& out) noexcept override;

    /// The truth, for scoring.
    const std::vector<ElasticTubeTrial>& trials() const noexcept { return m_trials; }

private:
    void prepare() noexcept;
    void runTask(SceneOutput& out) noexcept;
    void pull(const SceneInput& in, SceneOutput& out) noexcept;
    void feel(const core::ToolStates& tools, SceneOutput& out) noexcept;
    double tornShare() const noexcept;
    std::uint8_t contactOf(bool fold, bool beyondChecked) const noexcept;
    core::Vec3 slipping(std::size_t tool, const core::Vec3& pull, bool holds) noexcept;
    bool tubePresent() const noexcept;
    double fade() const noexcept;   ///< share of the tube's pull that is left
    double ending() const noexcept; ///< share of any pull that is left after a trial
    void openFold() noexcept;
    bool retracts(std::size_t tool) const noexcept {
        return m_parameters.hasFold() && static_cast<int>(tool) == m_parameters.retractor();
    }
    void fillFold(core::LaparoscopyCues& cues) const noexcept;
    TubeTaskSample sample() const noexcept;
    void fillQuantities(SceneOutput& out) const noexcept;
    void fillCues(core::VisibleCues& cues) const noexcept;
    void fillTube(core::LaparoscopyCues& cues) const noexcept;

    ElasticTubeParameters m_parameters;
    std::vector<ElasticTubeTrial> m_trials;
    TrialCourse m_course;
    std::uint64_t m_holdTicks;
    bool m_showsObject;
    bool m_showsBars;

    TubeChain m_tube;
    TubeGrips m_grips;
    TubeChain m_fold; ///< lies over the tube, if there is one
    TubeGrips m_foldGrips;
    TubeAnswer m_foldAnswer;
    bool m_foldOpen = false;
    TubeTaskTracker m_task;
    TubeAnswer m_answer;           ///< of this tick, without fading
    std::uint64_t m_tornTicks = 0; ///< since it tore
    struct Slip {                  ///< the pull that a tube still exerts on the jaws after it was let go of
        core::Vec3 from = core::Vec3::Zero(); ///< N, at the moment of letting go
        std::uint64_t ticks = 0;
        bool held = false;
        double share = 0.0;
    };
    std::array<Slip, core::kMaxTools> m_slips{};
    std::array<bool, core::kMaxTools> m_touching{};
};

} // namespace chiron::simulation
