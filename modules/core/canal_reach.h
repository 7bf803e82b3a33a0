// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace chiron::core {

/// An instrument's tip is in a canal while it is no farther than this from its centre-line, m: depth beside the canal is no depth.
/// 10 mm are twice the largest offset that the urethra's springs are made for (models.md §1.2: 5 mm) and far less than any other
/// way in.
inline constexpr double kCanalReach_m = 0.010;

} // namespace chiron::core
