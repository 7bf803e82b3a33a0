// SPDX-License-Identifier: GPL-3.0-or-later
#include "scoring/trace_builder.h"

namespace chiron::scoring {

void setTrialOfCanal(InsertionRow& row, const TrialTrace& trial) {
    const InsertionSeries& series = *trial.insertion;
    row.length_m = series.length_m;
    row.bend_m = series.bend_m;
    row.goal_m = series.goal_m;
    row.lateralLimit_N = series.lateralLimit_N;
    row.landmarks = static_cast<std::uint8_t>(series.landmarkSeen_s.size());
}

void setSampleOfCanal(InsertionRow& row, const InsertionSeries& series, std::size_t i, double t_s) {
    row.arc_m = series.s_m[i];
    row.offset_m = series.offset_m[i];
    row.alignment_rad = series.alignment_rad[i];
    row.lateral_N = series.lateral_N[i];
    row.axialTorque_Nm = series.axialTorque_Nm[i];
    row.stage = static_cast<core::ProcedureStage>(series.stage[i]);
    row.landmarksSeen = 0;
    for (std::size_t k = 0; k < series.landmarkSeen_s.size(); ++k)
        if (series.landmarkSeen_s[k] <= t_s) // NaN if it was not seen
            row.landmarksSeen |= 1u << k;
}

} // namespace chiron::scoring
