// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/exercises/urethra_insertion/session/insertion_marks.h"
#include "frames.h"
#include "modules/exercises/urethra_insertion/cues/endoscope_cues.h"
#include "modules/exercises/urethra_insertion/cues/procedure_bits.h"
#include "session/exercise_kind.h"
#include "session/playback_track.h"
#include "support/insertion_in.h"

#include <limits>
#include <memory>
#include <utility>
#include <vector>

/// A made-up insertion of 2 s, as it is scored and as its frames are marked.
namespace chiron::tests {

inline constexpr double kNever = std::numeric_limits<double>::quiet_NaN();

/// 2 s at 1 kHz: in, back by 5 mm from 0.5 to 0.6 s, on, over the limit for 50 ms and for 30 ms, inspection
/// from 1.2 s, withdrawal from 1.6 s.
inline scoring::SessionTrace trace() {
    scoring::TrialTrace trial;
    scoring::ToolTrace tool;
    scoring::InsertionSeries series;
    for (int i = 0; i <= 2000; ++i) {
        const double t = 1e-3 * i;
        const double s_mm = t < 0.5   ? 100.0 * t
                            : t < 0.6 ? 50.0 - 50.0 * (t - 0.5)
                                      : 45.0 + 100.0 * (t - 0.6);
        tool.t_s.push_back(t);
        tool.p_WT_m.push_back(core::Vec3(1e-3 * s_mm, 0.0, 0.0));
        tool.tissue_N.push_back(core::Vec3::Zero());
        tool.paused.push_back(0);
        series.s_m.push_back(1e-3 * s_mm);
        series.offset_m.push_back(0.0);
        series.alignment_rad.push_back(0.0);
        series.lateral_N.push_back(i >= 800 && i < 850 ? 2.5 : i >= 900 && i < 930 ? 3.25 : 0.0);
        series.axialTorque_Nm.push_back(0.0);
        series.stage.push_back(static_cast<std::uint8_t>(t < 0.1    ? simulation::ProcedureStage::outside
                                                         : t < 1.2  ? simulation::ProcedureStage::insertion
                                                         : t < 1.6  ? simulation::ProcedureStage::inspection
                                                         : i < 2000 ? simulation::ProcedureStage::withdrawal
                                                                    : simulation::ProcedureStage::completed));
    }
    series.length_m = 0.11;
    series.bend_m = 0.04;
    series.goal_m = 0.12;
    series.landmarkSeen_s = {1.5, kNever, 1.3, 1.5};
    trial.tools.push_back(std::move(tool));
    trial.own = std::make_shared<scoring::InsertionSeries>(std::move(series));
    scoring::SessionTrace session;
    session.exercise = "urethra_insertion";
    session.trials.push_back(std::move(trial));
    return session;
}

/// The same session's frames, through the extractor.
inline session::PlaybackTrack track(std::uint32_t lastEvent = core::event_bits::kCompleted |
                                                              core::event_bits::kStageChanged) {
    auto frames = someFrames(2001);
    frames[0].header.events = core::event_bits::kTrialStarted;
    for (const std::size_t at : {std::size_t{100}, std::size_t{1200}, std::size_t{1600}})
        frames[at].header.events |= core::event_bits::kStageChanged;
    frames[1300].header.events |= simulation::procedure_bits::kLandmarkSeen;
    frames[1500].header.events |= simulation::procedure_bits::kLandmarkSeen;
    frames[2000].header.events |= lastEvent;
    const session::ExerciseKind& kind = **session::exerciseKind("urethra_insertion");
    session::MarkExtractor marks(4.0, 1, false, {}, nullptr, kind.sceneEvents());
    session::PlaybackTrack track;
    track.exercise = "urethra_insertion";
    track.toolCount = 1;
    for (const core::HapticFrame& frame : frames) {
        const double t_s = 1e-3 * static_cast<double>(frame.header.index);
        marks.add(frame, t_s);
        if (frame.header.index % 4 == 0) {
            track.moments.push_back(
                {t_s, frame.header.index, 0, frame.header.phase, frame.header.force, false});
            track.tools.emplace_back();
        }
    }
    track.marks = marks.take(2.0);
    session::PlaybackTrial trial;
    trial.end_s = 2.0;
    track.trials.push_back(trial);
    return track;
}

inline std::vector<session::PlaybackMark> ofKind(const session::PlaybackTrack& track,
                                                 const session::PlaybackMarkKind& kind) {
    std::vector<session::PlaybackMark> found;
    for (const session::PlaybackMark& mark : track.marks)
        if (mark.kind == kind)
            found.push_back(mark);
    return found;
}

} // namespace chiron::tests
