// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "database/connection.h"
#include "database/repositories/study_types.h"

#include <string>
#include <vector>

namespace chiron::database {

/// Writes studies: draft -> freeze -> enrol, consent, run, trials, questionnaires -> close. Only on the
/// writer's connection. Researchers design and run studies; only a study's author and administrators change
/// its draft, freeze, close, archive or unblind it. The simulated account may do all this with studies of its
/// own, whose participants are simulated. Everything except single trials is audited.
/// Errors: badInput, wrongUse (not in this state), notAllowed, notFound, storage; all name what was expected.
class StudyRepository {
public:
    StudyRepository(Connection& connection, Actor actor)
        : m_connection(connection), m_actor(std::move(actor)) {}

    /// Creates a draft of the actor and returns its number. `key`: the design's id, which no other person's
    /// study may have (simulated ones are separate). `designJson`: any JSON object, complete or not, of at
    /// most 1 MiB; it is stored canonically.
    core::Result<StudyNumber> createStudy(const std::string& key, const std::string& title,
                                          const std::string& designJson);
    /// Replaces the design of a draft. The key in the list does not change; the title becomes the design's
    /// English one.
    /// Errors: wrongUse once the study is frozen.
    core::Result<void> saveDraft(StudyNumber study, const std::string& designJson);
    /// Freezes the design, which can then never be changed again. It must read as a study
    /// (catalogue::readStudy) whose id is the key. Gives each condition its sealed code. Returns the SHA-256
    /// (64 hex digits) of the canonical JSON, which the audit chain stores, too.
    /// Errors: badInput naming every fault of the design, also if experimenters are to be blinded and this is
    /// impossible (conditions in a fixed order, or an apex together with other attributes); wrongUse if it is
    /// frozen already.
    core::Result<std::string> freezeStudy(StudyNumber study);
    /// Closes the study to further participants and runs; open runs can still be finished.
    /// Errors: wrongUse unless frozen.
    core::Result<void> closeStudy(StudyNumber study);
    core::Result<void> setStudyArchived(StudyNumber study, bool archived); ///< hides it from the usual lists
    /// Shows conditions by their names from now on; cannot be undone. `reason`: 1 to 500 characters, stored
    /// in the audit (it must contain no names, because the audit is never overwritten).
    /// Errors: wrongUse for a draft; badInput without a reason.
    core::Result<void> unblindStudy(StudyNumber study, const std::string& reason);

    /// Enrols a participant with a random code (two groups of three letters or digits that do not look alike,
    /// unique over all studies) and the next free row of the order design (from 0; the row of a withdrawn
    /// participant is assigned again; simulated participants are counted separately). `identity`: free text,
    /// stored only in the key table. `person`: the account (0: none). `observer` not empty: a simulated
    /// participant, who has no key row; `wantedCode` may then give the code (1 to 20 letters, digits, "-",
    /// "_").
    /// Errors: wrongUse unless frozen; badInput if the person takes part already, or the code is taken in
    /// this study.
    core::Result<Participant> enrolParticipant(StudyNumber study, const std::string& identity,
                                               PersonId person, const std::string& observer,
                                               const std::string& wantedCode = {});
    /// Enrols a person with an account, by login name, so that their export and erasure include what they do
    /// under the code. The link is stored only in the key table: no list, export or audit entry of the study
    /// says whose account it is. `identity` may be empty.
    /// Errors: as enrolParticipant (a person who takes part already is reported without their code); notFound
    /// if nobody has this login name.
    core::Result<Participant> enrolAccount(StudyNumber study, const std::string& identity,
                                           const std::string& account);
    /// Records the consent. `sha256` is that of the consent text that was shown, in UTF-8, in one of the
    /// frozen design's languages.
    /// Errors: badInput for another text; wrongUse if consent was given before or the participant has
    /// withdrawn.
    core::Result<void> recordConsent(ParticipantNumber participant, const std::string& sha256);
    core::Result<void> completeParticipant(ParticipantNumber participant);
    /// Ends the participation. Open runs are stopped, and recorded data remains under the code.
    /// `eraseRecordings` stores the participant's wish that recordings are erased, too. An administrator does
    /// the erasure itself (key, free texts, questionnaires, recordings), with their password:
    /// AccountService::eraseParticipant.
    core::Result<void> withdrawParticipant(ParticipantNumber participant, bool eraseRecordings);

    /// Returns what is needed to run this condition with this participant, or to continue the open run,
    /// including the condition itself, which the rendering needs. `condition` is its id or, while the study
    /// is blinded, its sealed code. Only one condition is revealed at a time, and this is audited while the
    /// study is blinded.
    /// Errors: as beginRun; wrongUse if the condition is completed.
    core::Result<ConductedRun> conductRun(ParticipantNumber participant, const std::string& condition);
    /// Begins a run. An open run is resumed instead; after a stopped one a new run may be begun.
    /// Errors: wrongUse without consent (except simulated participants), if the participant has withdrawn or
    /// completed, if the study is not frozen, or if there is an open or completed run of this condition.
    core::Result<StudyRunNumber> beginRun(const NewStudyRun& run);
    /// Stores one trial, as soon as it is answered. The trials of a run follow one another from ordinal 0
    /// without a gap; the session must be the actor's own.
    core::Result<void> storeStudyTrial(const StudyTrial& trial);
    /// Ends an open run (completed or stopped) and seals its trials, so that verify reveals a missing or
    /// added one.
    core::Result<void> finishRun(StudyRunNumber run, StudyRunState state);
    /// Stores answers, all or nothing. Each question is answered once per participant or, if it is asked
    /// after each condition, once per completed run (QuestionnaireAnswer::run).
    /// Errors: badInput for a questionnaire, item or language that the design does not have, and for a run
    /// where none is expected, no run where one is expected, or another participant's run; wrongUse if the
    /// run is not completed, for an answer that is stored already, without consent (except for simulated
    /// participants, and for enrolment questionnaires, which precede it), or after withdrawal.
    core::Result<void> storeQuestionnaireAnswers(const std::vector<QuestionnaireAnswer>& answers);

private:
    Connection& m_connection;
    Actor m_actor;
};

} // namespace chiron::database
