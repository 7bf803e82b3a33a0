// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/study/run_estimate.h"
#include "report/plot_view.h"

namespace chiron::session_report {

/// Proportion right over the difference of one run, on screen and on paper: what was answered, each dot with the number of trials it stands for, and
/// the fitted curve with its 95 % band. Where three are ranked (`ranks`) those are of orders wholly right; the criterion belongs to two objects
/// compared, so the observer's curve of that stands beside it and crosses the criterion at the just noticeable difference.
void drawRunCurve(report::PlotView& plot, const psychophysics::RunEstimate& estimate, bool ranks);

} // namespace chiron::session_report
