// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "scoring/score_card.h"
#include "scoring/trace.h"

#include <span>
#include <string>

namespace chiron::scoring {

/// A metric to compute; version 0 is the newest one.
struct MetricRequest {
    std::string id;
    int version = 0;
};

/// Scores a session: the requested metrics in the order given, then gated ones that were not requested.
///
/// Per trial and for the session (`MetricDefinition::aggregate`). Deterministic: the trace is first brought
/// onto the stored grids (trace_grid.h), so a live trace, one read from the recording and one exported as CSV
/// and read back give the same doubles. `completed`: whether the session ended by itself; only then can it
/// pass (data.md, States). Failure: an unknown metric or version (badInput), vectors of unequal length in a
/// trace (badInput). Thread: any, holds no state; allocates, so never in the tick.
core::Result<ScoreCard> calculateScore(const SessionTrace& trace, std::span<const MetricRequest> metrics,
                                       std::span<const Gate> gates, bool completed);

} // namespace chiron::scoring
