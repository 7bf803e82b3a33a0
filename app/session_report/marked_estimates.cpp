// SPDX-License-Identifier: GPL-3.0-or-later
#include "session_report/marked_estimates.h"

#include "session_report/study_report_text.h"

#include <algorithm>
#include <cmath>

namespace chiron::session_report {

void MarkedEstimates::add(double at, const psychophysics::RunEstimate& estimate, session::Presence presence) {
    constexpr double kToPercent = 100.0;
    if (!std::isfinite(estimate.weber))
        return;
    Series& series = m_series[presence != session::Presence::used ? 2 : estimate.warnings.empty() ? 0 : 1];
    series.points.push_back({at, kToPercent * estimate.weber});
    series.intervals.push_back({kToPercent * estimate.weber95.low, kToPercent * estimate.weber95.high});
}

bool MarkedEstimates::empty() const {
    return std::all_of(m_series.begin(), m_series.end(),
                       [](const Series& each) { return each.points.empty(); });
}

void MarkedEstimates::draw(report::PlotView& plot) const {
    using Trust = report::PlotView::Trust;
    const std::array names{Words::tr("estimate with its 95 % interval"), Words::tr("! with warnings"),
                           Words::tr("! not in the group value")};
    const std::array trusts{Trust::sound, Trust::doubtful, Trust::leftOut};
    for (std::size_t i = 0; i < m_series.size(); ++i)
        if (!m_series[i].points.empty())
            plot.addEstimates(names[i], m_series[i].points, m_series[i].intervals, trusts[i]);
}

} // namespace chiron::session_report
