// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "report/plot_view.h"
#include "report/report_data.h"

#include <memory>
#include <vector>

namespace chiron::report {

/// The plots of a session. Each makes a new view (GUI thread); empty data give an empty plot with a note,
/// never a crash.
/// Where one tool went, in x, y and z; of several tools one plot an axis. Never empty.
std::vector<std::unique_ptr<PlotView>> positionPlots(const SampleSeries& series, const PlotTheme& theme);
/// Tissue force with the limit line, shaded where it is over it; of one tool commanded and measured force beside it. Of several tools a
/// line each has the tissue's, and `feltForcePlot` and `measuredForcePlot` have the others: a line's kind tells the tool in all of them.
std::unique_ptr<PlotView> forcePlot(const SampleSeries& series, double limit_N, const PlotTheme& theme);
/// What each of several tools was given; null where there is one alone, and where nothing was felt.
std::unique_ptr<PlotView> feltForcePlot(const SampleSeries& series, double limit_N, const PlotTheme& theme);
/// What the device measured of each of several tools; null where there is one alone, and where nothing was measured.
std::unique_ptr<PlotView> measuredForcePlot(const SampleSeries& series, double limit_N, const PlotTheme& theme);
std::unique_ptr<PlotView> speedPlot(const SampleSeries& series, const PlotTheme& theme);
/// An endoscope in its canal over time: distance from the centre-line, angle to it.
std::unique_ptr<PlotView> offsetPlot(const SampleSeries& series, const PlotTheme& theme);
std::unique_ptr<PlotView> alignmentPlot(const SampleSeries& series, const PlotTheme& theme);
/// One column an operator: its sessions as points, mean ± SD beside them, the reference as a line.
std::unique_ptr<PlotView> comparisonPlot(const ComparisonData& data, const PlotTheme& theme);

} // namespace chiron::report
