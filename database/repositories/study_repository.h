// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "database/connection.h"
#include "database/repositories/study_types.h"

#include <string>
#include <vector>

namespace chiron::database {

/// Writes studies: draft -> freeze -> enrol, consent, run, trials, questionnaires -> close. Only on the writer's connection.
/// Researchers design and run; only a study's author and administrators change its draft, freeze, close, archive or unblind it. The
/// simulated account may do all of it with studies of its own, whose participants are simulated ones. Everything but single trials is
/// audited. Failures name what was expected: badInput, wrongUse (not in this state), notAllowed, notFound, storage.
class StudyRepository {
public:
    StudyRepository(Connection& connection, Actor actor)
        : m_connection(connection), m_actor(std::move(actor)) {}

    /// A new draft of the actor; returns its number. `key`: the design's id, not yet taken by another person's study (simulated ones
    /// are apart). `designJson`: any JSON object, complete or not, at most 1 MiB; it is stored canonically.
    core::Result<StudyNumber> createStudy(const std::string& key, const std::string& title, const std::string& designJson);
    /// Replaces the design of a draft; the list's key stays, its title follows the design's English one. Failure: wrongUse once frozen.
    core::Result<void> saveDraft(StudyNumber study, const std::string& designJson);
    /// The design can never be changed again. It must read as a study (catalogue::readStudy) whose id is the key. Returns the SHA-256
    /// (64 hex digits) of its canonical JSON, which the audit chain keeps, too. Gives each condition its sealed code. Failure:
    /// badInput with every fault of the design, and where it blinds experimenters to what cannot be blinded (conditions in a fixed order,
    /// an apex beside other attributes); wrongUse when it is frozen already.
    core::Result<std::string> freezeStudy(StudyNumber study);
    /// No more participants and runs; open runs can still be finished. Failure: wrongUse unless frozen.
    core::Result<void> closeStudy(StudyNumber study);
    core::Result<void> setStudyArchived(StudyNumber study, bool archived); ///< out of the usual lists
    /// From now on conditions go by their names. Cannot be undone. `reason`: why, 1 to 500 characters, kept in the audit (no names: the audit is
    /// never overwritten). Failure: wrongUse for a draft, badInput without a reason.
    core::Result<void> unblindStudy(StudyNumber study, const std::string& reason);

    /// Gives a random code (three and three letters, none that look alike, unique over all studies) and the next free row of the order
    /// design (from 0; a withdrawn participant's row is given out again; simulated participants count by themselves). `identity`: free
    /// text, kept in the key table alone; `person`: the account, where there is one (0: none). `observer` not empty: a simulated
    /// participant, who has no key row; `wantedCode` may then name it (1 to 20 letters, digits, "-", "_"). Failure: wrongUse unless frozen;
    /// badInput when the person takes part already, or the code is taken in this study.
    core::Result<Participant> enrolParticipant(StudyNumber study, const std::string& identity, PersonId person,
                                               const std::string& observer, const std::string& wantedCode = {});
    /// Enrols somebody who has an account, by login name, so that their export and erasure reach what they do under the code. The link stands in the
    /// key table alone: no list, export or audit entry of the study says whose account it is. `identity` may be empty. Failure: as
    /// enrolParticipant; notFound where nobody has this login name. That somebody takes part already is said without their code.
    core::Result<Participant> enrolAccount(StudyNumber study, const std::string& identity, const std::string& account);
    /// `sha256`: of the consent text that was shown, UTF-8, one of the frozen design's languages. Failure: badInput for another text;
    /// wrongUse when given before or withdrawn.
    core::Result<void> recordConsent(ParticipantNumber participant, const std::string& sha256);
    core::Result<void> completeParticipant(ParticipantNumber participant);
    /// Takes no further part; open runs are stopped, what was recorded stays under the code. With `eraseRecordings` the participant's
    /// wish is kept that recordings go, too. The erasure itself (key, free texts, questionnaires, recordings) is an administrator's, by
    /// password: AccountService::eraseParticipant.
    core::Result<void> withdrawParticipant(ParticipantNumber participant, bool eraseRecordings);

    /// What it takes to run this condition (its id; while the study is blinded its sealed code) with this participant, or to go on with
    /// the open run: the condition, which whoever renders it must know. Of one condition at a time, and audited while the study is
    /// blinded. Failure: as beginRun; wrongUse when the condition is completed.
    core::Result<ConductedRun> conductRun(ParticipantNumber participant, const std::string& condition);
    /// Failure: wrongUse without consent (simulated excepted), withdrawn or completed, study not frozen, or with an open or completed
    /// run of this condition: an open one is resumed, a stopped one may be begun again.
    core::Result<StudyRunNumber> beginRun(const NewStudyRun& run);
    /// Trials of a run follow on from ordinal 0 without a gap; the session is the actor's own. Stored as answered, each by itself.
    core::Result<void> storeStudyTrial(const StudyTrial& trial);
    /// Ends an open run (completed or stopped) and seals its trials: a missing or added one shows in verify.
    core::Result<void> finishRun(StudyRunNumber run, StudyRunState state);
    /// Each question once for each participant, or where it is asked after each condition once for each of their completed runs
    /// (QuestionnaireAnswer::run). All or nothing. Failure: badInput for a questionnaire, item or language that the design has not, and for a
    /// run where none is expected, none where one is, or another's; wrongUse where the run is not completed, for an answer that is stored already, and without consent (simulated excepted; what is written down at the enrolment comes
    /// before it) or withdrawn.
    core::Result<void> storeQuestionnaireAnswers(const std::vector<QuestionnaireAnswer>& answers);

private:
    Connection& m_connection;
    Actor m_actor;
};

} // namespace chiron::database
