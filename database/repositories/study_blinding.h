// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "database/access/authorise.h"
#include "database/connection.h"
#include "database/repositories/study_types.h"

#include <cstdint>
#include <set>
#include <string>
#include <vector>

// What a blinded study's lists leave out until it is unblinded: the condition, and what only one of the conditions can have.
namespace chiron::database {

/// Of a design as stored; read by its keys alone. Failure: badInput.
core::Result<Blinding> blindingOf(const std::string& designJson, bool unblinded);
/// Of the study that this belongs to. Failure: notFound, storage, badInput.
core::Result<Blinding> blindingOf(Connection& connection, StudyPart part, std::int64_t number);

/// Without the condition while blinded. Where conditions differ, also without what chose its presentations.
StudyRun sealed(StudyRun run, const Blinding& blinding);

/// The same of an answer that was given after a condition; of one that was given once nothing is left out.
QuestionnaireAnswer sealed(QuestionnaireAnswer answer, const Blinding& blinding);

/// Why a trial is spoiled; "withheld" while blinded where the reason comes of forces that conditions differ in.
std::string shownReason(const std::string& spoiled, const Blinding& blinding);

/// Rows as lists give them. Who may read them is asked before. While a blinded study's conditions differ no trial of a run is shown: answers,
/// times, speeds, counts of contacts and how many trials there were are each a way to tell the conditions apart.
core::Result<std::vector<StudyRun>> shownRuns(Connection& connection, ParticipantNumber participant);
core::Result<std::vector<StudyTrial>> shownTrials(Connection& connection, StudyRunNumber run);
core::Result<std::vector<QuestionnaireAnswer>> shownAnswers(Connection& connection, StudyNumber study);
/// What quality can be watched by instead; by participant, in the order enrolled.
core::Result<std::vector<ParticipantQuality>> qualityRows(Connection& connection, StudyNumber study);

/// Whether a session is a sitting of a blinded study: its content and its recording are the condition in numbers, so they are closed to
/// everybody. Known by its trials, and before the first of them by its level's title, "study / sealed code". False for maintenance: the
/// program itself ends, recovers and verifies what it recorded.
core::Result<bool> isSealedSitting(Connection& connection, const Actor& actor, SessionId session);
/// All of them, by the same rule.
core::Result<std::set<SessionId>> sealedSittings(Connection& connection, const Actor& actor);
/// Failure: notAllowed where it is one.
core::Result<void> mayOpenSitting(Connection& connection, const Actor& actor, SessionId session);

} // namespace chiron::database
