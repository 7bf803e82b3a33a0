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

/// All data about one person in one session.
struct PersonSession {
    SessionRecord record;
    std::vector<TrialRecord> trials;
    std::vector<EventRecord> events;
    std::vector<SessionComment> comments;
    std::optional<scoring::ScoreCard> scores;
    /// A session of a blinded study: listed without content, trials, events and scores until the study is
    /// unblinded.
    bool sealed = false;
};

/// The data about a person as a participant of a study.
struct PersonParticipation {
    std::string studyKey;
    std::string studyTitle;
    Participant participant;
    std::string identity; ///< as in the key table
    std::vector<StudyRun> runs;
    std::vector<StudyTrial> trials; ///< of all runs; none while `sealed`
    /// The study is blinded. Trials are included after unblinding, or for participants who are done with the
    /// study (participations.h).
    bool sealed = false;
    std::vector<QuestionnaireAnswer> answers;
};

/// All data about one person. Samples are exported per session (recording reader). Credentials are secret, so
/// only their presence is stated.
struct PersonExport {
    Person person;
    std::vector<EarlierName> earlierNames;
    std::vector<PersonSession> sessions;
    std::vector<SessionComment> commentsWritten; ///< on any person's sessions
    /// Entries by or about the person; those that ended sessions and runs of a blinded study have no time.
    std::vector<AuditEntry> audit;
    bool hasPassword = false;
    int failedLogins = 0;
    std::vector<PersonParticipation> participations; ///< participations whose key names this account
};

/// Fulfils people's legal rights: a copy of their data, and erasure.
class PrivacyRepository {
public:
    PrivacyRepository(Connection& connection, Actor actor)
        : m_connection(connection), m_actor(std::move(actor)) {}

    core::Result<PersonExport> exportPerson(PersonId person);
    /// Overwrites identity, code, credentials and free texts (and recordings if requested) and leaves a
    /// tombstone. The caller confirms the password and runs VACUUM afterwards (AccountService::erasePerson).
    /// For a person who is erased already it returns the existing tombstone, so that the steps that were not
    /// done (list, VACUUM) can be repeated; recordings can still be withdrawn.
    /// Errors: wrongUse for the simulated account, oneself, the last administrator or a running session.
    core::Result<Erasure> erasePerson(PersonId person, const std::string& reason, bool withdrawRecordings);
    /// Overwrites the identity of a participant of a study and all answers to questionnaires, and the
    /// recordings if the participant wished so at withdrawal; leaves a tombstone. The caller confirms the
    /// password and runs VACUUM (AccountService::eraseParticipant). A participant can be erased again.
    /// Errors: wrongUse for a simulated participant, for one who has not withdrawn, or while a session of
    /// theirs is running.
    core::Result<Erasure> eraseParticipant(ParticipantNumber participant, const std::string& reason);
    core::Result<std::vector<Erasure>> listErasures();

private:
    Connection& m_connection;
    Actor m_actor;
};

} // namespace chiron::database
