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

// What the repositories of studies have in common.
namespace chiron::database {

inline constexpr int kMaximumDesignBytes = 1 << 20;

std::string_view token(StudyState state) noexcept;
std::string_view token(ParticipantState state) noexcept;
std::string_view token(StudyRunState state) noexcept;
std::optional<StudyState> studyStateFromToken(std::string_view word) noexcept;
std::optional<ParticipantState> participantStateFromToken(std::string_view word) noexcept;
std::optional<StudyRunState> studyRunStateFromToken(std::string_view word) noexcept;

/// The actor may do this to (a part of) a study, on the writer's connection. Failure: wrongUse, notAllowed, notFound, storage.
core::Result<void> mayWriteStudy(Connection& connection, const Actor& actor, Action action, StudyPart part,
                                 std::int64_t number);

/// A study as its row has it.
struct StoredStudy {
    StudyNumber id = 0;
    std::string key;
    std::string state; ///< draft, frozen or closed
    std::string designJson;
};
core::Result<StoredStudy> storedStudy(Connection& connection, StudyNumber study);
/// Failure: wrongUse unless it is in this state ("frozen").
core::Result<StoredStudy> studyInState(Connection& connection, StudyNumber study, std::string_view state);

/// A participant as the row has it.
struct StoredParticipant {
    ParticipantNumber id = 0;
    StudyNumber study = 0;
    std::string code;
    ParticipantState state = ParticipantState::enrolled;
    bool simulated = false;
};
core::Result<StoredParticipant> storedParticipant(Connection& connection, ParticipantNumber participant);

/// Failure: wrongUse unless this participant may do a run now.
core::Result<void> mayRun(const StoredParticipant& who);
/// The condition of this sealed code; while the study is not blinded also of this id (by that, what is begun would tell its code).
/// Failure: badInput.
core::Result<SealedCondition> namedCondition(Connection& connection, const StoredStudy& study, const std::string& name);

/// A design as stored: read by its keys alone, so that a later program's stricter rules refuse no old study. Failure: badInput.
core::Result<QJsonObject> designObject(const std::string& json);
/// Ids of the conditions, in order.
std::vector<std::string> conditionIds(const QJsonObject& design);
/// SHA-256 (hex) of the consent in each language.
std::vector<std::string> consentDigests(const QJsonObject& design);
/// Whether this questionnaire is what is written down at the enrolment.
bool isEnrolment(const QJsonObject& design, const std::string& questionnaire);
/// Whether it is asked after each condition.
bool isOfConditions(const QJsonObject& design, const std::string& questionnaire);
/// Whether the design asks this and the answer is one it can have. Failure: badInput naming what was expected.
core::Result<void> checkAnswer(const QJsonObject& design, const QuestionnaireAnswer& answer);

/// Three and three letters and digits that do not look alike, from the system's generator: "K7M-4QX".
std::string randomCode();
/// Three of them, from a digest.
std::string codeFrom(const RowDigest& digest, int attempt);
/// 16 random bytes, hex.
std::string randomNonce();

/// What seals a run: a digest over the digests of its trials, in order. Failure: storage.
core::Result<RowDigest> runSeal(Connection& connection, StudyRunNumber run);

/// What seals the codes of a frozen study's conditions. Failure: storage.
core::Result<RowDigest> conditionSeal(Connection& connection, StudyNumber study);

/// Ends an open run with the seal of its trials and audits it. In the running transaction.
core::Result<void> endRun(Connection& connection, const Actor& actor, StudyRunNumber run, StudyRunState state);

} // namespace chiron::database
