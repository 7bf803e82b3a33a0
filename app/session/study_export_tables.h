// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "session/study_export_data.h"
#include "session/study_export_table.h"

namespace chiron::session {

// The tables of an export. Each row repeats the SHA-256 of the frozen protocol, so that no table can be
// mistaken for that of another study.

/// Every presentation of every run, practice and spoiled ones included.
ExportTable trialsTable(const StudyExportData& data);
ExportTable runsTable(const StudyExportData& data);
ExportTable participantsTable(const StudyExportData& data);
/// Answers to questionnaires. Free text is not exported, because people write names into it; the table only
/// states that there is one.
ExportTable questionnairesTable(const StudyExportData& data);
/// One row per score of a participant, for questionnaires with a scoring rule.
ExportTable scoresTable(const StudyExportData& data);
/// One row per run with the results of estimateRun.
ExportTable estimatesTable(const StudyExportData& data);

/// One row per participant with the quality of the trials, over all conditions together. Values that depend
/// on the objects are n/a while the study is blinded, until the participant has completed every condition.
ExportTable qualityTable(const StudyExportData& data);
/// Columns that state whether force was felt or only shown, and on which device.
std::vector<ExportColumn> deviceColumns();

/// The columns of a trial without those that identify the participant, and its cells, for a file that holds
/// only one run.
std::vector<ExportColumn> trialColumns();
QStringList trialCells(const StudyExportData& data, const ExportedRun& run,
                       const database::StudyTrial& trial);

} // namespace chiron::session
