// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "database/repositories/study_blinding.h"
#include "database/repositories/study_reader.h"
#include "psychophysics/study/run_estimate.h"
#include "psychophysics/study/study_design.h"

#include <QString>
#include <memory>
#include <vector>

namespace chiron::session {

/// One run with its trials, as exports and reports show it.
struct ExportedRun {
    database::StudyRun run;
    /// Never null. While blinded it is any condition of the design, so that only values shared by all
    /// conditions are used.
    const psychophysics::Condition* condition = nullptr;
    QString label; ///< condition's id, or its sealed code while blinded
    int index = 1; ///< number among this participant's runs of this
                   ///< condition, from 1
    std::vector<database::StudyTrial> trials;
    psychophysics::RunEstimate estimate;
};

struct ExportedParticipant {
    database::Participant participant;
    std::vector<ExportedRun> runs;
};

/// All data of a study that may be exported. Move-only, because the runs point into `design`.
struct StudyExportData {
    StudyExportData() = default;
    StudyExportData(StudyExportData&&) = default;
    StudyExportData& operator=(StudyExportData&&) = default;

    database::StudyRecord record;
    std::unique_ptr<psychophysics::StudyDesign> design;
    database::Blinding blinding;
    bool blinded = false;
    /// The study is blinded and its conditions differ: runs have no trials and no estimate, so that nothing
    /// reveals the conditions.
    bool sealed = false;
    bool oneTask = true;  ///< every condition has the same task; otherwise answers would reveal the condition
    bool oneTable = true; ///< every condition has the same differences
    std::vector<ExportedParticipant> participants;
    std::vector<database::QuestionnaireAnswer> answers;
    std::vector<database::ParticipantQuality> quality; ///< by participant

    QString sha256() const { return QString::fromStdString(record.summary.sha256); }
};

/// The English words of a text of the design, which is what an export speaks; empty if it has none.
QString english(const psychophysics::StudyText& words);

/// The trials that the analysis uses: scored and answered, without practice.
std::vector<psychophysics::ScoredTrial> scoredTrialsOf(const std::vector<database::StudyTrial>& trials);

/// Reads all data and estimates each run; ordered by codes while blinded.
/// Errors: wrongUse for a draft; those of the reader.
core::Result<StudyExportData> gatherStudy(database::StudyReader& reader, database::StudyNumber study);

} // namespace chiron::session
