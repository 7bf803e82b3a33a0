// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"
#include "scoring/trace.h"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace chiron::scoring {

/// A stretch of motion without a pause or gap, for the kinematic metrics.
struct MotionRun {
    std::vector<double> t_s;
    std::vector<core::Vec3> p_WT_m;
    /// First differences: [i] is from sample i to i + 1; one fewer than samples.
    std::vector<double> speed_m_per_s;
};

/// A trial's motion, low-passed and at 100 Hz; the motion of a slower trace is unchanged (models.md §6).
struct Motion {
    std::vector<MotionRun> runs;
    double dt_s = 0.01;
    double peakSpeed_m_per_s = 0.0;
};

/// The data of one trial that metrics read. It refers to the trial from which it was made.
struct PreparedTrial {
    const TrialTrace* trial = nullptr;
    const ToolTrace* tool = nullptr; ///< the first tool; null if the trial has no samples
    double forceLimit_N = 4.0;
    /// Planned trials of its session, when all of its trials are measured together; 0: not known.
    int plannedTrials = 0;
    Motion motion;                         ///< low-passed at 20 Hz
    Motion jerkMotion;                     ///< low-passed at 6 Hz, for LDLJ
    std::optional<double> movementStart_s; ///< start of the first 50 ms above 5 mm/s
    std::optional<double> contactStart_s;  ///< first sample with tissue force over 0.02 N
};

/// models.md §6; force counts as "non-zero" above this value.
inline constexpr double kContactForce_N = 0.02;
inline constexpr double kMovementSpeed_m_per_s = 0.005; ///< models.md §6
inline constexpr double kMovementDuration_s = 0.05;     ///< models.md §6
inline constexpr double kSubMovementShare = 0.05;       ///< of the trial's peak speed, models.md §6
inline constexpr double kSubMovementDuration_s = 0.1;   ///< models.md §6

/// Prepares a trial. `trial` must be on the stored grids (trace_grid.h) and outlive the result.
PreparedTrial prepareTrial(const TrialTrace& trial, double forceLimit_N);

/// Returns the trial's motion after a low-pass at `cutOff_Hz`.
///
/// If the trace is faster than 100 Hz (median step below 9.5 ms), each run is interpolated linearly on an
/// even grid of the median step, low-passed with zero phase (low_pass.h) and read every 10 ms. A run ends at
/// a pause and at a gap of more than 100 median steps.
Motion motionOf(const ToolTrace& tool, double cutOff_Hz);

/// Returns the speed profiles of the sub-movements: stretches above 5 % of the trial's peak speed for at
/// least 100 ms. Empty if the trial has no movement start, so that the noise of a still hand is not a
/// movement.
std::vector<std::span<const double>> subMovements(const PreparedTrial& trial, const Motion& motion);

} // namespace chiron::scoring
