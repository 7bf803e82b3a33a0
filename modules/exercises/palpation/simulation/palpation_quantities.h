// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace chiron::simulation {

/// Where each of `SceneOutput::quantities` stands (palpation). Their ids in recordings, in this order: report_count,
/// report_field, report_finding, report_value, finding_x_m, finding_y_m, finding_z_m, coverage, depth_0_m .. depth_3_m,
/// lean_0_rad .. lean_3_rad, lean_saturated, lumps_moved; where the jaws squeeze (PalpationParameters::pinch) squeeze_0_N, squeeze_1_N.
namespace palpation_quantity {
/// Reports of this trial so far. When it rises by one, the next six tell of that report: which field (core::ReportField), about
/// which finding, the value as in the report word, and the finding's place on the surface (W). One report each 10 ms
/// at most; more wait.
inline constexpr std::size_t kReportCount = 0;
inline constexpr std::size_t kReportField = 1;
inline constexpr std::size_t kReportFinding = 2;
inline constexpr std::size_t kReportValue = 3;
inline constexpr std::size_t kFindingPlace = 4; ///< x, y, z, m
inline constexpr std::size_t kCoverage = 7;     ///< 0..1 of the search area, this trial
inline constexpr std::size_t kDepth = 8;        ///< of each finger, m
inline constexpr std::size_t kLean = 12;        ///< α of each finger, unlimited, rad
inline constexpr std::size_t kLeanSaturated = 16; ///< one bit a finger
inline constexpr std::size_t kLumpsMoved = 17;    ///< 1 once the level's control moved the lumps
inline constexpr std::size_t kCount = 18;           ///< without a pinch
inline constexpr std::size_t kSqueeze = 18;         ///< of each hand's jaw, N
inline constexpr std::size_t kSqueezes = 2;
} // namespace palpation_quantity

} // namespace chiron::simulation
