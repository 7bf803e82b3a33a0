// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "session/exercise_kind.h"

namespace chiron::session {

/// Objects side by side that differ in one attribute: the trials of a study (P2's studies). It has no level
/// in content/exercises: study/study_setup.h makes one from a condition of the study, and the session stores
/// it.
class ComparisonKind final : public ExerciseKind {
public:
    std::string_view id() const noexcept override { return "comparison"; }
    bool onlyInStudies() const noexcept override { return true; }
    MarkRole markRole() const noexcept override { return MarkRole::oneOfSeveral; }
    /// In the order of simulation::comparison_quantity.
    std::vector<core::QuantityDescription> quantities(const catalogue::ExerciseLevel& level) const override;
    bool recordsEnergy(const catalogue::ExerciseLevel&) const override { return true; }
    std::unique_ptr<simulation::IScene> makeScene(const SessionSetup& setup) const override;
    simulation::YieldLaw yieldLaw(const catalogue::ExerciseLevel& level) const override;
    /// "participant" explores every position of every trial and never answers; the answers come from the
    /// study's runner.
    core::Result<ScriptedTrainee> makeOperator(const catalogue::ExerciseLevel& level, const std::string& name,
                                               std::uint64_t seed, const HeldDevices& held) const override;
    std::vector<std::string> operatorNames() const override;
    /// One per trial that the study presents.
    int trialCount(const catalogue::ExerciseLevel&) const override { return 1; }
    double forceLimit_N(const catalogue::ExerciseLevel& level) const override;
    std::uint64_t tickLimit(const catalogue::ExerciseLevel& level) const override;
    /// attribute, places, candidate, arrangement, answer, and value_<i> (SI) for each position, as in the
    /// recorded quantities.
    void addTruth(const catalogue::ExerciseLevel& level, std::uint64_t seed,
                  scoring::TrialTrace& trial) const override;
    std::unique_ptr<TrialSurfaces> makeSurfaces(const catalogue::ExerciseLevel& level,
                                                std::uint64_t seed) const override;
    /// No tissue gives way here: what yields is the bed of a lifted object, which comes off the tool
    /// (mark_kinds::kCameOff).
    core::Result<void> addMarks(const SessionSetup& setup, const scoring::SessionTrace* trace,
                                PlaybackTrack& track) const override;
    std::string_view yieldWords() const noexcept override { return "object came off the tool"; }
};

} // namespace chiron::session
