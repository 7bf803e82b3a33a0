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

/// One run with its trials, as exports and reports tell of it.
struct ExportedRun {
    database::StudyRun run;
    const psychophysics::Condition* condition = nullptr; ///< never null; while blinded any of the design's, so nothing is told of it that conditions do not share
    QString label;                                       ///< condition's id, or its sealed code while blinded
    int index = 1;                                       ///< from 1: among this participant's runs of this condition
    std::vector<database::StudyTrial> trials;
    psychophysics::RunEstimate estimate;
};

struct ExportedParticipant {
    database::Participant participant;
    std::vector<ExportedRun> runs;
};

/// Everything of a study that leaves it. Move-only: runs point into `design`.
struct StudyExportData {
    StudyExportData() = default;
    StudyExportData(StudyExportData&&) = default;
    StudyExportData& operator=(StudyExportData&&) = default;

    database::StudyRecord record;
    std::unique_ptr<psychophysics::StudyDesign> design;
    database::Blinding blinding;
    bool blinded = false;
    /// Conditions differ, and the study is blinded: runs have no trials and no estimate, so that nothing tells their conditions apart.
    bool sealed = false;
    bool oneTask = true;  ///< every condition asks the same; else answers would tell conditions apart
    bool oneTable = true; ///< every condition has the same differences
    std::vector<ExportedParticipant> participants;
    std::vector<database::QuestionnaireAnswer> answers;
    std::vector<database::ParticipantQuality> quality; ///< by participant

    QString sha256() const { return QString::fromStdString(record.summary.sha256); }
};

/// The trials that analysis takes: scored, answered, not practice.
std::vector<psychophysics::ScoredTrial> scoredTrialsOf(const std::vector<database::StudyTrial>& trials);

/// Reads it all and estimates each run; while blinded ordered by codes. Failure: wrongUse for a draft; the reader's.
core::Result<StudyExportData> gatherStudy(database::StudyReader& reader, database::StudyNumber study);

} // namespace chiron::session
