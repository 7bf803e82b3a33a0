// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/units.h"
#include "scoring/metrics/canal_samples.h"

#include <algorithm>

namespace chiron::scoring {

namespace {

constexpr double kHalfWindow_s = 0.1; ///< a turn's rate is taken over twice this, two periods of 10 Hz tremor
constexpr double kTurning_rad_per_s = 5.0 * core::kPi / 180.0; ///< half of what following P1's parabola at 6 mm/s asks for at B, 9°/s

core::Vec3 axisOf(const ToolTrace& tool, std::size_t i) { return tool.q_WT[i] * core::Vec3::UnitZ(); }

/// Way of new depth in the curve, m; `reached`: the tip was there.
class TurningAdvance {
public:
    explicit TurningAdvance(const TrialTrace& trial) : m_tool(trial.tools.front()), m_series(*trial.insertion) {}

    double measure(bool& reached) {
        double advance_m = 0.0, deepest_m = m_series.bend_m;
        for (std::size_t i = 0; i < m_tool.t_s.size(); ++i) {
            if (m_tool.paused[i] != 0 || !isStage(m_series, i, core::ProcedureStage::insertion) || m_series.s_m[i] < m_series.bend_m)
                continue;
            reached = true;
            const double depth_m = std::min(m_series.s_m[i], m_series.bend_m + kCurve_m);
            if (depth_m > deepest_m && turns(i))
                advance_m += depth_m - deepest_m;
            deepest_m = std::max(deepest_m, depth_m);
        }
        return advance_m;
    }

private:
    bool turns(std::size_t i) {
        const double t_s = m_tool.t_s[i];
        while (m_tool.t_s[m_from] < t_s - kHalfWindow_s)
            ++m_from;
        while (m_to + 1 < m_tool.t_s.size() && m_tool.t_s[m_to] < t_s + kHalfWindow_s)
            ++m_to;
        const double time_s = m_tool.t_s[m_to] - m_tool.t_s[m_from];
        const core::Vec3 before = axisOf(m_tool, m_from), after = axisOf(m_tool, m_to);
        return time_s > 0.0 && std::atan2(before.cross(after).norm(), before.dot(after)) > kTurning_rad_per_s * time_s;
    }

    const ToolTrace& m_tool;
    const InsertionSeries& m_series;
    std::size_t m_from = 0, m_to = 0;
};

Measurement measureAdvanceWhileTurning(std::span<const PreparedTrial> trials) {
    if (auto why = withoutCanal(trials))
        return *why;
    bool reached = false;
    double advance_m = 0.0;
    for (const PreparedTrial& trial : trials) {
        if (trial.tool->q_WT.size() != trial.tool->t_s.size())
            return Measurement::undefined(UndefinedReason::noInsertionData);
        advance_m += TurningAdvance(*trial.trial).measure(reached);
    }
    return reached ? Measurement::of(core::mmFromM(advance_m)) : Measurement::undefined(UndefinedReason::neverAtBend);
}

} // namespace

MetricDefinition advanceWhileTurningMetric() {
    return {.id = "advance_while_turning",
            .version = 1,
            .unit = "mm",
            .direction = Direction::lowerIsBetter,
            .wrench = MetricWrench::none,
            .aggregate = Aggregate::pooled,
            .tools = MetricTools::first,
            .definition =
                "How far the tip got deeper, in the stage insertion and up to 30 mm past the bend B, while the instrument's axis turned "
                "faster than 5 degrees per second, taken over 0.2 s: at B the orientation changes without translation.",
            .source = "P1, point B; models.md §8",
            .measure = measureAdvanceWhileTurning};
}

} // namespace chiron::scoring
