// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "modules/exercises/urethra_insertion/cues/procedure_stage.h"
#include "scoring/own_trace.h"
#include "scoring/trace.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string_view>
#include <vector>

namespace chiron::scoring {

/// A trace file stores one bit per landmark that was seen.
inline constexpr std::size_t kMostLandmarks = 32;

/// The tool's motion relative to a canal, sample by sample of tool 0. It is derived from stored poses and
/// wrenches by the exercise's own geometry (app/session), or read from a trace file's columns. All vectors
/// have the length of tool 0's.
class InsertionSeries final : public OwnTrace {
public:
    std::vector<double> s_m;      ///< arc length of the point nearest to the tip; < 0 before the
                                  ///< entrance
    std::vector<double> offset_m; ///< distance from the centre-line, ≥ 0
    /// Angle between the instrument's axis and the tangent of the centre-line, ≥ 0.
    std::vector<double> alignment_rad;
    /// All tissue force perpendicular to the tangent of the centre-line (wall, and friction on a tilted
    /// shaft), ≥ 0.
    std::vector<double> lateral_N;
    std::vector<double> axialTorque_Nm; ///< |T_z|
    std::vector<std::uint8_t> stage;    ///< simulation::ProcedureStage
    double length_m = 0.0;              ///< L
    double bend_m = 0.0;                ///< s_B: where the orientation has to change
    double goal_m = 0.0;                ///< depth that ends the insertion
    double lateralLimit_N = 2.0;        ///< limit for trauma events
    /// Time at which each landmark was seen, NaN if it was not; empty: the level has none.
    std::vector<double> landmarkSeen_s;

    bool fits(std::size_t samples) const noexcept override;
    bool finiteAt(std::size_t i) const noexcept override;
    /// The time at which a landmark was seen becomes that of the first sample at or after it.
    /// Errors: more than kMostLandmarks landmarks.
    core::Result<std::shared_ptr<const OwnTrace>> onGrids(std::span<const std::size_t> kept,
                                                          std::span<const double> t_s) const override;
    const OwnColumns& columns() const noexcept override;
    void fillTrial(std::span<double> own) const noexcept override;
    void fillSample(std::span<double> own, std::size_t i, double t_s) const noexcept override;
    /// Insertion and withdrawal follow the centre-line.
    WayAlongLine way() const noexcept override;
};

/// The series of a trial; null if it has none.
inline const InsertionSeries* insertionOf(const TrialTrace& trial) noexcept {
    return trial.of<InsertionSeries>();
}

/// arc_mm ... stage, landmarks_seen; and, per trial, length_mm ... landmarks. A landmark was seen at the
/// first row that has its bit.
const OwnColumns& canalColumns() noexcept;

/// The word of a stage in trace files and marks.
std::string_view stageName(simulation::ProcedureStage stage) noexcept;

} // namespace chiron::scoring
