// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/exercise.h"
#include "core/result.h"
#include "curriculum/exercises/palpation/scoring/roc_curve.h"
#include "database/repositories/session_reader.h"
#include "session/session_view.h"

#include <string>

namespace chiron::session {

/// The palpation sessions to pool: completed ones of one person and one device class, without
/// familiarisation.
struct DetectionQuery {
    database::PersonId person = 0;
    int level = 0;            ///< 0: all levels whose lumps are hidden, whatever their difficulty
    bool felt = true;         ///< device class: felt and shown are never pooled
    std::string operatorName; ///< empty: sessions done by the person's own hand
};

/// A person's detection results pooled over sessions.
struct PooledDetection {
    int sessions = 0;
    int trials = 0;
    int unjudged = 0; ///< trials left out because their recording lacks reports or the truth
    scoring::RatingCounts ratings;

    core::DetectionCounts counts() const noexcept { return ratings.counts(); }
};

/// True if sessions of this level measure how well lumps are felt. False for levels with a research control,
/// and, if `level` is 0, for levels that draw the lumps. Pure function.
bool tellsDetection(const catalogue::ExerciseLevel& level, const DetectionQuery& query);

/// Opens each session that `actor` may see and judges its trials from the recording
/// (`scoring::judgePalpation`). Takes about one second for a session of ten minutes, so call it on a worker.
/// Errors: those of the reader; cancelled.
core::Result<PooledDetection> detectionOf(database::Connection& connection, const database::Actor& actor,
                                          const DetectionQuery& query, const ReadProgress& progress = {});

/// Adds a session's trials.
void addDetection(PooledDetection& pooled, const scoring::SessionTrace& trace);

} // namespace chiron::session
