// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "session/study_export_data.h"
#include "session/study_export_table.h"

namespace chiron::session {

// The tables of an export. Each row repeats the SHA-256 of the frozen protocol, so that no table can be taken for another study's.

/// Every presentation of every run, practice and spoiled ones included.
ExportTable trialsTable(const StudyExportData& data);
ExportTable runsTable(const StudyExportData& data);
ExportTable participantsTable(const StudyExportData& data);
/// Answers; free text stays behind (people write names into it), only that there is one is told.
ExportTable questionnairesTable(const StudyExportData& data);
/// A row a score of a participant: of questionnaires that have a rule for it.
ExportTable scoresTable(const StudyExportData& data);
/// A row a run: what estimateRun makes of it.
ExportTable estimatesTable(const StudyExportData& data);

/// A row a participant: how well trials went, over all conditions together. What depends on the objects is n/a while the study is blinded
/// until the participant has completed every condition.
ExportTable qualityTable(const StudyExportData& data);
/// Whether force was felt or only shown, and on what.
std::vector<ExportColumn> deviceColumns();

/// The columns of a trial without those that say whose it is, and its cells: for a file that holds one run alone.
std::vector<ExportColumn> trialColumns();
QStringList trialCells(const StudyExportData& data, const ExportedRun& run, const database::StudyTrial& trial);

} // namespace chiron::session
