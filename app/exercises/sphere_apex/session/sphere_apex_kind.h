// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "session/exercise_kind.h"

namespace chiron::session {

/// The sphere-apex exercise (models.md §2.3).
class SphereApexKind final : public ExerciseKind {
public:
    std::string_view id() const noexcept override { return "sphere_apex"; }
    std::unique_ptr<simulation::IScene> makeScene(const SessionSetup& setup) const override;
    core::Result<ScriptedTrainee> makeOperator(const catalogue::ExerciseLevel& level, const std::string& name,
                                               std::uint64_t seed) const override;
    std::vector<std::string> operatorNames() const override;
    int trialCount(const catalogue::ExerciseLevel& level) const override;
    double forceLimit_N(const catalogue::ExerciseLevel& level) const override;
    std::uint64_t tickLimit(const catalogue::ExerciseLevel& level) const override;
    std::vector<core::QuantityDescription> quantities(const catalogue::ExerciseLevel& level) const override; ///< of an organ at two rates
    bool recordsEnergy(const catalogue::ExerciseLevel& level) const override; ///< on meshes: their law is not conservative
    void addTruth(const catalogue::ExerciseLevel& level, std::uint64_t seed,
                  scoring::TrialTrace& trial) const override;
    std::unique_ptr<TrialSurfaces> makeSurfaces(const catalogue::ExerciseLevel& level,
                                                std::uint64_t seed) const override;
    core::Result<void> addMarks(const SessionSetup& setup, const scoring::SessionTrace* trace, PlaybackTrack& track) const override;
};

} // namespace chiron::session
