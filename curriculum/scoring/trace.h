// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace chiron::scoring {

inline constexpr std::size_t kMostLandmarks = 32; ///< a trace file tells which were seen in one bit each

/// One tool's samples of one trial as metrics see them. All vectors have the same length. Times are the
/// device's clock (s, from the session's first frame, whole microseconds); positions are rounded to 1 nm and
/// forces to the stored 1 mN, so that a trace exported as CSV and read back gives the same doubles and so the
/// same scores.
struct ToolTrace {
    std::vector<double> t_s;
    std::vector<core::Vec3> p_WT_m;
    std::vector<core::Vec3> tissue_N;    ///< force on the tool as the scene answered
    std::vector<core::Vec3> commanded_N; ///< after the supervisor; empty if the file has none
    std::vector<core::Vec3> measured_N;  ///< empty if the device measures none
    std::vector<std::uint8_t> paused;    ///< 1: left out of every metric
    std::vector<std::uint8_t> contact;   ///< core::contact_bits; empty in a file without the column: nothing beyond, nothing yielded
    std::vector<core::Quat> q_WT; ///< unit; empty where orientation means nothing (a Cartesian device, a file without it)
    std::vector<core::Vec3> tissueTorque_Nm; ///< about the tip, on the tool, at the stored 0.01 mN·m; empty as q_WT
    /// Running ticks (no pause) that had the sample as their newest: what the scene counted with it, whatever the device's
    /// clock says. From recordings only; empty in a trace file, and on the stored grids, where nothing is stepped any more.
    std::vector<std::uint32_t> heldTicks;
};

/// What the tool did with respect to a canal, sample by sample of tool 0: derived from stored poses and wrenches by the
/// exercise's own geometry (app/session), or read from a trace file's columns. All vectors have tool 0's length.
struct InsertionSeries {
    std::vector<double> s_m;             ///< arc length of the tip's foot; < 0 before the entrance
    std::vector<double> offset_m;        ///< distance from the centre-line, ≥ 0
    std::vector<double> alignment_rad;   ///< angle between the instrument's axis and the centre-line's tangent, ≥ 0
    std::vector<double> lateral_N;       ///< all tissue force perpendicular to the centre-line's tangent (wall, and friction on a tilted shaft), ≥ 0
    std::vector<double> axialTorque_Nm;  ///< |T_z|
    std::vector<std::uint8_t> stage;     ///< core::ProcedureStage
    double length_m = 0.0;               ///< L
    double bend_m = 0.0;                 ///< s_B: where the orientation has to change
    double goal_m = 0.0;                 ///< depth that ends the insertion
    double lateralLimit_N = 2.0;         ///< trauma events
    std::vector<double> landmarkSeen_s;  ///< time each landmark was seen, NaN where it was not; empty: the level has none
};

/// What is true of a sphere-apex trial, from its seed and content; needed for the apex errors only.
struct ApexTruth {
    double x_m = 0.0;
    double y_m = 0.0;
    double radius_m = 0.02;
};

/// One of the recorded quantities of the scene (core::QuantityDescription), sample by sample of tool 0, on the recording's grid.
struct QuantityTrace {
    std::string id; ///< with its unit, e.g. "squeeze_0_N"
    std::vector<double> values;
};

/// Something that is true of a trial, from its content and seed, that a metric needs: a target, a limit. SI; the name has the unit.
struct NamedValue {
    std::string id;
    double value = 0.0;
};

/// One trial: samples from the tick it started (event kTrialStarted) to its mark or time-out, both included.
struct TrialTrace {
    int trial = 0;
    std::vector<ToolTrace> tools;
    bool marked = false;
    bool timedOut = false;
    core::Vec3 p_WMark_m = core::Vec3::Zero(); ///< tool 0 at the mark (last position if the file had no mark)
    bool markInContact = false;
    std::optional<ApexTruth> apex;
    std::optional<InsertionSeries> insertion; ///< exercises through a canal
    std::vector<QuantityTrace> quantities; ///< exercises whose scene records some
    std::vector<NamedValue> truth;    ///< of this trial, what its kind of exercise adds
    bool failed = false;    ///< kFailed: it could not be done any more
    bool completed = false; ///< the procedure was done to its end (kCompleted); marks end other exercises
    bool unfinished = false; ///< it had no end (stopped, interrupted): in no score. Never set by who scores as before (SessionTrace)
    bool forcesKnown = true; ///< false: a file without force columns; tissue_N is zero and means nothing
};

struct SessionTrace {
    std::string exercise;
    double forceLimit_N = 4.0; ///< the level's limit for "over the limit" metrics
    int plannedTrials = 0;     ///< how many the level asks for; 0: not known
    std::vector<TrialTrace> trials;
};

} // namespace chiron::scoring
