// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "session/study/live_sitting.h"
#include "session/study/study_progress.h"
#include "session/study/study_store.h"

#include <string>

namespace chiron::session {

/// A permitted request to do a run: the participant, the condition, and the stored part of the run.
struct ConductedSitting {
    OpenedStudy study;
    std::string label;          ///< the condition's label
    database::ConductedRun run; ///< includes the condition itself

    /// Null if the design has no condition with this id.
    const psychophysics::Condition* condition() const;
};
/// Resolves the requested condition (empty: the next one), which must not be completed.
/// Errors: those of openStudy and conduct; wrongUse (completed; no device); notFound.
core::Result<ConductedSitting> conductSitting(database::Database& database, const database::Actor& actor,
                                              const LiveStudyRequest& request);

/// A run with its procedures, at the beginning or where it was left.
struct BegunRun {
    database::StudyRunNumber number = 0;
    std::uint64_t seed = 0;
    StudyProgress progress;
};
/// Begins or resumes a run. `limit`: the largest difference that the device renders.
/// Errors: wrongUse (begun on a device that renders more), badInput (it renders none), storage.
SittingResult<BegunRun> beginOrGoOn(database::Database& database, const database::Actor& actor,
                                    const ConductedSitting& sitting, double limit);
/// The error without the condition's name if experimenters are blind; its type is preserved.
SittingError sealed(const ConductedSitting& sitting, SittingError error);

} // namespace chiron::session
