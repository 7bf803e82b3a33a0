// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "database/accounts/person.h"
#include "database/connection.h"
#include "database/privacy/erasure.h"
#include "database/repositories/audit_repository.h"
#include "database/repositories/session_types.h"
#include "database/repositories/study_types.h"
#include "scoring/score_card.h"

#include <optional>
#include <string>
#include <vector>

namespace chiron::database {

/// Everything held about one person in one session.
struct PersonSession {
    SessionRecord record;
    std::vector<TrialRecord> trials;
    std::vector<EventRecord> events;
    std::vector<SessionComment> comments;
    std::optional<scoring::ScoreCard> scores;
    bool sealed = false; ///< a sitting of a blinded study: listed, without content, trials, events and scores, until it is unblinded
};

/// What is held of somebody as a participant of a study.
struct PersonParticipation {
    std::string studyKey;
    std::string studyTitle;
    Participant participant;
    std::string identity; ///< as the key table has it
    std::vector<StudyRun> runs;
    std::vector<StudyTrial> trials; ///< of all runs; none while `sealed`
    bool sealed = false; ///< the study is blinded: trials are handed out once it is not, or to the participant, who is done with it (participations.h)
    std::vector<QuestionnaireAnswer> answers;
};

/// Everything held about one person. Samples are exported per session (recording reader); credentials are
/// secrets, only their presence is told.
struct PersonExport {
    Person person;
    std::vector<EarlierName> earlierNames;
    std::vector<PersonSession> sessions;
    std::vector<SessionComment> commentsWritten; ///< on anybody's sessions
    std::vector<AuditEntry> audit;               ///< by or about them; what ended sittings and runs of a blinded study without its time
    bool hasPassword = false;
    int failedLogins = 0;
    std::vector<PersonParticipation> participations; ///< where a study's key table names this account
};

/// What the law gives a person: a copy, and oblivion.
class PrivacyRepository {
public:
    PrivacyRepository(Connection& connection, Actor actor)
        : m_connection(connection), m_actor(std::move(actor)) {}

    core::Result<PersonExport> exportPerson(PersonId person);
    /// Overwrites identity, code, credentials and free texts (and recordings if asked) and leaves a
    /// tombstone. The caller confirms the password and VACUUMs afterwards (AccountService::erasePerson).
    /// Of somebody who is erased already it returns the tombstone as it stands, so that what did not follow
    /// (list, VACUUM) can be done again; recordings can still be withdrawn.
    /// Failure: wrongUse for the simulated account, oneself, the last administrator or a running session.
    core::Result<Erasure> erasePerson(PersonId person, const std::string& reason, bool withdrawRecordings);
    /// Overwrites who a participant of a study was and all answers to questionnaires, and the recordings where
    /// the participant wished so at withdrawal; leaves a tombstone. The caller confirms the password and VACUUMs
    /// (AccountService::eraseParticipant). An erased one can be erased again. Failure: wrongUse for a simulated one,
    /// one who has not withdrawn, or while a session of theirs runs.
    core::Result<Erasure> eraseParticipant(ParticipantNumber participant, const std::string& reason);
    core::Result<std::vector<Erasure>> listErasures();

private:
    Connection& m_connection;
    Actor m_actor;
};

} // namespace chiron::database
