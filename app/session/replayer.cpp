// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/replayer.h"

#include "core/fp_environment.h"
#include "devices/recorded_device.h"
#include "haptics/haptic_loop.h"
#include "haptics/recorded_inputs.h"
#include "recording/digest.h"
#include "recording/wrench_rounding.h"
#include "session/exercise_kind.h"

#include <algorithm>
#include <cmath>
#include <thread>

namespace chiron::session {

namespace {

/// Collects the frames of the current chunk. reserve() is called between ticks, so the ticks do not allocate.
class CollectingSink final : public core::IFrameSink {
public:
    void reserve(std::size_t frames) {
        m_frames.clear();
        m_frames.reserve(frames);
    }
    bool tryPush(const core::HapticFrame& frame) noexcept override {
        if (m_frames.size() == m_frames.capacity())
            return false;
        m_frames.push_back(frame);
        return true;
    }
    const std::vector<core::HapticFrame>& frames() const noexcept { return m_frames; }

private:
    std::vector<core::HapticFrame> m_frames;
};

double forceDifference(const core::Array6& stored, const core::Array6& again) {
    const core::Array6 rounded = recording::roundedWrench(again);
    return std::hypot(stored[0] - rounded[0], stored[1] - rounded[1], stored[2] - rounded[2]);
}

double largestDifference(std::span<const core::HapticFrame> stored,
                         std::span<const core::HapticFrame> again) {
    double largest = 0.0;
    for (std::size_t i = 0; i < std::min(stored.size(), again.size()); ++i) {
        for (std::size_t tool = 0; tool < stored[i].tools; ++tool) {
            largest =
                std::max(largest, forceDifference(stored[i].tool[tool].tissue, again[i].tool[tool].tissue));
            largest = std::max(
                largest, forceDifference(stored[i].tool[tool].commanded, again[i].tool[tool].commanded));
        }
    }
    return largest;
}

/// The loop of a replay: the session's own code, with a recording in place of devices and people.
class Replay {
public:
    explicit Replay(SessionView& session) : m_session(session) {}

    core::Result<void> prepare() {
        const SessionSetup& setup = m_session.setup();
        auto kind = exerciseKind(setup.level.exercise);
        CHIRON_TRY(kind);
        std::vector<haptics::LoopTool> tools;
        for (std::size_t i = 0; i < setup.devices.size(); ++i) {
            auto device = devices::RecordedDevice::create(setup.devices[i]);
            CHIRON_TRY(device);
            m_devices.push_back(std::move(*device));
            tools.push_back({*m_devices.back(), setup.mappings[i]});
        }
        auto scene = (*kind)->makeScene(setup);
        m_scenes.offer(scene);
        auto loop =
            haptics::HapticLoop::create({tools, m_inputs, m_supervisor, setup.safety, m_scenes, m_sink});
        CHIRON_TRY(loop);
        m_loop = std::move(*loop);
        return {};
    }

    core::Result<void> run(ReplayReport& report) {
        report.identical = true;
        for (std::size_t i = 0; i < m_session.reader().chunkCount(); ++i) {
            CHIRON_TRY(runChunk(i, report));
        }
        return {};
    }

private:
    core::Result<void> runChunk(std::size_t sequence, ReplayReport& report) {
        auto stored = m_session.reader().framesOf(sequence);
        CHIRON_TRY(stored);
        auto hash = m_session.reader().forceHash(sequence);
        CHIRON_TRY(hash);
        m_sink.reserve(stored->size());
        for (const core::HapticFrame& frame : *stored) {
            if (frame.header.index != m_ticks.executed())
                return core::fail(core::ErrorCode::badInput,
                                  "recording: tick " + std::to_string(frame.header.index) + " follows tick " +
                                      std::to_string(m_ticks.executed()) +
                                      " - frames were lost, so that it cannot be re-simulated");
            m_inputs.setFrame(frame);
            m_loop->tick(m_ticks.next(frame.header.now_ns));
        }
        report.frames += m_sink.frames().size();
        const bool same = recording::forceHashOf(m_sink.frames()) == *hash;
        if (!same && report.identical) {
            report.identical = false;
            report.firstDifferentTick = stored->front().header.index;
        }
        report.maximumDifference_N =
            std::max(report.maximumDifference_N, largestDifference(*stored, m_sink.frames()));
        return {};
    }

    SessionView& m_session;
    std::vector<std::unique_ptr<devices::RecordedDevice>> m_devices;
    haptics::RecordedInputs m_inputs;
    haptics::SafetySupervisor m_supervisor;
    haptics::SceneExchange m_scenes;
    CollectingSink m_sink;
    realtime::TickSource m_ticks;
    // Declared last: it gives its scene back before m_scenes is destroyed.
    std::unique_ptr<haptics::HapticLoop> m_loop;
};

} // namespace

core::Result<ReplayReport> replaySession(SessionView& session) {
    ReplayReport report;
    const database::NewSession& stored = session.record().setup;
    const std::string needed = core::modelsOfBuild(stored.buildId);
    const std::string had = core::modelsOfBuild(core::buildId());
    if (needed != had) {
        report.comparable = false;
        report.note = "needs models " + needed + ", this program has " + had;
    } else if (core::forcesOfBuild(stored.buildId) != core::forcesOfBuild(core::buildId())) {
        report.comparable = false;
        report.note = "recorded by build \"" + stored.buildId + "\"";
    } else if (stored.cpuClass != core::cpuClass()) {
        report.comparable = false;
        report.note = "recorded on CPU class \"" + stored.cpuClass + "\"";
    }
    core::Result<void> outcome;
    // Runs on a separate thread, because the models need their own floating-point environment and the
    // caller's must not change.
    std::thread worker([&] {
        core::setModelFloatingPointEnvironment();
        Replay replay(session);
        outcome = replay.prepare();
        if (outcome)
            outcome = replay.run(report);
    });
    worker.join();
    CHIRON_TRY(outcome);
    return report;
}

} // namespace chiron::session
