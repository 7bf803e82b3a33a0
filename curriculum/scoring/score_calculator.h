// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "scoring/score_card.h"
#include "scoring/trace.h"

#include <span>
#include <string>

namespace chiron::scoring {

/// A metric to compute; version 0 means the newest one.
struct MetricRequest {
    std::string id;
    int version = 0;
};

/// Scores a session: first the requested metrics in the order given, then gated ones that were not requested,
/// per trial and for the session (`MetricDefinition::aggregate`).
///
/// Deterministic: the trace is first brought onto the stored grids (trace_grid.h), so that a live trace, one
/// read from the recording, and one exported as CSV and read back give the same doubles. `completed` says
/// whether the session ended by itself; only then can it pass (data.md, States).
/// Thread: any; holds no state, but allocates, so it must not run in the tick.
/// Errors: badInput for an unknown metric or version, or vectors of unequal length in a trace.
core::Result<ScoreCard> calculateScore(const SessionTrace& trace, std::span<const MetricRequest> metrics,
                                       std::span<const Gate> gates, bool completed);

} // namespace chiron::scoring
