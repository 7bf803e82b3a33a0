// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/haptic_frame.h"
#include "core/units.h"
#include "devices/drivers/cartesian/cartesian_kinematics.h"
#include "haptics/haptic_loop.h"
#include "haptics/live_inputs.h"
#include "modules/exercises/sphere_apex/simulation/sphere_apex_scene.h"
#include "realtime/periodic_runner.h"
#include "realtime/virtual_clock.h"

#include <algorithm>
#include <cmath>
#include <vector>

/// Parts that loop tests share: a device with a hand made of numbers, a recorder that keeps every frame, a
/// loop around the real sphere-apex scene.
namespace chiron::tests {

/// A tick-stepped tool in metres on a 1 µm grid: the hand wants to be at path(tick), a spring of 400 N/m
/// between hand and tool lets force push the tool away, and the tool gets there with a lag of 50 ms
/// (overdamped, so that contact is steady): commanded forces really change the motion.
class BenchDevice final : public devices::IDevice {
public:
    using Path = core::Vec3 (*)(std::uint64_t tick);

    explicit BenchDevice(Path path, bool rendersForce = true)
        : m_path(path), m_descriptor(describe(rendersForce)),
          m_kinematics(*devices::CartesianKinematics::create(m_descriptor)) {
        received.reserve(30'000);
    }

    const devices::DeviceDescriptor& descriptor() const noexcept override { return m_descriptor; }
    const devices::IToolKinematics& kinematics() const noexcept override { return m_kinematics; }
    core::Result<void> open() override { return {}; }
    void close() noexcept override {}
    core::DeviceSample read(const realtime::HapticTick& now) noexcept override {
        constexpr double kHandStiffness_N_per_m = 400.0;
        constexpr double kStepOfLag = 0.02; // 1 ms of 50 ms
        const core::Vec3 wanted = m_path(now.index()) + m_force / kHandStiffness_N_per_m;
        m_tool = now.index() == 0 ? wanted : core::Vec3(m_tool + kStepOfLag * (wanted - m_tool));
        core::DeviceSample sample;
        for (int i = 0; i < 3; ++i)
            sample.counts[static_cast<std::size_t>(i)] =
                static_cast<std::int32_t>(std::lround(m_tool[i] / 1e-6));
        sample.buttons = buttons;
        sample.packet = static_cast<std::uint32_t>(now.index() + 1);
        sample.status = core::sample_status::kHomed;
        sample.deviceTime_us = now.index() * 1000;
        sample.arrival_ns = now.now_ns() - arrivedBefore_ns;
        return sample;
    }
    void command(const realtime::HapticTick&, const devices::ForceCommand& command) noexcept override {
        m_force = command.enabled ? command.wrench_D.force : core::Vec3(core::Vec3::Zero());
        if (received.size() < received.capacity())
            received.push_back(command);
    }
    void show(const realtime::HapticTick&, const core::VisibleCues& cues) noexcept override { seen = cues; }

    std::uint32_t buttons = 0;
    std::int64_t arrivedBefore_ns = 0;
    std::vector<devices::ForceCommand> received;
    core::VisibleCues seen;

private:
    static devices::DeviceDescriptor describe(bool rendersForce) {
        devices::DeviceDescriptor d;
        d.driver = "bench";
        d.kinematics = "cartesian";
        for (const char* id : {"x", "y", "z"})
            d.axes.push_back({.id = id,
                              .resolution = 1e-6,
                              .minimum = -1.0,
                              .maximum = 1.0,
                              .continuousRating = rendersForce ? 6.0 : 0.0});
        d.rendersForce = rendersForce;
        d.inProcess = true;
        d.maximumForce_N = rendersForce ? 6.0 : 0.0;
        return d;
    }

    Path m_path;
    devices::DeviceDescriptor m_descriptor;
    devices::CartesianKinematics m_kinematics;
    core::Vec3 m_force = core::Vec3::Zero();
    core::Vec3 m_tool = core::Vec3::Zero();
};

/// Keeps frames, with all room made beforehand; can be told to have none.
class FrameStore final : public core::IFrameSink {
public:
    explicit FrameStore(std::size_t room = 30'000) { frames.reserve(room); }
    bool tryPush(const core::HapticFrame& frame) noexcept override {
        if (full || frames.size() == frames.capacity())
            return false;
        frames.push_back(frame);
        return true;
    }
    std::vector<core::HapticFrame> frames;
    bool full = false;
};

/// High for 3 s (arming and its ramp), then down onto the workspace's middle and round it within 8 mm: always
/// inside the ball of benchExercise(), whose centre is within 5 mm.
inline core::Vec3 circlingPath(std::uint64_t tick) {
    const double t = static_cast<double>(tick) * core::kTickSeconds;
    const double down = std::clamp((t - 3.0) / 1.0, 0.0, 1.0);
    return {0.0055 * std::sin(2.0 * t), 0.0055 * std::cos(1.3 * t), 0.060 - 0.048 * down};
}

/// Stays away from everything.
inline core::Vec3 highPath(std::uint64_t) {
    return {0.0, 0.0, 0.060};
}

inline simulation::SphereApexParameters benchExercise(int trials = 2, double limit_s = 8.0) {
    simulation::SphereApexParameters p;
    p.trials = trials;
    p.trialLimit_s = limit_s;
    p.centreDiscRadius_m = 0.005;
    p.frictionLow = p.frictionHigh = 0.3;
    return p;
}

/// A whole loop. `devices` outlive it.
struct LoopBench {
    LoopBench(std::vector<haptics::LoopTool> tools, haptics::ITickInputs& inputs, core::IFrameSink& sink,
              std::unique_ptr<simulation::IScene> scene, haptics::SafetySettings safety = {}) {
        scenes.offer(scene);
        loop = std::move(*haptics::HapticLoop::create({tools, inputs, supervisor, safety, scenes, sink}));
    }
    haptics::SafetySupervisor supervisor;
    haptics::SceneExchange scenes;
    std::unique_ptr<haptics::HapticLoop> loop;
};

inline std::unique_ptr<simulation::IScene>
apexScene(const simulation::SphereApexParameters& p = benchExercise()) {
    return std::make_unique<simulation::SphereApexScene>(p, 7);
}

} // namespace chiron::tests
