// SPDX-License-Identifier: GPL-3.0-or-later
// The results of a tick: the frame that is recorded and the state that is shown.
#include "haptics/haptic_loop.h"

#include "core/contact_bits.h"

namespace chiron::haptics {

namespace {

std::array<double, 3> arrayOf(const core::Vec3& v) noexcept {
    return {v.x(), v.y(), v.z()};
}

std::array<double, 3> arrayOf(const core::DisplayPose& pose) noexcept {
    return {pose.normalForce_N, pose.pitch_rad, pose.roll_rad};
}

core::ToolFrame frameOf(const ToolInput& in) noexcept {
    core::ToolFrame frame;
    frame.counts = in.sample.counts;
    frame.jawCounts = in.sample.jawCounts;
    frame.buttons = in.sample.buttons;
    frame.packet = in.sample.packet;
    frame.status = in.sample.status;
    frame.deviceTime_us = in.sample.deviceTime_us;
    frame.age_us = in.age_us;
    frame.measured = in.sample.measured;
    return frame;
}

} // namespace

void HapticLoop::fillFrame(const realtime::HapticTick& now) noexcept {
    core::TickHeader& header = m_frame.header;
    m_frame.tools = static_cast<std::uint32_t>(m_count);
    header.index = now.index();
    header.now_ns = now.now_ns();
    header.events = m_out.events;
    header.guards = m_safe.guards;
    header.trial = m_out.trial;
    header.heartbeatAge_ms = m_in.heartbeatAge_ms;
    header.phase = m_out.phase;
    header.force = m_safe.force;
    header.paused = m_paused ? 1 : 0;
    header.commands = m_in.commands;
    header.energySupplied_J = m_safe.energySupplied_J;
    header.energyStored_J = m_safe.energyStored_J;
    header.quantities = m_out.quantities;
    for (std::size_t i = 0; i < m_count; ++i) {
        core::ToolFrame& frame = m_frame.tool[i];
        frame = frameOf(m_in.tools[i]);
        frame.status = (frame.status & ~(core::sample_status::kRefused | core::kContactStatusMask)) |
                       (m_tools[i].refused ? core::sample_status::kRefused : 0u) |
                       core::contactStatus(m_out.contact[i]);
        frame.tissue = core::toArray(m_out.tissue.tools[i]);
        frame.commanded = core::toArray(m_safe.tools[i].wrench_W);
        frame.display = arrayOf(m_out.display[i]);
    }
}

ToolDisplay HapticLoop::displayOf(std::size_t i) const noexcept {
    const core::ToolState& state = m_states.tools[i];
    const SafeTool& safe = m_safe.tools[i];
    const ToolInput& in = m_in.tools[i];
    ToolDisplay shown;
    shown.p_WT_m = arrayOf(state.p_WT);
    shown.q_WT = {state.q_WT.w(), state.q_WT.x(), state.q_WT.y(), state.q_WT.z()};
    shown.v_WT_m_per_s = arrayOf(state.v_WT);
    shown.p_WProxy_m = arrayOf(m_out.p_WProxy[i]);
    shown.jaw_rad = state.jaw_rad;
    shown.tissue = core::toArray(m_out.tissue.tools[i]);
    shown.commanded = core::toArray(safe.wrench_W);
    shown.measured = in.sample.measured;
    shown.displayPose = arrayOf(m_out.display[i]);
    shown.safeDisplay = arrayOf(safe.display);
    shown.buttons = state.buttons;
    shown.age_us = in.age_us;
    shown.contact = m_out.contact[i];
    shown.measuredValid = (in.sample.status & core::sample_status::kMeasuredForce) != 0;
    shown.rendersForce = m_supervisor.rendersForce(static_cast<int>(i));
    shown.enabled = safe.enabled;
    shown.noMovement = safe.noMovement;
    return shown;
}

void HapticLoop::fillDisplay(const realtime::HapticTick& now) noexcept {
    m_shown.tick = now.index();
    m_shown.now_ns = now.now_ns();
    m_shown.tools = static_cast<int>(m_count);
    for (std::size_t i = 0; i < m_count; ++i)
        m_shown.tool[i] = displayOf(i);
    m_shown.force = m_safe.force;
    m_shown.waitsFor = m_safe.waitsFor;
    m_shown.guards = m_safe.guards;
    m_shown.guardsSeen |= m_safe.guards;
    m_shown.gain = m_safe.gain;
    m_shown.forceReady = m_safe.forceReady;
    m_shown.trial = m_out.trial;
    m_shown.phase = m_out.phase;
    m_shown.events = m_out.events;
    m_shown.timeLeft_s = m_out.cues.timeLeft_s;
    m_shown.started = m_started;
    m_shown.paused = m_paused;
    m_shown.objectShown = m_out.cues.objectShown;
    m_shown.p_WObject_m = arrayOf(m_out.cues.p_WObject);
    m_shown.objectRadius_m = m_out.cues.objectRadius_m;
    m_shown.exercise = m_out.cues.exercise;
    m_shown.energySupplied_J = m_safe.energySupplied_J;
    m_shown.energyStored_J = m_safe.energyStored_J;
    m_shown.lateTicks = m_statistics.late();
    m_shown.skippedDeadlines = m_statistics.skippedDeadlines();
    m_shown.droppedFrames = m_droppedFrames;
}

} // namespace chiron::haptics
