// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "curriculum/exercises/palpation/scoring/palpation_answer.h"
#include "modules/exercises/palpation/simulation/palpation_parameters.h"
#include "scoring/trace.h"
#include "session/playback_track.h"
#include "simulation/palpation/map_bands.h"
#include "simulation/palpation/surface_map.h"

#include <vector>

namespace chiron::session {

/// The outcome of one palpation trial.
/// Unit: SI.
/// Frame: W.
struct PalpationOutcome {
    int trial = 0; ///< from 0
    bool completed = false;
    bool timedOut = false;
    /// Truth, reports (on PlaybackTrack's time), findings at the end, the lump that each matched (`matches`),
    /// and the regions: the input of the metrics. `scoring::findingsAfter(answer.reports, t_s)` gives the
    /// findings at any moment.
    scoring::PalpationAnswer answer;
};

/// One palpation trial in review: the data for debrief, playback and report.
struct PalpationTrialRecord : PalpationOutcome {
    simulation::SurfaceMap map; ///< of all presses of the trial
    double coverage = 0.0;      ///< as recorded at the trial's end, 0..1
};

/// An empty map like the scene's at the beginning of a trial, and the bands for pictures of it.
simulation::SurfaceMap emptyMapOf(const simulation::PalpationParameters& level);
simulation::MapBands mapBandsOf(const simulation::PalpationParameters& level);

/// The map of the presses of one trial, from recorded poses and tissue forces: the normal part of each
/// finger's force at the surface point nearest to it. It equals the scene's own map if the contact is
/// `anchored`; under `p3_recast`, whose contact point is the ray's, the cells may lie beside the scene's.
/// Forces are stored in mN, so a cell exactly at a threshold may differ. Pauses and non-finite values are
/// skipped.
simulation::SurfaceMap mapOf(const simulation::PalpationParameters& level, const scoring::TrialTrace& trial);
/// The map of trial `trial` (from 0) at time `t_s`, from a track's samples (each the largest force of four
/// ticks).
simulation::SurfaceMap mapAt(const simulation::PalpationParameters& level, const PlaybackTrack& track,
                             int trial, double t_s);

/// The outcome of each trial that was started.
/// Errors: badInput naming the trial whose trace has no reports or no truth.
core::Result<std::vector<PalpationOutcome>> palpationOutcomes(const scoring::SessionTrace& trace);
/// One record for each trial that was started.
/// Errors: those of palpationOutcomes().
core::Result<std::vector<PalpationTrialRecord>> palpationRecord(const scoring::SessionTrace& trace,
                                                                const simulation::PalpationParameters& level);

} // namespace chiron::session
