// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "database/repositories/study_reader.h"
#include "report/plot_theme.h"
#include "session/study/study_analysis.h"

#include <QString>

class QPagedPaintDevice;

namespace chiron::session_report {

/// Writes the printable report of a study: design with its SHA-256, participants by code, each condition's
/// curves and estimates per person and as a group, fidelity, questionnaires, warnings. While a study with a
/// blind experimenter is not unblinded, conditions are identified by their sealed codes. A4, PDF/A-1b. Needs
/// a QApplication; may take seconds (bootstraps). `language` selects the design's texts; `choices` are those
/// of the analysis (the pages state where shown runs are included); `site` is the name of the site, for the
/// head of each page. Replaces `path` only once the whole file is written.
/// Thread: GUI.
/// Errors: wrongUse for a draft; notFound; notAllowed; storage.
core::Result<void> writeStudyReport(const QString& path, database::StudyReader& reader,
                                    database::StudyNumber study, const report::PlotTheme& theme,
                                    const std::string& language = "en",
                                    const session::AnalysisChoices& choices = {}, const QString& site = {});

/// Paints the same pages on the caller's device.
/// Thread: GUI.
/// Errors: those of writeStudyReport().
core::Result<void> paintStudyReport(QPagedPaintDevice& device, database::StudyReader& reader,
                                    database::StudyNumber study, const report::PlotTheme& theme,
                                    const std::string& language = "en",
                                    const session::AnalysisChoices& choices = {}, const QString& site = {});

} // namespace chiron::session_report
