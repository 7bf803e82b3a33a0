// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/results/results_data.h"
#include "report/plot_view.h"
#include "report/report_data.h"

#include <memory>
#include <vector>

namespace chiron::desktop {

/// Plots a metric over the attempts at one level. Felt and shown attempts are separate lines, each counted
/// from its first attempt; pass mark and benchmark band lie behind them. `row` gives the metric's id, unit,
/// gate and band.
/// Thread: GUI.
std::unique_ptr<report::PlotView> learningCurve(const std::vector<Attempt>& attempts,
                                                const report::MetricRow& row, const report::PlotTheme& theme);

} // namespace chiron::desktop
