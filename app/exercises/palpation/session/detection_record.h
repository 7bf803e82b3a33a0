// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/exercise.h"
#include "core/result.h"
#include "database/repositories/session_reader.h"
#include "curriculum/exercises/palpation/scoring/roc_curve.h"
#include "session/session_view.h"

#include <string>

namespace chiron::session {

/// Which sessions of palpation are pooled: completed ones of one person and device class, no familiarisation.
struct DetectionQuery {
    database::PersonId person = 0;
    int level = 0;            ///< 0: all levels, however hard, whose lumps are hidden
    bool felt = true;         ///< device class: felt and shown are never pooled
    std::string operatorName; ///< empty: the person's own hand
};

/// A person's detection over sessions.
struct PooledDetection {
    int sessions = 0;
    int trials = 0;
    int unjudged = 0; ///< trials whose recording does not tell all reports, or the truth: left out
    scoring::RatingCounts ratings;

    core::DetectionCounts counts() const noexcept { return ratings.counts(); }
};

/// Whether sessions of this level tell how well lumps are felt: not where a research control acts, and for `level` 0 not where the lumps
/// are drawn. Pure.
bool tellsDetection(const catalogue::ExerciseLevel& level, const DetectionQuery& query);

/// Opens each session that `actor` may see and judges its trials from the recording (`scoring::judgePalpation`): about a second a
/// session of ten minutes, so on a worker. Failure: the reader's; cancelled.
core::Result<PooledDetection> detectionOf(database::Connection& connection, const database::Actor& actor, const DetectionQuery& query,
                                          const ReadProgress& progress = {});

/// Adds a session's trials.
void addDetection(PooledDetection& pooled, const scoring::SessionTrace& trace);

} // namespace chiron::session
