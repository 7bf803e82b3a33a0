// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "session/exercise_kind.h"

namespace chiron::session {

/// Palpation: finding lumps in a tissue (P3; models.md §3). One tool is one finger.
class PalpationKind final : public ExerciseKind {
public:
    std::string_view id() const noexcept override { return "palpation"; }
    std::span<const std::string_view> mechanisms() const noexcept override { return kMechanisms; }
    MarkRole markRole() const noexcept override { return MarkRole::oneOfSeveral; } ///< one of its findings
    LevelTools tools(const catalogue::ExerciseLevel& level) const override;        ///< a jaw for a pinch
    /// Two hands come from the right (tool 0 on) and from the left, over the middles of the two halves of the
    /// search area; a single hand is over the middle. A hand's second finger is beside its first, along +x (a
    /// right hand's middle finger, a left hand's index finger). On P3's arm both fingers of a hand are at the
    /// position of the first one.
    devices::WorkspaceMapping toolPlace(const catalogue::ExerciseLevel& level, int tool) const override;
    std::optional<core::Vec3> toolStart_W(const catalogue::ExerciseLevel& level,
                                          const devices::WorkspaceMapping& place) const override;
    /// In the order of simulation::palpation_quantity.
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
    std::uint64_t tickLimit(const catalogue::ExerciseLevel& level) const override;
    /// lumps, and for each lump lump_<i>_x_m, lump_<i>_y_m, lump_<i>_z_m (the surface point above it),
    /// lump_<i>_depth_m, lump_<i>_radius_m, lump_<i>_hardness; area_half_x_m, area_half_y_m, region_columns,
    /// region_rows, hit_radius_m, band_low_N, band_high_N, cover_force_N, asks_size, asks_hardness. If a
    /// research control moved the lumps (lumps_moved), their new positions.
    void addTruth(const catalogue::ExerciseLevel& level, std::uint64_t seed,
                  scoring::TrialTrace& trial) const override;
    /// The tissue's surface. The object of a trial is the set of its lumps, placed at the middle of the
    /// search area.
    std::unique_ptr<TrialSurfaces> makeSurfaces(const catalogue::ExerciseLevel& level,
                                                std::uint64_t seed) const override;
    bool marksFromTrace() const noexcept override { return true; }
    core::Result<void> addMarks(const SessionSetup& setup, const scoring::SessionTrace* trace,
                                PlaybackTrack& track) const override;
    /// "false_alarm" (at the time of a finding that matched no lump; detail: finding, from 1) and
    /// "lump_missed" (at the end of a trial that was completed).
    void addAnswerEvents(const scoring::TrialTrace& trial, const database::TrialRecord& record,
                         AnswerEvents& events) const override;
    /// A session lasts ten minutes or more, so the learning trainee does none, and no operator does all
    /// levels.
    DemoPart demoPart(int level) const override {
        return {.ofWhoCan = level <= 2, .ofOperators = level <= 2};
    }
    Demonstration demonstration() const override;
    std::vector<MomentRule> momentRules() const override;

private:
    static constexpr std::array<std::string_view, 2> kMechanisms{"fingertip_arm", devices::kGimbalHprd};
};

} // namespace chiron::session
