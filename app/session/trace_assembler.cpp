// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/trace_assembler.h"

#include "session/trace_mark.h"

#include "core/contact_bits.h"

#include "scoring/trace_grid.h"

#include <utility>

namespace chiron::session {

namespace {

core::Vec3 forceOf(const core::Array6& wrench) {
    return {scoring::onMillinewtons(wrench[0]), scoring::onMillinewtons(wrench[1]),
            scoring::onMillinewtons(wrench[2])};
}

core::Vec3 onNanometres(const core::Vec3& p) {
    return {scoring::onNanometres(p.x()), scoring::onNanometres(p.y()), scoring::onNanometres(p.z())};
}

core::Vec3 torqueOf(const core::Array6& wrench) {
    return {scoring::onTorqueGrid(wrench[3]), scoring::onTorqueGrid(wrench[4]),
            scoring::onTorqueGrid(wrench[5])};
}

} // namespace

void TraceAssembler::add(std::span<const core::HapticFrame> frames) {
    using namespace core::event_bits;
    for (const core::HapticFrame& frame : frames) {
        m_time.at(frame);
        if (frame.header.events & kTrialStarted)
            begin(frame);
        append(frame);
        if (frame.header.events & kTrialEnds)
            end(frame);
    }
}

void TraceAssembler::begin(const core::HapticFrame& frame) {
    m_inTrial = true;
    m_ticksBefore = {};
    scoring::TrialTrace trial;
    trial.trial = frame.header.trial;
    trial.tools.resize(static_cast<std::size_t>(m_tools));
    trial.quantities = m_quantities.emptyColumns();
    m_trials.push_back(std::move(trial));
}

void TraceAssembler::append(const core::HapticFrame& frame) {
    if (!isRefused(frame.tool[0]))
        m_lastGood = frame.tool[0];
    for (std::size_t i = 0; i < static_cast<std::size_t>(m_tools); ++i) {
        // The clocks also advance between trials.
        const bool isNew = !isRefused(frame.tool[i]) && m_clocks[i].advances(frame.tool[i].deviceTime_us);
        if (isNew && m_inTrial && m_time.started())
            appendTool(frame, i);
        if (m_inTrial && frame.header.paused == 0)
            hold(i);
    }
}

/// Counts a tick during which the newest sample was held.
void TraceAssembler::hold(std::size_t index) {
    std::vector<std::uint32_t>& held = m_trials.back().tools[index].heldTicks;
    ++(held.empty() ? m_ticksBefore[index] : held.back());
}

void TraceAssembler::appendTool(const core::HapticFrame& frame, std::size_t index) {
    const core::ToolFrame& tool = frame.tool[index];
    scoring::ToolTrace& trace = m_trials.back().tools[index];
    trace.t_s.push_back(scoring::onMicroseconds(m_time.since(tool.deviceTime_us)));
    trace.p_WT_m.push_back(onNanometres(m_positions.p_WT_m(static_cast<int>(index), tool)));
    trace.tissue_N.push_back(forceOf(tool.tissue));
    trace.commanded_N.push_back(forceOf(tool.commanded));
    trace.paused.push_back(frame.header.paused);
    trace.contact.push_back(core::contactOfStatus(tool.status));
    trace.heldTicks.push_back(std::exchange(m_ticksBefore[index], 0));
    if (index == 0)
        for (std::size_t i = 0; i < m_quantities.size(); ++i)
            m_trials.back().quantities[i].values.push_back(m_quantities.value(i, frame));
    if (m_orientations && m_orientations->turns(static_cast<int>(index))) {
        trace.q_WT.push_back(m_orientations->q_WT(static_cast<int>(index), tool));
        trace.tissueTorque_Nm.push_back(torqueOf(tool.tissue));
    }
    if (tool.status & core::sample_status::kMeasuredForce) {
        // Zeros for packets before the first measured one.
        trace.measured_N.resize(trace.t_s.size(), core::Vec3::Zero());
        trace.measured_N.back() = forceOf(tool.measured);
    } else if (!trace.measured_N.empty()) {
        trace.measured_N.push_back(core::Vec3::Zero());
    }
}

void TraceAssembler::end(const core::HapticFrame& frame) {
    if (!m_inTrial)
        return;
    m_inTrial = false;
    scoring::TrialTrace& trial = m_trials.back();
    trial.marked = (frame.header.events & core::event_bits::kMarked) != 0 && !isMarkOfTraceEnd(frame);
    trial.completed = (frame.header.events & core::event_bits::kCompleted) != 0;
    trial.timedOut = (frame.header.events & core::event_bits::kTimedOut) != 0;
    trial.failed = (frame.header.events & core::event_bits::kFailed) != 0;
    trial.p_WMark_m = onNanometres(m_positions.p_WT_m(0, m_lastGood));
    // Contact as models.md §6 defines it for every metric: more than 0.02 N of tissue force.
    trial.markInContact = forceOf(frame.tool[0].tissue).norm() > 0.02;
}

} // namespace chiron::session
