// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/safety_supervisor.h"

#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <vector>

/// Test bench of the supervisor: a made-up device, a tick source, and one call that runs a whole tick.
namespace chiron::test {

/// Three forces and three torques along D's axes; a count is a micrometre.
class CartesianKinematics : public devices::IToolKinematics {
public:
    core::ToolState pose(const core::DeviceSample& sample) const noexcept override {
        core::ToolState state;
        state.p_WT = 1e-6 * core::Vec3(sample.counts[0], sample.counts[1], sample.counts[2]);
        return state;
    }
    void velocity(const core::DeviceSample&, const devices::AxisValues& rates, core::Vec3& v,
                  core::Vec3& w) const noexcept override {
        v = 1e-6 * core::Vec3(rates[0], rates[1], rates[2]);
        w.setZero();
    }
    devices::AxisValues efforts(const core::DeviceSample&, const core::Wrench& w) const noexcept override {
        return {w.force.x(), w.force.y(), w.force.z(), w.torque.x(), w.torque.y(), w.torque.z(), 0.0, 0.0};
    }
};

/// A 0.2 m arm turned by counts[0] microradians about D's z: one torque axis whose lever depends on the pose.
class ArmKinematics : public CartesianKinematics {
public:
    devices::AxisValues efforts(const core::DeviceSample& sample,
                                const core::Wrench& w) const noexcept override {
        const double angle = 1e-6 * sample.counts[0];
        return {0.2 * (w.force.y() * std::cos(angle) - w.force.x() * std::sin(angle)), 0, 0, 0, 0, 0, 0, 0};
    }
};

inline devices::DeviceDescriptor sixAxisDevice(double axisForce_N = 10.0, double axisTorque_Nm = 1.0) {
    devices::DeviceDescriptor device;
    device.driver = "test";
    for (int i = 0; i < 6; ++i) {
        devices::AxisDescriptor axis;
        axis.id = "axis_" + std::to_string(i);
        axis.unit = i < 3 ? devices::AxisUnit::metre : devices::AxisUnit::radian;
        axis.continuousRating = i < 3 ? axisForce_N : axisTorque_Nm;
        device.axes.push_back(axis);
    }
    device.rendersForce = true;
    device.period_us = 1000;
    device.maximumForce_N = 10.0;
    device.maximumTorque_Nm = 1.0;
    return device;
}

/// One tool, unless more devices are given.
class SafetyRig {
public:
    explicit SafetyRig(const devices::DeviceDescriptor& device = sixAxisDevice(),
                       const haptics::SafetySettings& settings = {}, devices::WorkspaceMapping mapping = {},
                       const devices::IToolKinematics* kinematics = nullptr, haptics::GuardMask mask = {}) {
        supervisor.setGuardMaskForTests(mask);
        start(std::vector<devices::DeviceDescriptor>{device}, settings, mapping, kinematics);
    }
    SafetyRig(const std::vector<devices::DeviceDescriptor>& devices, const haptics::SafetySettings& settings,
              haptics::GuardMask mask = {}) {
        supervisor.setGuardMaskForTests(mask);
        start(devices, settings, {}, nullptr);
    }

    /// One tick: every tool sends a new packet (unless silent), then limit().
    const haptics::SafetyOutput& tick(std::initializer_list<core::CommandKind> commands = {}) {
        const realtime::HapticTick now = m_source.next(now_ns);
        now_ns += 1'000'000;
        for (int i = 0; i < count; ++i) {
            auto& sample = samples[static_cast<std::size_t>(i)];
            if (!silent) {
                ++sample.packet;
                sample.deviceTime_us += 1000;
            }
            const auto u = static_cast<std::size_t>(i);
            admissions[u] = supervisor.admit(now, i, sample, poses_D[u], age_us);
        }
        haptics::SafetyInput in{states, scene, {}, heartbeatAge_ms};
        std::size_t n = 0;
        for (const core::CommandKind kind : commands) {
            in.commands[n++].kind = kind;
        }
        supervisor.limit(now, in, out);
        return out;
    }
    void ticks(int n) {
        for (int i = 0; i < n; ++i) {
            tick();
        }
    }
    /// From the start to full gain with nothing requested: first packet, 4 quiet ticks, 2000 of ramp.
    void arm() {
        scene.tissue.tools[0] = {};
        ticks(1 + 4 + 2000);
    }
    void ask(const core::Vec3& force, const core::Vec3& torque = core::Vec3::Zero()) {
        scene.tissue.tools[0] = {force, torque};
    }
    core::Vec3 force() const { return out.tools[0].wrench_W.force; }

    haptics::SafetySupervisor supervisor;
    haptics::SafetyOutput out;
    simulation::SceneOutput scene;
    core::ToolStates states;
    std::array<core::DeviceSample, core::kMaxTools> samples{};
    std::array<core::ToolState, core::kMaxTools> poses_D{};
    std::array<haptics::Admission, core::kMaxTools> admissions{};
    std::uint32_t age_us = 0;
    std::uint16_t heartbeatAge_ms = 0;
    std::int64_t now_ns = 1'000'000'000;
    int count = 1;
    bool silent = false;

private:
    void start(const std::vector<devices::DeviceDescriptor>& devices, const haptics::SafetySettings& settings,
               devices::WorkspaceMapping mapping, const devices::IToolKinematics* kinematics) {
        m_devices = devices;
        count = static_cast<int>(devices.size());
        std::vector<haptics::SafetyTool> tools;
        for (const auto& device : m_devices) {
            tools.push_back({device, kinematics != nullptr ? *kinematics : m_kinematics, mapping});
        }
        accepted = supervisor.configure(settings, tools).has_value();
        states.count = count;
        scene.tissue.count = count;
    }

    std::vector<devices::DeviceDescriptor> m_devices;
    CartesianKinematics m_kinematics;
    realtime::TickSource m_source;

public:
    bool accepted = false;
};

} // namespace chiron::test
