// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/command_spec.h"
#include "cli/site_access.h"
#include "database/repositories/study_reader.h"
#include "session/study/study_runner.h"

#include <optional>

namespace chiron::cli {

/// The study of a requested run: one of the database, or else one of the content, which is frozen in the
/// database once all checks have passed.
struct StudyToRun {
    psychophysics::StudyDesign design;
    std::optional<database::StudyRecord> stored; ///< empty: the study comes from the content
};

/// Finds the study. `database` is null if there is none yet.
/// Errors: notFound, notAllowed, storage.
core::Result<StudyToRun> findStudyToRun(database::Database* database, const database::Actor& actor,
                                        const QString& name);

/// Starts the desktop program on this database, at this participant's next trial of a study; the user logs in
/// first.
/// Errors: wrongUse without a display; notFound, storage if the program does not start.
core::Result<CommandOutput> openSitting(const QString& database, const QString& study, const QString& person);

/// Checks whether the run can be done, as far as this can be determined without writing.
/// Errors: wrongUse, notFound, badInput.
core::Result<void> mayBeRun(const StudyToRun& study, const session::StudyRunRequest& request);

struct ReadyToRun {
    database::StudyRecord study;
    database::Participant participant;
};

/// Stores and freezes the study and enrols the participant, in one transaction.
/// Errors: those of the repository; wrongUse if the participant is a person.
core::Result<ReadyToRun> makeReady(database::Database& database, const database::Actor& actor,
                                   const StudyToRun& study, const session::StudyRunRequest& request);

} // namespace chiron::cli
