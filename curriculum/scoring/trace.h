// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace chiron::scoring {

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
};

/// What is true of a sphere-apex trial, from its seed and content; needed for the apex errors only.
struct ApexTruth {
    double x_m = 0.0;
    double y_m = 0.0;
    double radius_m = 0.02;
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
    bool forcesKnown = true; ///< false: a file without force columns; tissue_N is zero and means nothing
};

struct SessionTrace {
    std::string exercise;
    double forceLimit_N = 4.0; ///< the level's limit for "over the limit" metrics
    std::vector<TrialTrace> trials;
};

} // namespace chiron::scoring
