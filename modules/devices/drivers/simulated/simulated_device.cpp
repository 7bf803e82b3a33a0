// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/drivers/simulated/simulated_device.h"

#include "core/units.h"

#include <array>
#include <string>
#include <utility>

namespace chiron::devices {

using core::Vec3;
using mechanisms::GimbalVector;

namespace {

DeviceDescriptor describe(const SimulatedDevice::Configuration& configuration) {
    const auto& plant = configuration.plant;
    DeviceDescriptor d;
    d.driver = "simulated";
    d.model = "Simulated laparoscopic gimbal (heading, pitch, roll, depth)";
    d.kinematics = GimbalHprdKinematics::kId;
    d.kinematicsParameters = {plant.pivotHeight_m, configuration.map == mechanisms::PolarMap::exact ? 0.0 : 1.0};
    const std::array<const char*, 4> ids{"heading", "pitch", "roll", "depth"};
    for (std::size_t axis = 0; axis < 4; ++axis) {
        const AxisUnit unit = axis == 3 ? AxisUnit::metre : AxisUnit::radian;
        d.axes.push_back({ids[axis], unit, plant.resolution[axis], plant.minimum[axis], plant.maximum[axis],
                          plant.currentLimit_A * plant.effortPerAmpere[axis]});
    }
    d.rendersForce = true;
    d.measuresForce = true;
    d.inProcess = true;
    d.period_us = 1000;
    d.maximumForce_N = d.axes[3].continuousRating; // P2: about 3 N in each direction
    return d;
}

} // namespace

core::Result<std::unique_ptr<SimulatedDevice>>
SimulatedDevice::make(const Configuration& configuration, std::unique_ptr<mechanisms::HandStrategy> strategy) {
    if (!strategy)
        return core::fail(core::ErrorCode::badInput, "simulated device: a hand strategy is expected");
    const mechanisms::GimbalKinematics gimbal(configuration.plant.pivotHeight_m);
    const auto start = gimbal.inverse(configuration.start_D);
    if (!start)
        return tl::unexpected(start.error());
    const std::array<double, 4> q{start->h, start->p, start->r, start->d};
    for (std::size_t axis = 0; axis < 4; ++axis) {
        if (q[axis] < configuration.plant.minimum[axis] || q[axis] > configuration.plant.maximum[axis])
            return core::fail(core::ErrorCode::badInput, "simulated device: the start is outside the travel of axis " +
                                                             std::to_string(axis) + " (h, p, r, d)");
    }
    return std::unique_ptr<SimulatedDevice>(new SimulatedDevice(configuration, *start, std::move(strategy)));
}

SimulatedDevice::SimulatedDevice(const Configuration& configuration, const mechanisms::GimbalCoordinates& start,
                                 std::unique_ptr<mechanisms::HandStrategy> strategy)
    : m_configuration(configuration), m_descriptor(describe(configuration)),
      m_kinematics(configuration.plant.resolution, 0.0, configuration.plant.pivotHeight_m, configuration.map),
      m_start(start), m_plant(configuration.plant),
      m_hand(configuration.hand, configuration.seed,
             configuration.plant.instrumentMass_kg + configuration.plant.axisInertia[3]),
      m_strategy(std::move(strategy)) {}

core::Result<void> SimulatedDevice::open() {
    m_plant.reset(m_start);
    m_hand.reset(m_plant.p_DT());
    m_cues = {};
    m_sample = {};
    m_forceOnHand_D.setZero();
    m_ticks = 0;
    return {};
}

void SimulatedDevice::close() noexcept { m_plant.beginTick(GimbalVector::Zero(), false); }

void SimulatedDevice::show(const realtime::HapticTick&, const core::VisibleCues& cues) noexcept { m_cues = cues; }

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
    m_sample.measured = core::toArray({toW(m_plant.measuredForce_D()), Vec3::Zero()});
    return m_sample;
}

Vec3 SimulatedDevice::toW(const Vec3& f_D) const noexcept {
    return {m_configuration.mapping.leftHanded ? -f_D.x() : f_D.x(), f_D.y(), f_D.z()};
}

mechanisms::HandPerception SimulatedDevice::perceive() const noexcept {
    mechanisms::HandPerception seen;
    seen.time_s = static_cast<double>(m_ticks) * core::kTickSeconds;
    seen.p_DT = m_hand.p_D();
    seen.v_DT = m_hand.v_D();
    seen.f_T_D = m_forceOnHand_D;
    seen.cues = m_cues;
    if (m_cues.objectShown) {
        const auto& mapping = m_configuration.mapping;
        const Vec3 origin(mapping.origin_m[0], mapping.origin_m[1], mapping.origin_m[2]);
        seen.p_DObject = toW((m_cues.p_WObject - origin) / mapping.scale); // H is its own inverse
    }
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
