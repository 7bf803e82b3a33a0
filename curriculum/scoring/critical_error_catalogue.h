// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scoring/trace.h"

#include <vector>

namespace chiron::scoring {

/// A stretch of a trial that is a critical error though no tissue gave way in the simulation. Device time, as the trace's.
struct CriticalSpan {
    double begin_s = 0.0;
    double end_s = 0.0;
};

/// From this version on, critical_errors counts critical spans.
inline constexpr int kCriticalSpansCountFrom = 2;

/// Of every exercise that has some, in the order of time within each. `trial` must be on the stored grids (trace_grid.h). Pure.
std::vector<CriticalSpan> criticalSpans(const TrialTrace& trial);

} // namespace chiron::scoring
