// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "session/exercise_kind.h"

namespace chiron::session {

/// The exercise on an elastic tube (P2; models.md §2.4), with one hand or two.
class ElasticTubeKind final : public ExerciseKind {
public:
    std::string_view id() const noexcept override { return "elastic_tube"; }
    LevelTools tools(const catalogue::ExerciseLevel& level) const override;
    /// One instrument enters over the middle; two enter at x = ± instrumentsApart/2, with tool 0, the right
    /// one, on the positive side.
    devices::WorkspaceMapping toolPlace(const catalogue::ExerciseLevel& level, int tool) const override;
    /// In the order of simulation::TubeQuantity.
    std::vector<core::QuantityDescription> quantities(const catalogue::ExerciseLevel& level) const override;
    bool recordsEnergy(const catalogue::ExerciseLevel&) const override { return true; }
    PointerTool pointerTool() const noexcept override { return PointerTool::grasper; }
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
    /// Adds scoring::TubeTruth.
    void addTruth(const catalogue::ExerciseLevel& level, std::uint64_t seed,
                  scoring::TrialTrace& trial) const override;
    /// The base is the object of the trial; the surface point of a tool is its own position.
    std::unique_ptr<TrialSurfaces> makeSurfaces(const catalogue::ExerciseLevel& level,
                                                std::uint64_t seed) const override;
    /// The skilled trainee also does the level that takes two hands (level 4).
    DemoPart demoPart(int level) const override { return {level == 1, level <= 2 || level == 4, level <= 2}; }
    Demonstration demonstration() const override;
    std::vector<MomentRule> momentRules() const override;
    /// The steps of the task name its changes of stage.
    core::Result<void> addMarks(const SessionSetup& setup, const scoring::SessionTrace* trace,
                                PlaybackTrack& track) const override;
};

} // namespace chiron::session
