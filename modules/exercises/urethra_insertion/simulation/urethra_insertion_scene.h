// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "modules/exercises/urethra_insertion/simulation/drawn_tip.h"
#include "modules/exercises/urethra_insertion/simulation/lumen_sight.h"
#include "modules/exercises/urethra_insertion/simulation/procedure_tracker.h"
#include "modules/exercises/urethra_insertion/simulation/urethra_forces.h"
#include "modules/exercises/urethra_insertion/simulation/urethra_insertion_parameters.h"
#include "simulation/scene.h"

#include <cstdint>

namespace chiron::simulation {

/// Urethra insertion running (models.md §1; P1): pose -> anatomy frame -> forces and torques of the wall -> back to W, and the
/// procedure's task state. One trial a session:
///
///   idle --started--> ready --forceReady--> running --procedure completed or limit--> finished
///
/// - idle and finished: there is no patient, nothing is touched, wrench is zero. In `ready` the anatomy answers, so that the
///   supervisor arms only when little is asked for; an endoscope that lies inside at the start is brought in by its ramp.
/// - kSceneChanged comes with the first tick of `ready`; `ready` lasts at least one tick more. kTrialStarted comes with the first
///   running tick, kCompleted or kTimedOut with the last one: frames from the one to the other are the trial. kFinished comes
///   with the tick after. Completed at the limit's tick counts as completed. The mark button means nothing here.
/// - kStageChanged and kLandmarkSeen come from the ProcedureTracker, which is stepped by 1 ms at every running tick.
/// - Clocks and tracker stand still while paused; contact still answers (the supervisor ramps).
/// - Tool 0 is the endoscope; other tools touch nothing.
/// - The shaft enters only through the meatus (MeatusGate): before it and beside the canal there is no force.
/// - The wall gives way at the level's yield force: a false passage. What is felt then falls by TissueYield's curve, and there is
///   nothing to feel until the tip is out of the patient again. Recorded as contact bits.
/// - Checked (kBeyondChecked where not): 6 mm off the centre-line each way with 30° of tilt each way in the canal, and the bladder with
///   2 mm of its wall (test_urethra_forces).
///
/// Deterministic: the seed changes nothing (the anatomy is data). Thread: respond() haptic; construction anywhere. A session owns one.
class UrethraInsertionScene final : public IScene {
public:
    explicit UrethraInsertionScene(const UrethraInsertionParameters& parameters);
    ~UrethraInsertionScene() override;
    UrethraInsertionScene(const UrethraInsertionScene&) = delete;
    UrethraInsertionScene& operator=(const UrethraInsertionScene&) = delete;

    void respond(const realtime::HapticTick& now, const SceneInput& in, SceneOutput& out) noexcept override;

    const UrethraResponse& response() const noexcept { return m_response; } ///< of the last tick, A; for tests and `evaluate`
    const ProcedureTracker& procedure() const noexcept { return m_tracker; }

private:
    void sense(const core::ToolStates& tools, double mostDamping_Ns_per_m) noexcept;
    bool beyondChecked() const noexcept;
    void advance(const SceneInput& in, SceneOutput& out) noexcept;
    void runTrial(SceneOutput& out) noexcept;
    bool patientPresent() const noexcept;
    void answer(const core::ToolStates& tools, SceneOutput& out) noexcept;
    void fillCues(const SceneInput& in, SceneOutput& out) noexcept;
    void fillPicture(const core::Quat& q_WT, EndoscopeCues& cues) noexcept;
    void fillLandmark(const core::Quat& q_WT, EndoscopeCues& cues) const noexcept;

    UrethraForces m_forces;
    AnatomyPose m_pose;
    MeatusGate m_gate;
    TissueYield m_yield;
    core::Vec3 m_bladderCentre_A;
    double m_bladderReach_m; ///< radius in which the bladder's law is checked
    DrawnTip m_drawn;
    LumenSight m_sight;
    ProcedureTracker m_tracker;
    std::uint64_t m_limitTicks;
    double m_cosHalfView;
    bool m_showsPicture;
    bool m_showsGuidance;

    core::TrialPhase m_phase = core::TrialPhase::idle;
    std::uint64_t m_clock = 0; ///< ticks run, pauses left out
    bool m_trialOver = false;  ///< the tick before ended the trial
    bool m_sensed = false;     ///< tool 0 is there and its pose is a number
    bool m_touching = false;
    EndoscopeMotion m_motion;
    UrethraResponse m_response;
    std::uint64_t m_looks = 0; ///< ticks with a picture; the lumen is looked for at every eighth
    LumenSight::View m_lumen;
};

} // namespace chiron::simulation
