// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/site_access.h"
#include "database/repositories/study_reader.h"
#include "psychophysics/study/run_estimate.h"

#include <QJsonArray>
#include <QJsonObject>

namespace chiron::cli {

/// A database with a study in it that the actor may read.
struct StudySite {
    Site site;
    std::unique_ptr<database::Connection> connection;
    database::StudyRecord record;

    database::StudyReader reader() const { return database::StudyReader(*connection, site.actor); }
    database::StudyNumber number() const { return record.summary.id; }
};

/// The study that the first operand names, by number or key. Reading: as anybody (simulated studies); writing: as a person. Failure: wrongUse,
/// notAllowed, notFound, storage.
core::Result<StudySite> openStudy(const Arguments& arguments, Opening opening);
core::Result<database::StudyRecord> findStudy(database::StudyReader reader, const QString& name);

QString stateWord(database::StudyState state);
/// id, key, title, state, sha256, blinded, participants, completed, trials.
QJsonObject studyJson(const database::StudySummary& summary);
/// cli.md: weber, jnd, sigma_log10, ci_low, ci_high, criterion, unit; exponent, exponent_ci of a magnitude estimation; while blinded nothing in physical
/// units.
QJsonObject estimateJson(const psychophysics::RunEstimate& estimate, bool blinded);
/// "token: words" each, in English; by tokens alone where words could tell what is blinded.
QJsonArray warningsJson(const std::vector<psychophysics::Warning>& warnings, bool tokensAlone);
/// "felt" or "shown"; null where nothing was rendered.
QJsonValue forceClassJson(const std::optional<bool>& felt);
QString warningTokens(const std::vector<psychophysics::Warning>& warnings); ///< separated by commas
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
