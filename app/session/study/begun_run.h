// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "session/study/live_sitting.h"
#include "session/study/study_progress.h"
#include "session/study/study_store.h"

#include <string>

namespace chiron::session {

/// A sitting that is allowed: whose, at what, and what was stored of it before.
struct ConductedSitting {
    OpenedStudy study;
    std::string label;          ///< what the condition goes by
    database::ConductedRun run; ///< with the condition itself

    /// Null where the design has none of this id.
    const psychophysics::Condition* condition() const;
};
/// The label that is asked for (empty: the next one), still to be done. Failure: openStudy's, conduct's, wrongUse (completed; no device),
/// notFound.
core::Result<ConductedSitting> conductSitting(database::Database& database, const database::Actor& actor, const LiveStudyRequest& request);

/// A run with its procedures where it was left, or at its beginning.
struct BegunRun {
    database::StudyRunNumber number = 0;
    std::uint64_t seed = 0;
    StudyProgress progress;
};
/// `limit`: the largest difference that the device renders. Failure: wrongUse (begun on a device that renders more), badInput (it renders
/// none), storage.
SittingResult<BegunRun> beginOrGoOn(database::Database& database, const database::Actor& actor, const ConductedSitting& sitting, double limit);
/// The error without the condition's name where experimenters are blind; typed as it was.
SittingError sealed(const ConductedSitting& sitting, SittingError error);

} // namespace chiron::session
