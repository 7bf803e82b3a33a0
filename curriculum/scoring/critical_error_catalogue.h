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

/// The first version of the metric critical_errors that counts critical spans.
inline constexpr int kCriticalSpansCountFrom = 2;

/// The critical spans of a trial by the rule of each exercise that has one; those of one rule are in the order of time. `trial` must be
/// on the stored grids (trace_grid.h). Pure.
std::vector<CriticalSpan> criticalSpans(const TrialTrace& trial);

} // namespace chiron::scoring
