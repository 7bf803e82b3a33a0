// SPDX-License-Identifier: GPL-3.0-or-later
#include "session_report/track_series.h"

#include "session/exercise_kind.h"
#include "session_report/exercise_reporter.h"
#include "session_report/mark_words.h"

#include <cmath>

namespace chiron::session_report {

using session::PlaybackTrack;

namespace {

report::ToolSamples samplesOf(const PlaybackTrack& track, int tool) {
    report::ToolSamples samples;
    for (std::size_t i = 0; i < track.moments.size(); ++i) {
        const session::PlaybackTool& at = track.tool(i, tool);
        samples.x_mm.push_back(at.p_WT.x() * 1e3);
        samples.y_mm.push_back(at.p_WT.y() * 1e3);
        samples.z_mm.push_back(at.p_WT.z() * 1e3);
        samples.tissue_N.push_back(at.tissue_N.norm());
        samples.speed_mm_per_s.push_back(at.speed_m_per_s * 1e3);
        if (track.felt)
            samples.commanded_N.push_back(at.commanded_N);
        if (track.measures)
            samples.measured_N.push_back(at.measured_N);
    }
    return samples;
}

bool hasSeveralTrials(const catalogue::ExerciseLevel& level) {
    const auto kind = session::exerciseKind(level.exercise);
    return !kind || (*kind)->trialCount(level) > 1;
}

} // namespace

report::SampleSeries seriesOf(const PlaybackTrack& track, const catalogue::ExerciseLevel& level,
                              const QLocale& locale) {
    report::SampleSeries series;
    for (std::size_t i = 0; i < track.moments.size() && track.toolCount > 0; ++i)
        series.t_s.push_back(track.moments[i].t_s);
    for (const session::PlaybackQuantity& derived : track.derived)
        series.derived.push_back({derived.id, derived.values});
    for (int tool = 0; tool < track.toolCount; ++tool) {
        series.tools.push_back(samplesOf(track, tool));
        series.tools.back().name = toolName(level, tool, track.toolCount);
    }
    for (const session::PlaybackSpan& span : track.paused)
        series.paused.push_back({span.begin_s, span.end_s});
    for (const session::PlaybackTrial& trial : track.trials)
        // With a single procedure there is nothing to number.
        if (track.trials.size() > 1 || hasSeveralTrials(level))
            series.events.push_back({trial.start_s, QString::number(trial.index + 1)});
    for (const session::PlaybackMark& mark : track.marks)
        if (mark.critical)
            series.criticalErrors.push_back(
                {mark.t_s, mark.end_s, mark.trial, mark.tool, whatHappened(mark, level.exercise, locale)});
    return series;
}

} // namespace chiron::session_report
