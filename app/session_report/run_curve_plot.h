// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/study/run_estimate.h"
#include "report/plot_view.h"

namespace chiron::session_report {

/// Draws the proportion correct over the difference for one run, on screen and on paper: the answers, each
/// dot with its number of trials, and the fitted curve with its 95 % band. If three objects are ranked
/// (`ranks`), dots and curve count orders that are entirely correct. The criterion, however, refers to the
/// comparison of two objects, so the observer's curve for that task is drawn as well; it crosses the
/// criterion at the just noticeable difference.
void drawRunCurve(report::PlotView& plot, const psychophysics::RunEstimate& estimate, bool ranks);

} // namespace chiron::session_report
