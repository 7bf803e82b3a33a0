// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/study/run_estimate.h"
#include "report/plot_view.h"
#include "session/study/group_roll.h"

#include <array>
#include <vector>

namespace chiron::session_report {

/// The Weber fractions of a condition's runs in a plot, in per cent. Sound estimates, those whose run has
/// warnings, and those not included in the group value each have their own marker and legend entry.
class MarkedEstimates {
public:
    /// `at`: the position on the x axis. An estimate without a Weber fraction is skipped.
    void add(double at, const psychophysics::RunEstimate& estimate, session::Presence presence);
    bool empty() const;
    void draw(report::PlotView& plot) const;

private:
    struct Series {
        std::vector<report::PlotPoint> points;
        std::vector<report::PlotView::Interval> intervals; ///< longer upwards, because they are symmetric in
                                                           ///< the logarithm
    };
    std::array<Series, 3> m_series; ///< sound, with warnings, not in the group
};

} // namespace chiron::session_report
