// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "report/plot_view.h"
#include "report/report_data.h"

#include <memory>
#include <vector>

namespace chiron::report {

/// A table as screen and paper show it: the same words, the same order.
struct WordTable {
    std::vector<QString> head;
    std::vector<std::vector<QString>> rows;
};

/// How a trial ended, in words: "done", "time was up", "torn", "not finished".
QString trialOutcomeWords(TrialOutcome outcome, bool tears);

/// The plots of an elastic tube over time. Each makes a new view (GUI thread); empty data give an empty plot with a note.
/// Tension with the band that was asked for ...
std::unique_ptr<PlotView> tensionPlot(const TubeReport& tube, const PlotTheme& theme);
/// The pull on the fold over the tube with its band; null where there was no fold.
std::unique_ptr<PlotView> retractionPlot(const TubeReport& tube, const PlotTheme& theme);
/// ... and stretch with the mark, where the task has one, and the length that counts as over-stretched.
std::unique_ptr<PlotView> stretchPlot(const TubeReport& tube, const PlotTheme& theme);
/// What each trial came to.
WordTable tubeTable(const TubeReport& tube, const QLocale& locale);

/// The largest squeeze of each trial with its limit ...
std::unique_ptr<PlotView> squeezePlot(const HandlingReport& handling, const PlotTheme& theme);
/// ... and where each object lay at the end, seen from above about the target.
std::unique_ptr<PlotView> placePlot(const HandlingReport& handling, const PlotTheme& theme);
WordTable handlingTable(const HandlingReport& handling, const QLocale& locale);

} // namespace chiron::report
