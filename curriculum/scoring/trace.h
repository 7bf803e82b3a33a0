// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace chiron::scoring {

/// A trace file stores one bit per landmark that was seen.
inline constexpr std::size_t kMostLandmarks = 32;

/// One tool's samples of one trial, as metrics read them. All vectors have the same length. Times are from
/// the device's clock (s, from the session's first frame, whole microseconds). Positions are rounded to 1 nm
/// and forces to the stored 1 mN, so that a trace exported as CSV and read back gives the same doubles and
/// therefore the same scores.
struct ToolTrace {
    std::vector<double> t_s;
    std::vector<core::Vec3> p_WT_m;
    std::vector<core::Vec3> tissue_N;    ///< force on the tool as computed by the scene
    std::vector<core::Vec3> commanded_N; ///< after the supervisor; empty if the file has none
    std::vector<core::Vec3> measured_N;  ///< empty if the device measures none
    std::vector<std::uint8_t> paused;    ///< 1: left out of every metric
    /// core::contact_bits; empty in a file without the column: no sample is beyond the checked range and
    /// nothing yielded.
    std::vector<std::uint8_t> contact;
    /// Unit quaternion; empty if orientation is meaningless (a Cartesian device, or a file without it).
    std::vector<core::Quat> q_WT;
    /// About the tip, on the tool, at the stored 0.01 mN·m; empty whenever q_WT is.
    std::vector<core::Vec3> tissueTorque_Nm;
    /// Number of running (unpaused) ticks for which the sample was the newest one, independent of the
    /// device's clock: the scene stepped that often with it. Available only from recordings; empty in a trace
    /// file and on the stored grids, where nothing is stepped any more.
    std::vector<std::uint32_t> heldTicks;
};

/// The tool's motion relative to a canal, sample by sample of tool 0. It is derived from stored poses and
/// wrenches by the exercise's own geometry (app/session), or read from a trace file's columns. All vectors
/// have the length of tool 0's.
struct InsertionSeries {
    std::vector<double> s_m;      ///< arc length of the point nearest to the tip; < 0 before the
                                  ///< entrance
    std::vector<double> offset_m; ///< distance from the centre-line, ≥ 0
    /// Angle between the instrument's axis and the tangent of the centre-line, ≥ 0.
    std::vector<double> alignment_rad;
    /// All tissue force perpendicular to the tangent of the centre-line (wall, and friction on a tilted
    /// shaft), ≥ 0.
    std::vector<double> lateral_N;
    std::vector<double> axialTorque_Nm; ///< |T_z|
    std::vector<std::uint8_t> stage;    ///< core::ProcedureStage
    double length_m = 0.0;              ///< L
    double bend_m = 0.0;                ///< s_B: where the orientation has to change
    double goal_m = 0.0;                ///< depth that ends the insertion
    double lateralLimit_N = 2.0;        ///< limit for trauma events
    /// Time at which each landmark was seen, NaN if it was not; empty: the level has none.
    std::vector<double> landmarkSeen_s;
};

/// The truth of a sphere-apex trial, from its seed and content. Only the apex errors need it.
struct ApexTruth {
    double x_m = 0.0;
    double y_m = 0.0;
    double radius_m = 0.02;
};

/// One recorded quantity of the scene (core::QuantityDescription), sample by sample of tool 0, on the
/// recording's grid.
struct QuantityTrace {
    std::string id; ///< with its unit, e.g. "squeeze_0_N"
    std::vector<double> values;
};

/// A ground-truth value of a trial, from its content and seed, that a metric needs: a target or a limit. SI;
/// the name contains the unit.
struct NamedValue {
    std::string id;
    double value = 0.0;
};

/// One trial: the samples from the tick at which it started (event kTrialStarted) to its mark or time-out,
/// both included.
struct TrialTrace {
    int trial = 0;
    std::vector<ToolTrace> tools;
    bool marked = false;
    bool timedOut = false;
    core::Vec3 p_WMark_m = core::Vec3::Zero(); ///< tool 0 at the mark (last position if the file had no mark)
    bool markInContact = false;
    std::optional<ApexTruth> apex;
    std::optional<InsertionSeries> insertion; ///< exercises through a canal
    std::vector<QuantityTrace> quantities;    ///< exercises whose scene records quantities
    std::vector<NamedValue> truth;            ///< ground-truth values of this trial from its exercise
    bool failed = false;                      ///< kFailed: the trial could not be completed any more
    bool completed = false; ///< kCompleted: the procedure was done to its end; in other exercises a mark ends
                            ///< the trial
    /// The trial had no end (stopped, interrupted) and counts in no score. Never set in sessions that follow
    /// an earlier scoring rule.
    bool unfinished = false;
    /// false: the file has no force columns; tissue_N is zero and meaningless.
    bool forcesKnown = true;
};

struct SessionTrace {
    std::string exercise;
    double forceLimit_N = 4.0; ///< the level's limit, for metrics such as "time over the limit"
    int plannedTrials = 0;     ///< number of trials that the level asks for; 0: not known
    std::vector<TrialTrace> trials;
};

} // namespace chiron::scoring
