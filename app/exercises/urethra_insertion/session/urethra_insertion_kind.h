// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "session/exercise_kind.h"

namespace chiron::session {

/// The exercise of urethra insertion (models.md §1).
class UrethraInsertionKind final : public ExerciseKind {
public:
    std::string_view id() const noexcept override { return "urethra_insertion"; }
    std::span<const std::string_view> mechanisms() const noexcept override { return kMechanisms; }
    PointerTool pointerTool() const noexcept override { return PointerTool::endoscope; }
    /// On the straight line in front of the entrance.
    std::optional<core::Vec3> toolStart_W(const catalogue::ExerciseLevel& level,
                                          const devices::WorkspaceMapping& place) const override;
    /// Friction sets in as gradually as the first tool's device requires (device_friction.h).
    std::unique_ptr<simulation::IScene> makeScene(const SessionSetup& setup) const override;
    simulation::YieldLaw yieldLaw(const catalogue::ExerciseLevel& level) const override;
    core::Result<ScriptedTrainee> makeOperator(const catalogue::ExerciseLevel& level, const std::string& name,
                                               std::uint64_t seed, const HeldDevices& held) const override;
    std::vector<std::string> operatorNames() const override;
    int trialCount(const catalogue::ExerciseLevel& level) const override;
    double forceLimit_N(const catalogue::ExerciseLevel& level) const override;
    std::vector<LimitedMetric> limitedMetrics(const catalogue::ExerciseLevel& level) const override;
    /// A stricture is stiffer (4 kN/m) than a hand can press without trembling. With this knee and a cap of 4
    /// N, forces up to 3.2 N are rendered unchanged, and a force of 4 N as 3.7 N.
    SessionCaps caps(const catalogue::ExerciseLevel& level) const override;
    std::uint64_t tickLimit(const catalogue::ExerciseLevel& level) const override;
    /// Fills `trial.own` (scoring::InsertionSeries) from tool 0's poses and tissue wrench with the level's
    /// own geometry, so that proximity, alignment and stage follow from stored channels alone. Left empty if
    /// the trace has no orientation.
    void addTruth(const catalogue::ExerciseLevel& level, std::uint64_t seed,
                  scoring::TrialTrace& trial) const override;
    std::unique_ptr<TrialSurfaces> makeSurfaces(const catalogue::ExerciseLevel& level,
                                                std::uint64_t seed) const override;
    std::span<const SceneEvent> sceneEvents() const noexcept override; ///< a landmark was seen
    bool marksFromTrace() const noexcept override { return true; }
    core::Result<void> addMarks(const SessionSetup& setup, const scoring::SessionTrace* trace,
                                PlaybackTrack& track) const override;
    /// completed, length_m, bend_m, goal_m, lateral_limit_N, landmarks_seen_s: null for landmarks that were
    /// not seen.
    void storeTruth(const scoring::TrialTrace& trial, QJsonObject& truth) const override;
    Demonstration demonstration() const override;
    std::vector<MomentRule> momentRules() const override;
    /// From the entrance, along the canal.
    std::optional<double> depthAt_m(const PlaybackTrack& track, double t_s) const override;

private:
    static constexpr std::array<std::string_view, 1> kMechanisms{"five_bar_spherical"};
};

} // namespace chiron::session
