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

// What the lists of a blinded study omit until it is unblinded: the condition, and everything that only one
// of the conditions can have.
namespace chiron::database {

/// Returns the blinding of a stored design, which is read only by its keys.
/// Errors: badInput.
core::Result<Blinding> blindingOf(const std::string& designJson, bool unblinded);
/// Returns the blinding of the study to which this belongs.
/// Errors: notFound, storage, badInput.
core::Result<Blinding> blindingOf(Connection& connection, StudyPart part, std::int64_t number);

/// Returns the run without its condition while the study is blinded. If the conditions differ, the source of
/// its presentations is removed, too.
StudyRun sealed(StudyRun run, const Blinding& blinding);

/// Does the same for an answer that was given after a condition. An answer that is given only once is
/// unchanged.
QuestionnaireAnswer sealed(QuestionnaireAnswer answer, const Blinding& blinding);

/// Returns why a trial is spoiled; "withheld" while the study is blinded, if the reason depends on forces in
/// which the conditions differ.
std::string shownReason(const std::string& spoiled, const Blinding& blinding);

/// Return rows as they appear in lists. The caller checks beforehand who may read them. While a study is
/// blinded and its conditions differ, no trial of a run is shown: answers, times, speeds, counts of contacts
/// and the number of trials could each distinguish the conditions.
core::Result<std::vector<StudyRun>> shownRuns(Connection& connection, ParticipantNumber participant);
core::Result<std::vector<StudyTrial>> shownTrials(Connection& connection, StudyRunNumber run);
core::Result<std::vector<QuestionnaireAnswer>> shownAnswers(Connection& connection, StudyNumber study);
/// Returns the figures by which quality can be monitored instead; by participant, in the order of enrolment.
core::Result<std::vector<ParticipantQuality>> qualityRows(Connection& connection, StudyNumber study);

/// Returns whether this is a session of a blinded study. Its content and its recording reveal the condition,
/// so they are closed to everybody. Such a session is recognised by its trials and, before the first of them,
/// by its level's title, "study / sealed code". Returns false for maintenance, because the program itself
/// ends, recovers and verifies its recordings.
core::Result<bool> isSealedSitting(Connection& connection, const Actor& actor, SessionId session);
/// Returns all such sessions, by the same rule.
core::Result<std::set<SessionId>> sealedSittings(Connection& connection, const Actor& actor);
/// Errors: notAllowed if it is such a session.
core::Result<void> mayOpenSitting(Connection& connection, const Actor& actor, SessionId session);

} // namespace chiron::database
