// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "report/plot_view.h"
#include "report/report_data.h"

#include <memory>
#include <string_view>
#include <vector>

namespace chiron::report {

/// The plots of a session. Each function creates new views. Empty data give an empty plot with a note.
/// Thread: GUI.
///
/// The position of one tool in x, y and z in one plot; with several tools, one plot per axis. Never empty.
std::vector<std::unique_ptr<PlotView>> positionPlots(const SampleSeries& series, const PlotTheme& theme);
/// Tissue force with the limit line; the area above the limit is shaded. With one tool, commanded and
/// measured force are drawn in the same plot. With several tools, each tool has one line for the tissue
/// force, and `feltForcePlot` and `measuredForcePlot` show the other forces; the line style identifies the
/// tool in all of them.
std::unique_ptr<PlotView> forcePlot(const SampleSeries& series, double limit_N, const PlotTheme& theme);
/// The force given to each of several tools; null with a single tool or if nothing was felt.
std::unique_ptr<PlotView> feltForcePlot(const SampleSeries& series, double limit_N, const PlotTheme& theme);
/// The force that the device measured for each of several tools; null with a single tool or if nothing was
/// measured.
std::unique_ptr<PlotView> measuredForcePlot(const SampleSeries& series, double limit_N,
                                            const PlotTheme& theme);
std::unique_ptr<PlotView> speedPlot(const SampleSeries& series, const PlotTheme& theme);
/// How a plot of a derived series is called.
struct DerivedWords {
    QString title;
    QString axis; ///< with the unit
    QString line;
};
/// The derived series with this id over time, times `factor`.
std::unique_ptr<PlotView> derivedPlot(const SampleSeries& series, std::string_view id, double factor,
                                      const DerivedWords& words, const PlotTheme& theme);
/// One column per operator: its sessions as points with mean ± SD beside them, and the reference as a line.
std::unique_ptr<PlotView> comparisonPlot(const ComparisonData& data, const PlotTheme& theme);

} // namespace chiron::report
