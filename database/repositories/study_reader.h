// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "database/connection.h"
#include "database/repositories/study_types.h"

#include <string>
#include <vector>

namespace chiron::database {

/// Reads studies, on any connection but for participantKeys and sealedConditions. Researchers and administrators read all of them, by codes; nobody logged
/// in and the simulated account read those of the simulated account. Failure: notAllowed, notFound, storage.
class StudyReader {
public:
    StudyReader(Connection& connection, Actor actor)
        : m_connection(connection), m_actor(std::move(actor)) {}

    /// By number, without pilots: whatever chooses a study to run, analyse or export chooses among these.
    core::Result<std::vector<StudySummary>> listStudies(bool includeArchived = false);
    core::Result<std::vector<StudySummary>> listPilots(const std::string& key); ///< of the study of this key; by number
    /// Of a frozen study that is blinded the design is masked for those who may not look up which code is which (sealedConditions).
    core::Result<StudyRecord> study(StudyNumber study);
    /// The one of this key that the actor may read: a person's before the simulated account's. For those who read only simulated ones: theirs.
    core::Result<StudyRecord> studyByKey(const std::string& key);
    /// The conditions of a frozen study. While it is blinded: codes without conditions, by code; a design that blinds stays in that order
    /// when it is unblinded, so that nobody's order of conditions changes. Others: in the design's order. Empty for a draft.
    core::Result<std::vector<SealedCondition>> conditionCodes(StudyNumber study);
    /// Which code is which condition, in the design's order; the study's author and administrators alone. The look is audited, so it
    /// needs a writer's job, as participantKeys does.
    core::Result<std::vector<SealedCondition>> sealedConditions(StudyNumber study);
    core::Result<std::vector<Participant>> participants(StudyNumber study);
    core::Result<Participant> participantByCode(StudyNumber study, const std::string& code); ///< case and "-" do not matter
    /// In the order begun; by sealed codes, without conditions, while the study is blinded: for everybody.
    core::Result<std::vector<StudyRun>> runs(ParticipantNumber participant);
    core::Result<std::vector<StudyTrial>> studyTrials(StudyRunNumber run); ///< by ordinal; none while blinded where conditions differ (study_blinding.h)
    core::Result<std::vector<ParticipantQuality>> trialQuality(StudyNumber study); ///< by participant, in the order enrolled; also while blinded
    /// Those of conditions by sealed codes while the study is blinded, and withheld where conditions differ.
    core::Result<std::vector<QuestionnaireAnswer>> questionnaireAnswers(StudyNumber study);
    /// Who the codes are; the study's author and administrators alone. The look is audited, so it needs a writer's job
    /// (database.write); the erased are left out. Failure: wrongUse on a reader's connection.
    core::Result<std::vector<ParticipantKey>> participantKeys(StudyNumber study);

private:
    Connection& m_connection;
    Actor m_actor;
};

} // namespace chiron::database
