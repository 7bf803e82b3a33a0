// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/haptic_loop.h"

namespace chiron::haptics {

using core::CommandKind;

bool HapticLoop::tick(const realtime::HapticTick& now) noexcept {
    takeOfferedScene();
    m_inputs.gather(now, {m_devices.data(), m_count}, m_in);
    applyPendingCommands();
    readDevices(now);
    respond(now);
    limit(now);
    commandDevices(now);
    fillFrame(now);
    if (!m_recorder.tryPush(m_frame))
        ++m_droppedFrames;
    fillDisplay(now);
    m_displayTap.publish(m_shown);
    showCues(now);
    return !m_shown.ended;
}

void HapticLoop::timing(const realtime::TickTiming& timing) noexcept {
    constexpr std::uint64_t kSnapshotEvery = 256; // ticks: four snapshots per second are enough for a screen
    m_statistics.add(timing);
    if (m_statistics.ticks() % kSnapshotEvery == 0)
        m_statisticsTap.publish(m_statistics);
}

void HapticLoop::takeOfferedScene() noexcept {
    simulation::IScene* const next = m_scenes.take();
    m_swapped = next != nullptr;
    if (!m_swapped)
        return;
    m_scenes.retire(m_scene);
    m_scene = next;
}

void HapticLoop::applyPendingCommands() noexcept {
    m_mark = false;
    m_reports = 0;
    m_present = m_answer = false;
    for (const core::Command& command : m_in.commands) {
        switch (command.kind) {
        case CommandKind::start:
            m_started = true;
            break;
        case CommandKind::pause:
            m_pauseWanted = true;
            break;
        case CommandKind::resume:
            m_resuming = m_resuming || m_pauseWanted;
            m_pauseWanted = false;
            break;
        case CommandKind::mark:
            m_mark = true;
            break;
        case CommandKind::end:
            m_endWanted = true;
            break;
        case CommandKind::report:
            m_report[m_reports++] = command.argument;
            break;
        case CommandKind::present:
            m_present = true;
            m_presented = command.argument;
            break;
        case CommandKind::answer:
            m_answer = true;
            m_answered = command.argument;
            break;
        case CommandKind::none:
        // For the supervisor, like pause and resume: limit() passes all commands to it.
        case CommandKind::confirmHold:
        case CommandKind::stopForce:
        case CommandKind::rearm:
            break;
        }
    }
}

void HapticLoop::readDevices(const realtime::HapticTick& now) noexcept {
    m_states.count = static_cast<int>(m_count);
    for (std::size_t i = 0; i < m_count; ++i)
        admitTool(now, i);
}

void HapticLoop::admitTool(const realtime::HapticTick& now, std::size_t i) noexcept {
    const ToolInput& in = m_in.tools[i];
    const devices::IToolKinematics& kinematics = m_devices[i]->kinematics();
    const core::ToolState pose_D = kinematics.pose(in.sample);
    Tool& tool = m_tools[i];
    const Admission admission = m_supervisor.admit(now, static_cast<int>(i), in.sample, pose_D, in.age_us);
    if (admission != Admission::repeated) // a packet that is read again keeps its verdict
        tool.refused = admission == Admission::dropped;
    if (admission != Admission::fresh)
        return; // the last good state stays
    const simulation::VelocityEstimator::Rates& rates = tool.velocity.update(in.sample);
    core::Vec3 v_DT = core::Vec3::Zero();
    core::Vec3 w_DT = core::Vec3::Zero();
    kinematics.velocity(in.sample, rates, v_DT, w_DT);
    core::ToolState& state = m_states.tools[i];
    state.p_WT = tool.map.pointToW(pose_D.p_WT);
    state.q_WT = tool.map.orientationToW(pose_D.q_WT);
    state.v_WT = tool.map.velocityToW(v_DT);
    state.w_WT = tool.map.angularToW(w_DT);
    state.jaw_rad = pose_D.jaw_rad;
    state.buttons = in.sample.buttons;
    tool.hasPose = true;
    if (tool.friction.active())
        tool.compensation_W = tool.map.wrenchToW(tool.friction.wrench_D(kinematics, in.sample, rates));
}

void HapticLoop::respond(const realtime::HapticTick& now) noexcept {
    m_resuming = m_resuming && !m_safe.forceReady;
    m_paused = m_pauseWanted || m_resuming;
    simulation::SceneInput in;
    in.tools = m_states;
    for (std::size_t i = 0; i < m_count; ++i)
        if (!m_tools[i].hasPose)
            in.tools.count = 0; // a tool without a good packet so far touches nothing
    for (std::size_t i = 0; i < m_count; ++i)
        in.dampingBudget_Ns_per_m[i] = m_supervisor.dampingBudget_Ns_per_m(static_cast<int>(i));
    in.started = m_started;
    in.paused = m_paused;
    in.forceReady = m_safe.forceReady;
    in.mark = m_mark;
    in.reports = static_cast<int>(m_reports);
    in.report = m_report;
    in.present = m_present;
    in.presented = m_presented;
    in.answer = m_answer;
    in.answered = m_answered;
    in.force = m_safe.force;
    in.slow = m_in.slow;
    m_scene->respond(now, in, m_out);
    if (m_swapped)
        m_out.events |= core::event_bits::kSceneChanged;
}

void HapticLoop::limit(const realtime::HapticTick& now) noexcept {
    SafetyInput in{m_states, m_out, m_in.commands, m_in.heartbeatAge_ms, {}};
    for (std::size_t i = 0; i < m_count; ++i)
        in.compensation_W[i] = m_tools[i].compensation_W;
    m_supervisor.limit(now, in, m_safe);
    m_shown.ended = m_endWanted || m_out.phase == core::TrialPhase::finished;
    if (!m_shown.ended)
        return;
    // The last tick leaves every motor off.
    for (SafeTool& tool : m_safe.tools) {
        tool.wrench_W = {};
        tool.wrench_D = {};
        tool.compensation_D = {};
        tool.display = {};
        tool.display_D = {};
        tool.enabled = false;
    }
}

void HapticLoop::commandDevices(const realtime::HapticTick& now) noexcept {
    for (std::size_t i = 0; i < m_count; ++i) {
        const SafeTool& safe = m_safe.tools[i];
        devices::ForceCommand command;
        command.wrench_D = safe.wrench_D;
        command.compensation_D = safe.compensation_D;
        command.enabled = safe.enabled;
        command.display = safe.display_D;
        m_devices[i]->command(now, command);
    }
}

void HapticLoop::showCues(const realtime::HapticTick& now) noexcept {
    for (std::size_t i = 0; i < m_count; ++i) {
        core::VisibleCues cues = m_out.cues;
        cues.shownForce_N =
            m_supervisor.rendersForce(static_cast<int>(i)) ? 0.0 : m_out.tissue.tools[i].force.norm();
        m_devices[i]->show(now, cues);
    }
}

} // namespace chiron::haptics
