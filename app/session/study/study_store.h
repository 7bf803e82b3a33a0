// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "database/database.h"
#include "database/repositories/study_types.h"
#include "psychophysics/study/study_design.h"

#include <optional>
#include <string>
#include <vector>

namespace chiron::session {

/// What a sitting needs of the database: study, participant, the run that is to be begun or gone on with.
struct OpenedStudy {
    database::StudyRecord record;
    psychophysics::StudyDesign design;
    database::Participant participant;
    std::vector<database::StudyRun> runs; ///< of the participant, in the order begun
    std::vector<std::string> order;       ///< conditions in the participant's order
};

/// Failure: notFound, notAllowed, wrongUse (a draft), badInput.
core::Result<OpenedStudy> openStudy(database::Database& database, const database::Actor& actor, database::StudyNumber study,
                                    const std::string& participantCode);
/// The conditions that are still to be done, in order.
std::vector<std::string> openConditions(const OpenedStudy& study);
/// What a sitting's session calls the condition of a run: its sealed code while the experimenter is blind, else empty (its own id).
std::string sessionLabel(const OpenedStudy& study, const std::string& sealedCode);
/// Failure: wrongUse, where the device renders less than the one the run was begun on: its later trials would be of another table.
core::Result<void> sameTable(const database::StudyRun& run, double limit);
/// The open run of a condition; nothing where it was not begun.
std::optional<database::StudyRun> openRun(const OpenedStudy& study, const std::string& condition);

core::Result<std::vector<database::StudyTrial>> trialsOf(database::Database& database, const database::Actor& actor,
                                                         database::StudyRunNumber run);
/// Begins a run of a condition and gives it as it was stored. `procedures`: StudyProgress::procedureIds().
core::Result<database::StudyRun> beginRun(database::Database& database, const database::Actor& actor, const OpenedStudy& study,
                                          const std::string& condition, std::uint64_t seed, const std::string& procedures);
core::Result<void> storeTrial(database::Database& database, const database::Actor& actor, const database::StudyTrial& trial);
/// Ends the run, and the participant with its last condition.
core::Result<void> finishRun(database::Database& database, const database::Actor& actor, const OpenedStudy& study,
                             database::StudyRunNumber run);
/// Of a run that is begun: from the study's seed, the participant's row and the condition, so that it is known before.
std::uint64_t runSeed(const OpenedStudy& study, const std::string& condition);

} // namespace chiron::session
