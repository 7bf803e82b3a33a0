// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"
#include "scoring/own_trace.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace chiron::scoring {

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

/// The place in the plane that the answer of a trial had to mark, from its seed and content: the columns
/// target_x_mm, target_y_mm and target_radius_mm.
struct TargetTruth {
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
    std::optional<TargetTruth> target;     ///< exercises whose answer is a mark in a plane
    std::shared_ptr<const OwnTrace> own;   ///< what only its exercise knows of the trial; null: nothing
    std::vector<QuantityTrace> quantities; ///< exercises whose scene records quantities
    std::vector<NamedValue> truth;         ///< ground-truth values of this trial from its exercise
    bool failed = false;                   ///< kFailed: the trial could not be completed any more
    bool completed = false; ///< kCompleted: the procedure was done to its end; in other exercises a mark ends
                            ///< the trial
    /// The trial had no end (stopped, interrupted) and counts in no score. Never set in sessions that follow
    /// an earlier scoring rule.
    bool unfinished = false;
    /// false: the file has no force columns; tissue_N is zero and meaningless.
    bool forcesKnown = true;

    /// The exercise's own part as a value of its type; null if it is of another type or there is none.
    template <class Own> const Own* of() const noexcept { return dynamic_cast<const Own*>(own.get()); }
};

struct SessionTrace {
    std::string exercise;
    double forceLimit_N = 4.0; ///< the level's limit, for metrics such as "time over the limit"
    int plannedTrials = 0;     ///< number of trials that the level asks for; 0: not known
    std::vector<TrialTrace> trials;
};

} // namespace chiron::scoring
