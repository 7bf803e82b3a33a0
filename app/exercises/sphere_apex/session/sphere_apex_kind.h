// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "session/exercise_kind.h"

namespace chiron::session {

/// The sphere-apex exercise (models.md §2.3).
class SphereApexKind final : public ExerciseKind {
public:
    std::string_view id() const noexcept override { return "sphere_apex"; }
    MarkRole markRole() const noexcept override { return MarkRole::endsTrial; }
    std::unique_ptr<simulation::IScene> makeScene(const SessionSetup& setup) const override;
    simulation::YieldLaw yieldLaw(const catalogue::ExerciseLevel& level) const override;
    core::Result<ScriptedTrainee> makeOperator(const catalogue::ExerciseLevel& level, const std::string& name,
                                               std::uint64_t seed, const HeldDevices& held) const override;
    std::vector<std::string> operatorNames() const override;
    int trialCount(const catalogue::ExerciseLevel& level) const override;
    double forceLimit_N(const catalogue::ExerciseLevel& level) const override;
    std::uint64_t tickLimit(const catalogue::ExerciseLevel& level) const override;
    /// For an organ computed at two rates.
    std::vector<core::QuantityDescription> quantities(const catalogue::ExerciseLevel& level) const override;
    /// For levels on meshes, whose law is not conservative.
    bool recordsEnergy(const catalogue::ExerciseLevel& level) const override;
    void addTruth(const catalogue::ExerciseLevel& level, std::uint64_t seed,
                  scoring::TrialTrace& trial) const override;
    std::unique_ptr<TrialSurfaces> makeSurfaces(const catalogue::ExerciseLevel& level,
                                                std::uint64_t seed) const override;
    core::Result<void> addMarks(const SessionSetup& setup, const scoring::SessionTrace* trace,
                                PlaybackTrack& track) const override;
    /// "missed": a mark beside the sphere, or in the air.
    void addAnswerEvents(const scoring::TrialTrace& trial, const database::TrialRecord& record,
                         AnswerEvents& events) const override;
    void storeTruth(const scoring::TrialTrace& trial,
                    QJsonObject& truth) const override; ///< apex_x_m, apex_y_m, radius_m
    /// The skilled trainee also does the organs (levels from 5 on).
    DemoPart demoPart(int level) const override { return {level == 1, level <= 2 || level >= 5, level <= 2}; }
    Demonstration demonstration() const override;
    std::vector<MomentRule> momentRules() const override;
    const MarkSessions* markSessions(const psychophysics::Condition& condition) const override;
};

} // namespace chiron::session
