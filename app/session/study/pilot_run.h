// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "database/database.h"
#include "database/repositories/study_types.h"
#include "psychophysics/study/study_design.h"

#include <string>

namespace chiron::session {

/// A draft that a person is about to try: a frozen copy of it, marked as a pilot, with one participant.
struct PilotRun {
    database::StudyNumber study = 0;
    std::string participantCode;
};

/// The design of a pilot: an unchanged copy of the draft, except that it has its own key and title, is marked
/// (`pilotOf`), and is not blind for the experimenter, who wants to learn from it.
psychophysics::StudyDesign pilotDesign(const psychophysics::StudyDesign& draft, const std::string& key);

/// Creates everything that a pilot run of the draft needs, in one transaction: the frozen copy, and a
/// participant who has agreed to the consent text in `language` (English if there is none). Pilots never
/// appear in lists of studies, nor in runs, analyses or exports of the study itself. `who`: free text, stored
/// only in the key table.
/// Errors: those of the repository (badInput if the draft cannot be read).
core::Result<PilotRun> beginPilot(database::Database& database, const database::Actor& actor,
                                  const psychophysics::StudyDesign& draft, const std::string& who,
                                  const std::string& language);

} // namespace chiron::session
