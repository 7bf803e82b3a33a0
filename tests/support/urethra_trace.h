// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scoring/trace_rows.h"
#include "support/urethra_bench.h"

namespace chiron::tests {

/// A perfect hand's way through the procedure of `p`, as a trace with one row every 10 ms: played back it
/// does the whole procedure again. It goes 1 mm deeper than asked for and holds each landmark a fifth longer,
/// so that the resampling costs nothing.
inline scoring::TraceRows idealTrace(simulation::UrethraInsertionParameters p, double speed_m_per_s) {
    p.landmarkHold_s *= 1.2;
    p.goalDepth_m = simulation::procedurePlan(p).goal_m + 0.001;
    simulation::UrethraInsertionScene scene(p);
    IdealProcedure hand(p, speed_m_per_s);
    realtime::TickSource ticks;
    simulation::SceneInput in;
    simulation::SceneOutput out;
    in.started = in.forceReady = true;
    in.tools.count = 1;
    scoring::TraceRows trace;
    trace.source = "ideal";
    trace.columns.orientation = true;
    constexpr std::uint64_t kLongest_ticks = 200'000;
    constexpr int kAfterwards_ticks = 100; // the end of the trace is not the end of the procedure
    for (int after = 0; after < kAfterwards_ticks && ticks.executed() < kLongest_ticks;) {
        const core::ToolState tool = hand.next(scene.procedure().stage(), scene.procedure().nextLandmark());
        if (ticks.executed() % 10 == 0) {
            scoring::TraceRow row;
            row.t_s = static_cast<double>(ticks.executed()) * 1e-3;
            row.p_WT_m = tool.p_WT;
            row.q_WT = tool.q_WT;
            trace.rows.push_back(row);
        }
        in.tools.tools[0] = tool;
        scene.respond(ticks.next(0), in, out);
        after += out.phase == core::TrialPhase::finished ? 1 : 0;
    }
    return trace;
}

} // namespace chiron::tests
