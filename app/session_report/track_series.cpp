// SPDX-License-Identifier: GPL-3.0-or-later
#include "session_report/track_series.h"

#include <cmath>
#include <numbers>

namespace chiron::session_report {

using session::PlaybackTrack;

namespace {
constexpr double kDegrees = 180.0 / std::numbers::pi;
} // namespace

report::SampleSeries seriesOf(const PlaybackTrack& track) {
    report::SampleSeries series;
    for (std::size_t i = 0; i < track.moments.size() && track.toolCount > 0; ++i) {
        const session::PlaybackTool& tool = track.tool(i, 0);
        series.t_s.push_back(track.moments[i].t_s);
        series.x_mm.push_back(tool.p_WT.x() * 1e3);
        series.y_mm.push_back(tool.p_WT.y() * 1e3);
        series.z_mm.push_back(tool.p_WT.z() * 1e3);
        series.tissue_N.push_back(tool.tissue_N.norm());
        series.speed_mm_per_s.push_back(tool.speed_m_per_s * 1e3);
        if (track.insertion) {
            series.offset_mm.push_back(track.insertion->moments[i].offset_m * 1e3);
            series.alignment_deg.push_back(track.insertion->moments[i].alignment_rad * kDegrees);
        }
        if (track.felt)
            series.commanded_N.push_back(tool.commanded_N);
        if (track.measures)
            series.measured_N.push_back(tool.measured_N);
    }
    for (const session::PlaybackSpan& span : track.paused)
        series.paused.push_back({span.begin_s, span.end_s});
    for (const session::PlaybackTrial& trial : track.trials)
        if (track.trials.size() > 1 || !track.insertion) // of one procedure there is nothing to number
            series.events.push_back({trial.start_s, QString::number(trial.index + 1)});
    return series;
}

} // namespace chiron::session_report
