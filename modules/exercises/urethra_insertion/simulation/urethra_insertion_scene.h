// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "modules/exercises/urethra_insertion/simulation/drawn_tip.h"
#include "modules/exercises/urethra_insertion/simulation/lumen_sight.h"
#include "modules/exercises/urethra_insertion/simulation/procedure_tracker.h"
#include "modules/exercises/urethra_insertion/simulation/urethra_forces.h"
#include "modules/exercises/urethra_insertion/simulation/urethra_insertion_parameters.h"
#include "simulation/scene.h"
#include "simulation/trial_course.h"

#include <cstdint>

namespace chiron::simulation {

/// The running urethra insertion (models.md §1; P1). It converts the pose to the anatomy frame, computes
/// forces and torques of the wall, converts them back to W, and keeps the procedure's task state. A session
/// has one trial, which follows the course of TrialCourse:
///
/// - In idle and finished there is no patient, nothing is touched, and the wrench is zero. In `ready` the
///   anatomy already produces forces, so the supervisor arms only while little force is requested; if the
///   endoscope lies inside at the start, the supervisor's ramp brings its force in.
/// - kCompleted or kTimedOut ends the trial. Completion in the tick of the time limit counts as completed.
///   The mark button has no meaning here.
/// - kStageChanged and kLandmarkSeen come from the ProcedureTracker, which advances by 1 ms in every running
///   tick.
/// - The tracker, too, stands still while paused; contact still produces forces (the supervisor ramps them).
/// - Tool 0 is the endoscope; other tools touch nothing.
/// - The shaft enters only through the meatus (MeatusGate): before it and beside the canal there is no force.
/// - The wall gives way at the level's yield force: a false passage. The felt force then falls along
///   TissueYield's curve, and nothing is felt until the tip is out of the patient again. Contact bits record
///   this.
/// - The checked range (kBeyondChecked outside it) is 6 mm off the centre-line with 30° of tilt in each
///   direction in the canal, and the bladder with 2 mm of its wall (test_urethra_forces).
///
/// Deterministic: the seed changes nothing (the anatomy is data). A session owns one.
/// Thread: haptic for respond(); any for construction.
class UrethraInsertionScene final : public IScene {
public:
    explicit UrethraInsertionScene(const UrethraInsertionParameters& parameters);
    ~UrethraInsertionScene() override;
    UrethraInsertionScene(const UrethraInsertionScene&) = delete;
    UrethraInsertionScene& operator=(const UrethraInsertionScene&) = delete;

    void respond(const realtime::HapticTick& now, const SceneInput& in, SceneOutput& out) noexcept override;

    /// Of the last tick, A; for tests and `evaluate`.
    const UrethraResponse& response() const noexcept { return m_response; }
    const ProcedureTracker& procedure() const noexcept { return m_tracker; }

private:
    void sense(const core::ToolStates& tools, double mostDamping_Ns_per_m) noexcept;
    bool beyondChecked() const noexcept;
    void runTrial(SceneOutput& out) noexcept;
    void answer(const core::ToolStates& tools, SceneOutput& out) noexcept;
    void fillCues(const SceneInput& in, SceneOutput& out) noexcept;
    void fillPicture(const core::Quat& q_WT, EndoscopeCues& cues) noexcept;
    void fillLandmark(const core::Quat& q_WT, EndoscopeCues& cues) const noexcept;

    UrethraForces m_forces;
    AnatomyPose m_pose;
    MeatusGate m_gate;
    TissueYield m_yield;
    core::Vec3 m_bladderCentre_A;
    double m_bladderReach_m; ///< radius within which the bladder's law has been checked
    DrawnTip m_drawn;
    LumenSight m_sight;
    ProcedureTracker m_tracker;
    TrialCourse m_course;
    double m_cosHalfView;
    bool m_showsPicture;
    bool m_showsGuidance;

    bool m_sensed = false; ///< tool 0 exists and its pose is finite
    bool m_touching = false;
    EndoscopeMotion m_motion;
    UrethraResponse m_response;
    std::uint64_t m_looks = 0; ///< ticks with a picture; the lumen is searched in every eighth of them
    LumenSight::View m_lumen;
};

} // namespace chiron::simulation
