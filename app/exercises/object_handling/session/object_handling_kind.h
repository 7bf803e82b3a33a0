// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "session/exercise_kind.h"

namespace chiron::session {

/// Object handling: lift, weigh and place (P2; models.md §2.2).
class ObjectHandlingKind final : public ExerciseKind {
public:
    std::string_view id() const noexcept override { return "object_handling"; }
    PointerTool pointerTool() const noexcept override { return PointerTool::grasper; }
    std::vector<core::QuantityDescription> quantities(const catalogue::ExerciseLevel& level) const override;
    bool recordsEnergy(const catalogue::ExerciseLevel&) const override { return true; }
    std::unique_ptr<simulation::IScene> makeScene(const SessionSetup& setup) const override;
    simulation::YieldLaw yieldLaw(const catalogue::ExerciseLevel& level) const override;
    core::Result<ScriptedTrainee> makeOperator(const catalogue::ExerciseLevel& level, const std::string& name,
                                               std::uint64_t seed, const HeldDevices& held) const override;
    bool operatorsKnowTheirPlace() const noexcept override { return true; }
    std::vector<std::string> operatorNames() const override;
    int trialCount(const catalogue::ExerciseLevel& level) const override;
    double forceLimit_N(const catalogue::ExerciseLevel& level) const override;
    std::vector<LimitedMetric> limitedMetrics(const catalogue::ExerciseLevel& level) const override;
    std::uint64_t tickLimit(const catalogue::ExerciseLevel& level) const override;
    /// Adds scoring::HandlingTruth.
    void addTruth(const catalogue::ExerciseLevel& level, std::uint64_t seed,
                  scoring::TrialTrace& trial) const override;
    /// The object of a trial is its target on the bed; the moving objects are in the recorded quantities.
    std::unique_ptr<TrialSurfaces> makeSurfaces(const catalogue::ExerciseLevel& level,
                                                std::uint64_t seed) const override;
    Demonstration demonstration() const override;
    std::vector<MomentRule> momentRules() const override;
    /// The steps of the task name its changes of stage.
    core::Result<void> addMarks(const SessionSetup& setup, const scoring::SessionTrace* trace,
                                PlaybackTrack& track) const override;
};

} // namespace chiron::session
