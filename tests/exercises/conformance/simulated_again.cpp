// SPDX-License-Identifier: GPL-3.0-or-later
#include "exercises/conformance/simulated_again.h"

#include "core/fp_environment.h"
#include "devices/recorded_device.h"
#include "haptics/haptic_loop.h"
#include "haptics/recorded_inputs.h"
#include "session/exercise_kind.h"

#include <memory>
#include <thread>
#include <vector>

namespace chiron::tests {

namespace {

/// A scene whose last answer can be read.
class HeardScene final : public simulation::IScene {
public:
    HeardScene(std::unique_ptr<simulation::IScene> scene, simulation::SceneOutput& heard)
        : m_scene(std::move(scene)), m_heard(heard) {}
    void respond(const realtime::HapticTick& now, const simulation::SceneInput& in,
                 simulation::SceneOutput& out) noexcept override {
        m_scene->respond(now, in, out);
        m_heard = out;
    }
    simulation::ISlowModel* slowModel() noexcept override { return m_scene->slowModel(); }

private:
    std::unique_ptr<simulation::IScene> m_scene;
    simulation::SceneOutput& m_heard;
};

class LastFrame final : public core::IFrameSink {
public:
    bool tryPush(const core::HapticFrame& frame) noexcept override {
        last = frame;
        return true;
    }
    core::HapticFrame last;
};

core::Result<void> run(session::SessionView& session, const std::function<void(const TickAgain&)>& look) {
    const session::SessionSetup& setup = session.setup();
    auto kind = session::exerciseKind(setup.level.exercise);
    CHIRON_TRY(kind);
    std::vector<std::unique_ptr<devices::RecordedDevice>> devices;
    std::vector<haptics::LoopTool> tools;
    for (std::size_t i = 0; i < setup.devices.size(); ++i) {
        auto device = devices::RecordedDevice::create(setup.devices[i]);
        CHIRON_TRY(device);
        devices.push_back(std::move(*device));
        tools.push_back({*devices.back(), setup.mappings[i]});
    }
    simulation::SceneOutput heard;
    LastFrame sink;
    haptics::RecordedInputs inputs;
    haptics::SafetySupervisor supervisor;
    haptics::SceneExchange scenes;
    std::unique_ptr<simulation::IScene> scene =
        std::make_unique<HeardScene>((*kind)->makeScene(setup), heard);
    scenes.offer(scene);
    auto loop = haptics::HapticLoop::create({tools, inputs, supervisor, setup.safety, scenes, sink});
    CHIRON_TRY(loop);
    realtime::TickSource ticks;
    return session.eachChunk([&](std::span<const core::HapticFrame> frames) -> core::Result<void> {
        for (const core::HapticFrame& frame : frames) {
            inputs.setFrame(frame);
            (*loop)->tick(ticks.next(frame.header.now_ns));
            look({frame, sink.last, heard, (*loop)->shown()});
        }
        return {};
    });
}

} // namespace

core::Result<void> simulateAgain(session::SessionView& session,
                                 const std::function<void(const TickAgain&)>& look) {
    core::Result<void> outcome;
    // A thread of its own: models need their floating-point environment, the caller keeps his.
    std::thread worker([&] {
        core::setModelFloatingPointEnvironment();
        outcome = run(session, look);
    });
    worker.join();
    return outcome;
}

} // namespace chiron::tests
