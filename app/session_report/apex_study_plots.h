// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/study/apex_study.h"
#include "report/plot_view.h"

#include <memory>
#include <string>
#include <vector>

namespace chiron::session_report {

/// What P2's figure 4 shows of a study of the apex, in per cent of the radius. `names[n]`: of participant number n of the summary. On screen
/// and on paper alike. GUI thread.

/// The marks in the plane about the true apex: ring of R, each person by a symbol of its own (named up to eight), bias as an arrow, sd an
/// axis as an ellipse about it.
std::unique_ptr<report::PlotView> apexMarksPlot(const psychophysics::ApexSummary& summary, const std::vector<QString>& names,
                                                const report::PlotTheme& theme);
/// Each person's mean absolute error over both axes with its sd, the group's, and the published one.
std::unique_ptr<report::PlotView> apexErrorPlot(const psychophysics::ApexSummary& summary, const std::vector<QString>& names,
                                                const report::PlotTheme& theme);

} // namespace chiron::session_report
