// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/drivers/simulated/simulated_second_finger.h"

#include "core/units.h"

namespace chiron::devices {

core::Result<void> SimulatedSecondFinger::open() {
    m_finger.reset();
    m_reaction.reset(core::Vec3::Zero());
    m_cues = {};
    m_sample = {};
    m_ticks = 0;
    return {};
}

core::DeviceSample SimulatedSecondFinger::read(const realtime::HapticTick& now) noexcept {
    const auto counts = m_first.arm().encoderCounts();
    for (std::size_t axis = 0; axis < counts.size(); ++axis)
        m_sample.counts[axis] = counts[axis];
    m_sample.jawCounts = m_first.arm().jawCounts();
    m_sample.buttons = m_reaction.acting().buttons;
    m_sample.packet = static_cast<std::uint32_t>(now.index());
    m_sample.deviceTime_us = now.index() * 1000;
    m_sample.arrival_ns = now.now_ns();
    m_sample.status = core::sample_status::kHomed;
    m_finger.addToSample(m_kinematics, m_map, m_sample);
    return m_sample;
}

mechanisms::HandPerception SimulatedSecondFinger::perceive() const noexcept {
    mechanisms::HandPerception seen;
    seen.time_s = static_cast<double>(m_ticks) * core::kTickSeconds;
    seen.cues = m_cues;
    if (m_cues.objectShown)
        seen.p_DObject = m_map.pointToD(m_cues.p_WObject);
    seen.q_DT = m_first.wrist().q_D();
    seen.w_DT = m_first.wrist().w_D();
    const core::Vec3 arm = seen.q_DT * m_pad_T;
    seen.p_DT = m_first.hand().p_D() + arm;
    seen.v_DT = m_first.hand().v_D() + seen.w_DT.cross(arm);
    m_finger.addToPerception(seen);
    return seen;
}

void SimulatedSecondFinger::command(const realtime::HapticTick&, const ForceCommand& command) noexcept {
    m_reaction.beginTick(m_strategy->decide(perceive()));
    m_finger.tick(command);
    ++m_ticks;
}

} // namespace chiron::devices
