// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/study/apex_study.h"
#include "report/plot_view.h"

#include <memory>
#include <string>
#include <vector>

namespace chiron::session_report {

/// Plots in the manner of P2's figure 4 for a study of the apex, in per cent of the radius. `names[n]` is the
/// name of participant number n of the summary. The plots are the same on screen and on paper.
/// Thread: GUI.

/// The marks in the plane around the true apex: a ring of radius R, a separate symbol for each person (named
/// for up to eight), the bias as an arrow, and the standard deviation per axis as an ellipse around it.
std::unique_ptr<report::PlotView> apexMarksPlot(const psychophysics::ApexSummary& summary,
                                                const std::vector<QString>& names,
                                                const report::PlotTheme& theme);
/// Each person's mean absolute error over both axes with its standard deviation, the group's, and the
/// published one.
std::unique_ptr<report::PlotView> apexErrorPlot(const psychophysics::ApexSummary& summary,
                                                const std::vector<QString>& names,
                                                const report::PlotTheme& theme);

} // namespace chiron::session_report
