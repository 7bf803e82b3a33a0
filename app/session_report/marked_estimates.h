// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/study/run_estimate.h"
#include "report/plot_view.h"
#include "session/study/group_roll.h"

#include <array>
#include <vector>

namespace chiron::session_report {

/// Weber fractions of a condition's runs as a plot shows them: sound ones, those whose run has warnings, and those that are not in the group value each with a
/// marker and a line of the legend of their own. In per cent.
class MarkedEstimates {
public:
    /// `at`: the place on the x axis. What has no Weber fraction is left out.
    void add(double at, const psychophysics::RunEstimate& estimate, session::Presence presence);
    bool empty() const;
    void draw(report::PlotView& plot) const;

private:
    struct Series {
        std::vector<report::PlotPoint> points;
        std::vector<report::PlotView::Interval> intervals; ///< longer upwards: they are of a logarithm
    };
    std::array<Series, 3> m_series; ///< sound, with warnings, not in the group
};

} // namespace chiron::session_report
