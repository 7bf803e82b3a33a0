// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace chiron::simulation {

/// Largest distance of an instrument's tip from a canal's centre-line, in m, at which the tip still counts as
/// being in the canal: depth measured beside the canal is not depth in it. 10 mm are twice the largest offset
/// that the urethra's springs are made for (models.md §1.2: 5 mm) and far smaller than the distance of any
/// other way into the body.
inline constexpr double kCanalReach_m = 0.010;

} // namespace chiron::simulation
