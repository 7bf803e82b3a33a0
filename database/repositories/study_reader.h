// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "database/connection.h"
#include "database/repositories/study_types.h"

#include <string>
#include <vector>

namespace chiron::database {

/// Reads studies, on any connection but for participantKeys. Researchers and administrators read all of them, by codes; nobody logged
/// in and the simulated account read those of the simulated account. Failure: notAllowed, notFound, storage.
class StudyReader {
public:
    StudyReader(Connection& connection, Actor actor)
        : m_connection(connection), m_actor(std::move(actor)) {}

    core::Result<std::vector<StudySummary>> listStudies(bool includeArchived = false); ///< by number
    core::Result<StudyRecord> study(StudyNumber study);
    /// The one of this key that the actor may read: a person's before the simulated account's. For those who read only simulated ones: theirs.
    core::Result<StudyRecord> studyByKey(const std::string& key);
    core::Result<std::vector<SealedCondition>> sealedConditions(StudyNumber study); ///< in the design's order; empty for a draft
    core::Result<std::vector<Participant>> participants(StudyNumber study);
    core::Result<Participant> participantByCode(StudyNumber study, const std::string& code); ///< case and "-" do not matter
    core::Result<std::vector<StudyRun>> runs(ParticipantNumber participant); ///< in the order begun
    core::Result<std::vector<StudyTrial>> studyTrials(StudyRunNumber run);   ///< by ordinal
    core::Result<std::vector<QuestionnaireAnswer>> questionnaireAnswers(StudyNumber study);
    /// Who the codes are; the study's author and administrators alone. The look is audited, so it needs a writer's job
    /// (database.write); the erased are left out. Failure: wrongUse on a reader's connection.
    core::Result<std::vector<ParticipantKey>> participantKeys(StudyNumber study);

private:
    Connection& m_connection;
    Actor m_actor;
};

} // namespace chiron::database
