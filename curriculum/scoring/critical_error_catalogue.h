// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scoring/trace.h"

#include <vector>

namespace chiron::scoring {

/// A time span of a trial that counts as a critical error although no tissue gave way in the simulation.
/// Device time, as in the trace.
struct CriticalSpan {
    double begin_s = 0.0;
    double end_s = 0.0;
};

/// The first version of the metric critical_errors that counts critical spans.
inline constexpr int kCriticalSpansCountFrom = 2;

/// Returns the critical spans of a trial according to the rules of all exercises that have one; the spans of
/// one rule are in the order of time. `trial` must be on the stored grids (trace_grid.h). The function is
/// pure.
std::vector<CriticalSpan> criticalSpans(const TrialTrace& trial);

} // namespace chiron::scoring
