// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/command.h"
#include "cli/site_access.h"
#include "database/repositories/study_reader.h"
#include "session/study/study_runner.h"

#include <optional>

namespace chiron::cli {

/// The study that a run is asked of: of the database, or else of the content, to be frozen there once nothing is refused.
struct StudyToRun {
    psychophysics::StudyDesign design;
    std::optional<database::StudyRecord> stored; ///< none: of the content
};

/// `database`: null where there is none yet. Failure: notFound, notAllowed, storage.
core::Result<StudyToRun> findStudyToRun(database::Database* database, const database::Actor& actor, const QString& name);

/// Starts the window on this database, at this person's next trial of a study: who sits there logs in first. Failure: wrongUse without a
/// display; notFound, storage where the program does not start.
core::Result<CommandOutput> openSitting(const QString& database, const QString& study, const QString& person);

/// Whether the run would be done, as far as can be told without writing. Failure: wrongUse, notFound, badInput.
core::Result<void> mayBeRun(const StudyToRun& study, const session::StudyRunRequest& request);

struct ReadyToRun {
    database::StudyRecord study;
    database::Participant participant;
};

/// The study stored and frozen, the participant enrolled: both or neither. Failure: the repository's; wrongUse for a person.
core::Result<ReadyToRun> makeReady(database::Database& database, const database::Actor& actor, const StudyToRun& study, const session::StudyRunRequest& request);

} // namespace chiron::cli
