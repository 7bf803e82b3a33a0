// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/drivers/simulated/simulated_mechanism.h"

#include "core/units.h"

namespace chiron::devices {

using core::Vec3;
using core::Wrench;

core::Result<void> SimulatedMechanism::open() {
    resetPlant();
    const mechanisms::ToolMotion tool = movedPlant().motion();
    m_turns = movedPlant().turns();
    m_hand.reset(tool.p_DT, tool.q_DT);
    m_wrist.reset(tool.q_DT);
    if (m_jaw)
        m_jaw->reset();
    m_cues = {};
    m_sample = {};
    m_onHand_D = {};
    m_compensation_D = {};
    m_ticks = 0;
    return {};
}

void SimulatedMechanism::close() noexcept {
    movedPlant().beginTick({}, false);
    stepDisplay({});
}

void SimulatedMechanism::show(const realtime::HapticTick&, const core::VisibleCues& cues) noexcept {
    m_cues = cues;
}

core::DeviceSample SimulatedMechanism::read(const realtime::HapticTick& now) noexcept {
    const mechanisms::Plant& plant = movedPlant();
    const auto counts = plant.encoderCounts();
    for (std::size_t axis = 0; axis < counts.size(); ++axis)
        m_sample.counts[axis] = counts[axis];
    m_sample.jawCounts = jawCounts();
    m_sample.buttons = m_hand.acting().buttons;
    m_sample.packet = static_cast<std::uint32_t>(now.index());
    m_sample.deviceTime_us = now.index() * 1000;
    m_sample.arrival_ns = now.now_ns();
    m_sample.status = core::sample_status::kMeasuredForce | core::sample_status::kHomed |
                      (plant.saturated() ? core::sample_status::kSaturated : 0u);
    Wrench measured_D = plant.measured_D();
    measured_D.force -= m_compensation_D.force;
    measured_D.torque -= m_compensation_D.torque;
    m_sample.measured = core::toArray(m_map.wrenchToW(measured_D));
    addToSample(m_sample);
    return m_sample;
}

mechanisms::HandPerception SimulatedMechanism::perceive() const noexcept {
    mechanisms::HandPerception seen;
    seen.time_s = static_cast<double>(m_ticks) * core::kTickSeconds;
    seen.p_DT = m_hand.p_D();
    seen.v_DT = m_hand.v_D();
    seen.f_T_D = m_onHand_D.force;
    seen.cues = m_cues;
    if (m_cues.objectShown)
        seen.p_DObject = m_map.pointToD(m_cues.p_WObject);
    if (m_turns) {
        seen.q_DT = m_wrist.q_D();
        seen.w_DT = m_wrist.w_D();
        seen.t_T_D = m_onHand_D.torque;
    }
    addToPerception(seen);
    return seen;
}

Wrench SimulatedMechanism::gripOnTool(const mechanisms::ToolMotion& tool) const noexcept {
    return {m_hand.gripForceOnTool(tool.p_DT, tool.v_DT),
            m_turns ? m_wrist.gripTorqueOnTool(tool.q_DT, tool.w_DT) : Vec3(Vec3::Zero())};
}

void SimulatedMechanism::command(const realtime::HapticTick&, const ForceCommand& command) noexcept {
    m_compensation_D = command.enabled ? command.compensation_D : Wrench{};
    mechanisms::AxisEfforts efforts{};
    if (command.enabled)
        efforts = kinematics().efforts(m_sample, command.wrench_D);
    step(efforts, command);
}

void SimulatedMechanism::drive(const AxisValues& efforts, const core::DisplayPose& display_D,
                               bool enabled) noexcept {
    m_compensation_D = {};
    ForceCommand command;
    command.display = display_D;
    command.enabled = enabled;
    step(enabled ? efforts : mechanisms::AxisEfforts{}, command);
}

void SimulatedMechanism::step(const mechanisms::AxisEfforts& efforts, const ForceCommand& command) noexcept {
    mechanisms::Plant& plant = movedPlant();
    plant.beginTick(efforts, command.enabled);
    m_hand.beginTick(m_strategy->decide(perceive()));
    if (m_turns)
        m_wrist.beginTick(m_hand.acting());
    const int steps = plant.substeps();
    const double dt = core::kTickSeconds / steps;
    Wrench sum;
    for (int step = 0; step < steps; ++step) {
        const Wrench grip = gripOnTool(plant.motion());
        plant.step(dt, grip);
        m_hand.integrate(dt, grip.force);
        sum.force -= grip.force;
        if (m_turns) {
            m_wrist.integrate(dt, grip.torque);
            sum.torque -= grip.torque;
        }
    }
    m_onHand_D = {sum.force / steps, sum.torque / steps};
    if (m_jaw)
        m_jaw->advance(m_hand.acting().jaw_rad);
    plant.endTick();
    stepDisplay(command);
    ++m_ticks;
}

} // namespace chiron::devices
