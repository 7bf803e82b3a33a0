// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "curriculum/exercises/palpation/scoring/palpation_answer.h"
#include "scoring/trace.h"
#include "session/playback_track.h"
#include "modules/exercises/palpation/simulation/palpation_parameters.h"
#include "simulation/palpation/map_bands.h"
#include "simulation/palpation/surface_map.h"

#include <vector>

namespace chiron::session {

/// What became of one trial of a palpation. W, SI.
struct PalpationOutcome {
    int trial = 0; ///< from 0
    bool completed = false;
    bool timedOut = false;
    /// Truth, reports (times as PlaybackTrack's), findings at the end, what each found (`matches`), and the regions: what metrics
    /// judge. `scoring::findingsAfter(answer.reports, t_s)` is the book at any moment.
    scoring::PalpationAnswer answer;
};

/// One trial of a palpation, looked back at: what debrief, playback and report show.
struct PalpationTrialRecord : PalpationOutcome {
    simulation::SurfaceMap map; ///< of all presses of the trial
    double coverage = 0.0;      ///< as recorded at the trial's end, 0..1
};

/// An empty map as the scene has it at a trial's beginning; its bands for pictures.
simulation::SurfaceMap emptyMapOf(const simulation::PalpationParameters& level);
simulation::MapBands mapBandsOf(const simulation::PalpationParameters& level);

/// What the fingers of one trial pressed, from recorded poses and tissue forces: the normal part of each finger's force at the
/// surface point nearest to it, as the scene pressed its own map where the contact is `anchored`; of `p3_recast`, whose point is the
/// ray's, the cells may lie beside the scene's. Forces are stored in mN: a cell on the very edge may differ. Pauses
/// and what is no number are left out.
simulation::SurfaceMap mapOf(const simulation::PalpationParameters& level, const scoring::TrialTrace& trial);
/// The map of trial `trial` (from 0) as it was at `t_s`, from a track's samples (largest force of four ticks each).
simulation::SurfaceMap mapAt(const simulation::PalpationParameters& level, const PlaybackTrack& track, int trial, double t_s);

/// What became of each trial that was begun. Failure: badInput naming the trial, where its trace has no reports or no truth.
core::Result<std::vector<PalpationOutcome>> palpationOutcomes(const scoring::SessionTrace& trace);
/// One record per trial that was begun. Failure: as above.
core::Result<std::vector<PalpationTrialRecord>> palpationRecord(const scoring::SessionTrace& trace,
                                                                const simulation::PalpationParameters& level);

} // namespace chiron::session
