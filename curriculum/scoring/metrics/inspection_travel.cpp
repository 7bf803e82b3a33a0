// SPDX-License-Identifier: GPL-3.0-or-later
#include "scoring/metrics/canal_samples.h"

#include "core/units.h"

namespace chiron::scoring {

namespace {

/// The stage at a time, asked in ascending order or nearly so.
class StageAt {
public:
    StageAt(const ToolTrace& tool, const InsertionSeries& series) : m_tool(tool), m_series(series) {}
    /// By the last sample at or before `t_s`.
    bool inspects(double t_s) {
        while (m_at + 1 < m_tool.t_s.size() && m_tool.t_s[m_at + 1] <= t_s)
            ++m_at;
        return isStage(m_series, m_at, core::ProcedureStage::inspection);
    }

private:
    const ToolTrace& m_tool;
    const InsertionSeries& m_series;
    std::size_t m_at = 0;
};

Measurement measureInspectionTravel(std::span<const PreparedTrial> trials) {
    if (auto why = withoutCanal(trials))
        return *why;
    double travel_m = 0.0;
    bool asked = false;
    bool any = false;
    for (const PreparedTrial& trial : trials) {
        asked = asked || !trial.trial->insertion->landmarkSeen_s.empty();
        StageAt stageAt(*trial.tool, *trial.trial->insertion);
        for (const MotionRun& run : trial.motion.runs)
            for (std::size_t i = 0; i + 1 < run.p_WT_m.size(); ++i) {
                const bool inspects = stageAt.inspects(run.t_s[i]);
                if (!inspects || !stageAt.inspects(run.t_s[i + 1]))
                    continue;
                any = true;
                travel_m += (run.p_WT_m[i + 1] - run.p_WT_m[i]).norm();
            }
    }
    if (any)
        return Measurement::of(core::mmFromM(travel_m));
    return Measurement::undefined(asked ? UndefinedReason::inspectionNotReached : UndefinedReason::noLandmarks);
}

} // namespace

MetricDefinition inspectionTravelMetric() {
    return {.id = "inspection_travel",
            .version = 1,
            .unit = "mm",
            .direction = Direction::lowerIsBetter,
            .wrench = MetricWrench::none,
            .aggregate = Aggregate::pooled,
            .tools = MetricTools::first,
            .definition =
                "Sum of |dp| of the tip while the bladder is inspected, low-passed at 20 Hz and at 100 Hz: a tip that is "
                "turned, not moved, sees as much.",
            .source = "models.md §1.3, §6",
            .measure = measureInspectionTravel};
}

} // namespace chiron::scoring
