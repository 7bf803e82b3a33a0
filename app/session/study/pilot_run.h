// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "database/database.h"
#include "database/repositories/study_types.h"
#include "psychophysics/study/study_design.h"

#include <string>

namespace chiron::session {

/// A draft that a person is about to try: a frozen copy of it, marked, with one participant.
struct PilotRun {
    database::StudyNumber study = 0;
    std::string participantCode;
};

/// The design of a pilot: the draft as it is, under a key and a title of its own, marked (`pilotOf`), and not blind for the experimenter,
/// who is the one to learn from it.
psychophysics::StudyDesign pilotDesign(const psychophysics::StudyDesign& draft, const std::string& key);

/// Makes all that a sitting of the draft takes, in one transaction: the copy, frozen, and a participant who has agreed to the consent text
/// in `language` (English where there is none). No list of studies, no run, analysis or export of the study itself ever holds a pilot.
/// `who`: free text, kept in the key table alone. Failure: the repository's (badInput where the draft does not read).
core::Result<PilotRun> beginPilot(database::Database& database, const database::Actor& actor, const psychophysics::StudyDesign& draft,
                                  const std::string& who, const std::string& language);

} // namespace chiron::session
