// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/exercises/urethra_insertion/session/playback_insertion.h"
#include "support/insertion_in.h"

#include <cmath>
#include <memory>

namespace chiron::tests {

/// In by 20 mm/s to 60 mm, a second of inspection, and out again; off-centre by 1 mm on the way in and 2 mm
/// on the way out.
inline scoring::SessionTrace madeTrace(double begin_s = 2.0) {
    scoring::TrialTrace trial;
    trial.tools.resize(1);
    trial.own = std::make_shared<scoring::InsertionSeries>();
    scoring::InsertionSeries& series = insertionIn(trial);
    series.length_m = 0.05;
    series.bend_m = 0.03;
    series.goal_m = 0.06;
    series.landmarkSeen_s = {begin_s + 3.5, std::nan("")};
    for (int i = 0; i <= 7000; ++i) {
        const double t_s = 1e-3 * i;
        const double s_m = t_s < 3.0 ? 0.02 * t_s : t_s < 4.0 ? 0.06 : 0.06 - 0.02 * (t_s - 4.0);
        const simulation::ProcedureStage stage = t_s < 3.0   ? simulation::ProcedureStage::insertion
                                                 : t_s < 4.0 ? simulation::ProcedureStage::inspection
                                                             : simulation::ProcedureStage::withdrawal;
        trial.tools[0].t_s.push_back(begin_s + t_s);
        trial.tools[0].paused.push_back(0);
        series.s_m.push_back(s_m);
        series.offset_m.push_back(stage == simulation::ProcedureStage::withdrawal ? 0.002 : 0.001);
        series.alignment_rad.push_back(s_m > 0.03 ? 0.2 : 0.1);
        series.stage.push_back(static_cast<std::uint8_t>(stage));
    }
    scoring::SessionTrace trace;
    trace.trials.push_back(std::move(trial));
    return trace;
}

/// A track of 9.5 s, 250 samples a second, that the made trace belongs to.
inline session::PlaybackTrack madeTrack() {
    session::PlaybackTrack track;
    track.toolCount = 1;
    track.forceLimit_N = 4.0;
    track.exercise = "urethra_insertion";
    for (int i = 0; i < 2375; ++i) {
        session::PlaybackMoment moment;
        moment.t_s = 4e-3 * i;
        moment.tick = static_cast<std::uint64_t>(4 * i);
        track.moments.push_back(moment);
        track.tools.emplace_back();
    }
    session::PlaybackTrial trial;
    trial.start_s = 2.0;
    trial.end_s = 9.0;
    track.trials.push_back(trial);
    track.duration_s = track.moments.back().t_s;
    session::addInsertion(track, madeTrace());
    return track;
}

} // namespace chiron::tests
