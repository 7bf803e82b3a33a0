// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/site_access.h"
#include "database/repositories/study_reader.h"
#include "psychophysics/study/run_estimate.h"

#include <QJsonArray>
#include <QJsonObject>

namespace chiron::cli {

/// An open database with a study that the actor may read.
struct StudySite {
    Site site;
    std::unique_ptr<database::Connection> connection;
    database::StudyRecord record;

    database::StudyReader reader() const { return database::StudyReader(*connection, site.actor); }
    database::StudyNumber number() const { return record.summary.id; }
};

/// Opens the study that the first operand names by number or key. Reading works without --as (simulated
/// studies); writing needs a person.
/// Errors: wrongUse, notAllowed, notFound, storage.
core::Result<StudySite> openStudy(const Arguments& arguments, Opening opening);
core::Result<database::StudyRecord> findStudy(database::StudyReader reader, const QString& name);

QString stateWord(database::StudyState state);
/// id, key, title, state, sha256, blinded, participants, completed, trials.
QJsonObject studyJson(const database::StudySummary& summary);
/// The keys that cli.md specifies: weber, jnd, sigma_log10, ci_low, ci_high, criterion, unit; exponent and
/// exponent_ci for a magnitude estimation. While the study is blinded, no value is in physical units.
QJsonObject estimateJson(const psychophysics::RunEstimate& estimate, bool blinded);
/// Each warning as "token: words" in English; the tokens alone if the words could reveal blinded information.
QJsonArray warningsJson(const std::vector<psychophysics::Warning>& warnings, bool tokensAlone);
/// "felt" or "shown"; null if nothing was rendered.
QJsonValue forceClassJson(const std::optional<bool>& felt);
QString
warningTokens(const std::vector<psychophysics::Warning>& warnings); ///< each once, separated by commas
QJsonObject participantJson(const database::Participant& participant);

// Handlers of the study commands.
core::Result<CommandOutput> listStudies(const Arguments& arguments);
core::Result<CommandOutput> showStudy(const Arguments& arguments);
core::Result<CommandOutput> exportStudy(const Arguments& arguments);
core::Result<CommandOutput> planStudy(const Arguments& arguments);
core::Result<CommandOutput> analyseStudies(const Arguments& arguments);
core::Result<CommandOutput> runStudy(const Arguments& arguments);
core::Result<CommandOutput> rerunStudy(const Arguments& arguments);
core::Result<CommandOutput> newStudy(const Arguments& arguments);
core::Result<CommandOutput> freezeStudy(const Arguments& arguments);
core::Result<CommandOutput> closeStudy(const Arguments& arguments);
core::Result<CommandOutput> archiveStudy(const Arguments& arguments);
core::Result<CommandOutput> unblindStudy(const Arguments& arguments);
core::Result<CommandOutput> enrolParticipant(const Arguments& arguments);
core::Result<CommandOutput> consentOf(const Arguments& arguments);
core::Result<CommandOutput> withdrawParticipant(const Arguments& arguments);
core::Result<CommandOutput> eraseParticipant(const Arguments& arguments);
core::Result<CommandOutput> studyKey(const Arguments& arguments);
core::Result<CommandOutput> questionnaireTemplate(const Arguments& arguments);
core::Result<CommandOutput> importQuestionnaire(const Arguments& arguments);
core::Result<CommandOutput> summariseQuestionnaires(const Arguments& arguments);

} // namespace chiron::cli
