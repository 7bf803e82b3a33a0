// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/urethra_insertion/session/insertion_series.h"

#include "modules/exercises/urethra_insertion/simulation/procedure_plan.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace chiron::session {

namespace {

using simulation::CentrelineFoot;

constexpr std::uint64_t kTick_us = 1000; // the scene's tick

class SeriesBuilder {
public:
    SeriesBuilder(const simulation::UrethraInsertionParameters& p, const scoring::ToolTrace& tool)
        : m_p(p), m_tool(tool), m_line(p.anatomy), m_tracker(simulation::procedurePlan(p)) {
        const simulation::ProcedurePlan& plan = m_tracker.plan();
        m_series.length_m = plan.neck_m;
        m_series.bend_m = p.anatomy.straight_m > 0.0 ? p.anatomy.straight_m : p.anatomy.freeLength_m;
        m_series.goal_m = plan.goal_m;
        m_series.lateralLimit_N = p.lateralLimit_N;
        m_series.landmarkSeen_s.assign(plan.landmarks, std::numeric_limits<double>::quiet_NaN());
    }

    scoring::InsertionSeries build() {
        for (std::size_t i = 0; i < m_tool.t_s.size(); ++i)
            add(i);
        return std::move(m_series);
    }

private:
    void add(std::size_t i) {
        const core::Vec3 p_A = m_p.pose.pointToA(m_tool.p_WT_m[i]);
        const core::Vec3 axis_A =
            m_p.pose.vectorToA(simulation::endoscopeAxis_W(m_tool.q_WT[i].normalized()));
        const CentrelineFoot foot = m_line.foot(p_A);
        m_series.s_m.push_back(foot.at.s_m);
        m_series.offset_m.push_back(std::hypot(foot.ex_m, foot.en_m));
        m_series.alignment_rad.push_back(
            std::atan2(axis_A.cross(foot.at.t_A).norm(), axis_A.dot(foot.at.t_A)));
        const core::Vec3 f_A = m_p.pose.vectorToA(m_tool.tissue_N[i]);
        m_series.lateral_N.push_back((f_A - f_A.dot(foot.at.t_A) * foot.at.t_A).norm());
        const bool torque = i < m_tool.tissueTorque_Nm.size();
        m_series.axialTorque_Nm.push_back(
            torque ? std::abs(m_p.pose.vectorToA(m_tool.tissueTorque_Nm[i]).dot(axis_A)) : 0.0);
        follow(i, {foot.at.s_m, p_A, axis_A, m_series.offset_m.back()});
        m_series.stage.push_back(static_cast<std::uint8_t>(m_tracker.stage()));
    }

    void follow(std::size_t i, const simulation::ProcedureSample& sample) {
        if (m_tool.heldTicks.size() == m_tool.t_s.size()) {
            for (std::uint32_t tick = 0; tick < m_tool.heldTicks[i]; ++tick)
                step(i, sample, kTick_us);
            return;
        }
        const bool paused = i < m_tool.paused.size() && m_tool.paused[i] != 0;
        if (paused)
            return;
        const double since_s = i > 0 ? m_tool.t_s[i] - m_tool.t_s[i - 1] : 0.0;
        step(i, sample, static_cast<std::uint64_t>(std::max(0LL, std::llround(since_s * 1e6))));
    }

    void step(std::size_t i, const simulation::ProcedureSample& sample, std::uint64_t since_us) {
        const std::uint32_t seen = m_tracker.advance(sample, since_us).seenNow;
        for (std::size_t k = 0; k < m_series.landmarkSeen_s.size(); ++k)
            if ((seen & (std::uint32_t{1} << k)) != 0)
                m_series.landmarkSeen_s[k] = m_tool.t_s[i];
    }

    const simulation::UrethraInsertionParameters& m_p;
    const scoring::ToolTrace& m_tool;
    simulation::UrethraCentreline m_line;
    simulation::ProcedureTracker m_tracker;
    scoring::InsertionSeries m_series;
};

} // namespace

std::optional<scoring::InsertionSeries>
insertionSeries(const simulation::UrethraInsertionParameters& parameters, const scoring::TrialTrace& trial) {
    if (trial.tools.empty() || trial.tools[0].q_WT.size() != trial.tools[0].t_s.size())
        return std::nullopt;
    return SeriesBuilder(parameters, trial.tools[0]).build();
}

} // namespace chiron::session
