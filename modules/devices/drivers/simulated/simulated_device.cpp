// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/drivers/simulated/simulated_device.h"

#include "core/units.h"

namespace chiron::devices {

using core::Vec3;
using mechanisms::GimbalVector;

core::Result<void> SimulatedDevice::open() {
    m_plant.reset(m_start);
    m_hand.reset(m_plant.p_DT());
    m_cues = {};
    m_sample = {};
    m_forceOnHand_D.setZero();
    m_ticks = 0;
    return {};
}

void SimulatedDevice::close() noexcept {
    m_plant.beginTick(GimbalVector::Zero(), false);
}

void SimulatedDevice::show(const realtime::HapticTick&, const core::VisibleCues& cues) noexcept {
    m_cues = cues;
}

core::DeviceSample SimulatedDevice::read(const realtime::HapticTick& now) noexcept {
    const auto& counts = m_plant.counts();
    for (std::size_t axis = 0; axis < counts.size(); ++axis)
        m_sample.counts[axis] = counts[axis];
    m_sample.buttons = m_hand.acting().buttons;
    m_sample.packet = static_cast<std::uint32_t>(now.index());
    m_sample.deviceTime_us = now.index() * 1000;
    m_sample.arrival_ns = now.now_ns();
    m_sample.status = core::sample_status::kMeasuredForce | core::sample_status::kHomed |
                      (m_plant.saturated() ? core::sample_status::kSaturated : 0u);
    m_sample.measured = core::toArray(m_map.wrenchToW({m_plant.measuredForce_D(), Vec3::Zero()}));
    return m_sample;
}

mechanisms::HandPerception SimulatedDevice::perceive() const noexcept {
    mechanisms::HandPerception seen;
    seen.time_s = static_cast<double>(m_ticks) * core::kTickSeconds;
    seen.p_DT = m_hand.p_D();
    seen.v_DT = m_hand.v_D();
    seen.f_T_D = m_forceOnHand_D;
    seen.cues = m_cues;
    if (m_cues.objectShown)
        seen.p_DObject = m_map.pointToD(m_cues.p_WObject);
    return seen;
}

void SimulatedDevice::command(const realtime::HapticTick&, const ForceCommand& command) noexcept {
    GimbalVector efforts = GimbalVector::Zero();
    if (command.enabled) {
        const AxisValues wanted = m_kinematics.efforts(m_sample, command.wrench_D);
        efforts = {wanted[0], wanted[1], wanted[2], wanted[3]};
    }
    m_plant.beginTick(efforts, command.enabled);
    m_hand.beginTick(m_strategy->decide(perceive()));
    const int steps = m_plant.parameters().substeps;
    const double dt = core::kTickSeconds / steps;
    Vec3 sum = Vec3::Zero();
    for (int step = 0; step < steps; ++step) {
        const Vec3 grip = m_hand.gripForceOnTool(m_plant.p_DT(), m_plant.v_DT());
        m_plant.integrate(dt, grip);
        m_hand.integrate(dt, grip);
        sum -= grip;
    }
    m_forceOnHand_D = sum / steps;
    m_plant.endTick();
    ++m_ticks;
}

} // namespace chiron::devices
