// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "database/repositories/study_reader.h"
#include "report/plot_theme.h"
#include "session/study/study_analysis.h"

#include <QString>

class QPagedPaintDevice;

namespace chiron::session_report {

/// The printable report of a study: design with its SHA-256, participants by code, each condition's curves and estimates per person and
/// as a group, fidelity, questionnaires, warnings. While a blind experimenter's study is not unblinded, conditions go by their sealed
/// codes. A4, PDF/A-1b. Needs a QApplication; GUI thread; may take seconds (bootstraps). `language` picks the design's texts; `choices` are
/// those of the analysis (the pages say where runs that were shown are included); `site` is what the site is called, for the head of each
/// page. Replaces `path` only when the whole file is written. Failure: wrongUse for a draft, notFound, notAllowed, storage.
core::Result<void> writeStudyReport(const QString& path, database::StudyReader& reader, database::StudyNumber study,
                                    const report::PlotTheme& theme, const std::string& language = "en",
                                    const session::AnalysisChoices& choices = {}, const QString& site = {});

/// The same pages on somebody's own device. GUI thread. Failure: as above.
core::Result<void> paintStudyReport(QPagedPaintDevice& device, database::StudyReader& reader, database::StudyNumber study,
                                    const report::PlotTheme& theme, const std::string& language = "en",
                                    const session::AnalysisChoices& choices = {}, const QString& site = {});

} // namespace chiron::session_report
