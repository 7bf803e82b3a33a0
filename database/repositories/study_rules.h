// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "database/access/action.h"
#include "database/access/authorise.h"
#include "database/connection.h"
#include "database/integrity/row_digest.h"
#include "database/repositories/study_types.h"

#include <QJsonObject>
#include <optional>
#include <string>
#include <vector>

// Functions that the repositories of studies share.
namespace chiron::database {

inline constexpr int kMaximumDesignBytes = 1 << 20;

std::string_view token(StudyState state) noexcept;
std::string_view token(ParticipantState state) noexcept;
std::string_view token(StudyRunState state) noexcept;
std::optional<StudyState> studyStateFromToken(std::string_view word) noexcept;
std::optional<ParticipantState> participantStateFromToken(std::string_view word) noexcept;
std::optional<StudyRunState> studyRunStateFromToken(std::string_view word) noexcept;

/// Checks that the actor may do this to (a part of) a study, on the writer's connection.
/// Errors: wrongUse, notAllowed, notFound, storage.
core::Result<void> mayWriteStudy(Connection& connection, const Actor& actor, Action action, StudyPart part,
                                 std::int64_t number);

/// A study as stored in its row.
struct StoredStudy {
    StudyNumber id = 0;
    std::string key;
    std::string state; ///< draft, frozen or closed
    std::string designJson;
};
core::Result<StoredStudy> storedStudy(Connection& connection, StudyNumber study);
/// Errors: wrongUse unless the study is in this state ("frozen").
core::Result<StoredStudy> studyInState(Connection& connection, StudyNumber study, std::string_view state);

/// A participant as stored in the row.
struct StoredParticipant {
    ParticipantNumber id = 0;
    StudyNumber study = 0;
    std::string code;
    ParticipantState state = ParticipantState::enrolled;
    bool simulated = false;
};
core::Result<StoredParticipant> storedParticipant(Connection& connection, ParticipantNumber participant);

/// Errors: wrongUse unless this participant may do a run now.
core::Result<void> mayRun(const StoredParticipant& who);
/// Returns the condition with this sealed code or, if the study is not blinded, with this id (in a blinded
/// study, beginning by id would reveal the code).
/// Errors: badInput.
core::Result<SealedCondition> namedCondition(Connection& connection, const StoredStudy& study,
                                             const std::string& name);

/// Returns a stored design. It is read only by its keys, so that a later program's stricter rules refuse no
/// old study.
/// Errors: badInput.
core::Result<QJsonObject> designObject(const std::string& json);
/// Returns the ids of the conditions, in order.
std::vector<std::string> conditionIds(const QJsonObject& design);
/// Returns the SHA-256 (hex) of the consent in each language.
std::vector<std::string> consentDigests(const QJsonObject& design);
/// Returns whether this questionnaire is filled in at the enrolment.
bool isEnrolment(const QJsonObject& design, const std::string& questionnaire);
/// Returns whether it is asked after each condition.
bool isOfConditions(const QJsonObject& design, const std::string& questionnaire);
/// Checks that the design asks this question and that the answer is a possible one.
/// Errors: badInput naming what was expected.
core::Result<void> checkAnswer(const QJsonObject& design, const QuestionnaireAnswer& answer);

/// Returns two groups of three letters or digits that do not look alike, from the system's random generator:
/// "K7M-4QX".
std::string randomCode();
/// Returns three such symbols, derived from a digest.
std::string codeFrom(const RowDigest& digest, int attempt);
/// Returns 16 random bytes as hex.
std::string randomNonce();

/// Returns the seal of a run: a digest over the digests of its trials, in order.
/// Errors: storage.
core::Result<RowDigest> runSeal(Connection& connection, StudyRunNumber run);

/// Returns the seal of the codes of a frozen study's conditions.
/// Errors: storage.
core::Result<RowDigest> conditionSeal(Connection& connection, StudyNumber study);

/// Ends an open run with the seal of its trials and audits it, in the running transaction.
core::Result<void> endRun(Connection& connection, const Actor& actor, StudyRunNumber run,
                          StudyRunState state);

} // namespace chiron::database
