// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace chiron::simulation {

/// Indices into `SceneOutput::quantities` (palpation). Their ids in recordings are, in this order:
/// report_count, report_field, report_finding, report_value, finding_x_m, finding_y_m, finding_z_m, coverage,
/// depth_0_m .. depth_3_m, lean_0_rad .. lean_3_rad, lean_saturated, lumps_moved; and squeeze_0_N,
/// squeeze_1_N where the jaws squeeze (PalpationParameters::pinch).
namespace palpation_quantity {
/// Number of reports in this trial so far. When it rises by one, the next six values describe that report:
/// its field (ReportField), the finding that it is about, its value as in the report word, and the
/// finding's position on the surface (W). There is at most one report every 10 ms; further ones wait.
inline constexpr std::size_t kReportCount = 0;
inline constexpr std::size_t kReportField = 1;
inline constexpr std::size_t kReportFinding = 2;
inline constexpr std::size_t kReportValue = 3;
inline constexpr std::size_t kFindingPlace = 4;   ///< x, y, z, m
inline constexpr std::size_t kCoverage = 7;       ///< 0..1: share of the search area, in this trial
inline constexpr std::size_t kDepth = 8;          ///< of each finger, m
inline constexpr std::size_t kLean = 12;          ///< α of each finger, unlimited, rad
inline constexpr std::size_t kLeanSaturated = 16; ///< one bit per finger
inline constexpr std::size_t kLumpsMoved = 17;    ///< 1 once the level's control has moved the lumps
inline constexpr std::size_t kCount = 18;         ///< number of quantities without a pinch
inline constexpr std::size_t kSqueeze = 18;       ///< of each hand's jaws, N
inline constexpr std::size_t kSqueezes = 2;
} // namespace palpation_quantity

} // namespace chiron::simulation
