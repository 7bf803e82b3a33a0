// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "database/connection.h"
#include "database/repositories/study_types.h"

#include <string>
#include <vector>

namespace chiron::database {

/// Reads studies, on any connection except for participantKeys and sealedConditions. Researchers and
/// administrators read all of them, by codes. Without a login, and for the simulated account, only the
/// simulated account's studies can be read.
/// Errors: notAllowed, notFound, storage.
class StudyReader {
public:
    StudyReader(Connection& connection, Actor actor) : m_connection(connection), m_actor(std::move(actor)) {}

    /// Returns the studies by number, without pilots. Every choice of a study to run, analyse or export uses
    /// this list.
    core::Result<std::vector<StudySummary>> listStudies(bool includeArchived = false);
    /// Returns the pilots of the study with this key, by number.
    core::Result<std::vector<StudySummary>> listPilots(const std::string& key);
    /// Returns a study. If it is frozen and blinded, the design is masked for readers who may not look up
    /// which code is which (sealedConditions).
    core::Result<StudyRecord> study(StudyNumber study);
    /// Returns the study of this key that the actor may read: a person's study before the simulated
    /// account's. Actors who may read only simulated ones get that one.
    core::Result<StudyRecord> studyByKey(const std::string& key);
    /// Returns the conditions of a frozen study; empty for a draft. While the study is blinded: codes without
    /// conditions, ordered by code. A design that blinds keeps that order when it is unblinded, so that
    /// nobody's order of conditions changes. Other studies: in the design's order.
    core::Result<std::vector<SealedCondition>> conditionCodes(StudyNumber study);
    /// Returns which code is which condition, in the design's order; only for the study's author and
    /// administrators. The access is audited, so it needs a writer's job, as participantKeys does.
    core::Result<std::vector<SealedCondition>> sealedConditions(StudyNumber study);
    core::Result<std::vector<Participant>> participants(StudyNumber study);
    /// Upper or lower case and "-" are ignored.
    core::Result<Participant> participantByCode(StudyNumber study, const std::string& code);
    /// Returns the runs in the order in which they were begun. While the study is blinded, everybody gets
    /// sealed codes without conditions.
    core::Result<std::vector<StudyRun>> runs(ParticipantNumber participant);
    /// By ordinal; none while the study is blinded, if its conditions differ (study_blinding.h).
    core::Result<std::vector<StudyTrial>> studyTrials(StudyRunNumber run);
    /// By participant, in the order of enrolment; also while the study is blinded.
    core::Result<std::vector<ParticipantQuality>> trialQuality(StudyNumber study);
    /// While the study is blinded, answers about conditions have sealed codes, and are withheld if the
    /// conditions differ.
    core::Result<std::vector<QuestionnaireAnswer>> questionnaireAnswers(StudyNumber study);
    /// Returns the people behind the codes; only for the study's author and administrators. The access is
    /// audited, so it needs a writer's job (database.write). Erased participants are left out.
    /// Errors: wrongUse on a reader's connection.
    core::Result<std::vector<ParticipantKey>> participantKeys(StudyNumber study);

private:
    Connection& m_connection;
    Actor m_actor;
};

} // namespace chiron::database
