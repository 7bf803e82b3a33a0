// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/tick_session.h"

#include "catalogue/catalogue.h"
#include "core/clock.h"
#include "devices/recorded_device.h"
#include "realtime/tick_guard.h"
#include "recording/crash_ring.h"
#include "recording/frame_drain.h"
#include "recording/recorder.h"
#include "session/channels.h"
#include "session/exercise_kind.h"
#include "session/station.h"
#include "session/tool_positions.h"
#include "session/training_run.h"
#include "support/haptic_bench.h"

#include <cstring>
#include <unistd.h>

namespace chiron::bench {

namespace {
constexpr const char* kOperator = "expert";
constexpr std::uint64_t kDrainEvery_ticks = 20; // as the writer thread's 20 ms

/// Stored nowhere: what the writer thread does with a chunk is measured by bench_recording.
struct ForgetfulSink final : recording::TrialSink {
    core::Result<void> write(std::span<const recording::Chunk>,
                             std::span<const recording::SecondSummary>) override {
        return {};
    }
};

/// Ring and drain of one pass.
struct Recording {
    std::unique_ptr<session::ToolPositions> positions;
    std::unique_ptr<recording::CrashRing> ring;
    ForgetfulSink sink;
    std::unique_ptr<recording::Recorder> recorder;
    std::unique_ptr<recording::FrameDrain> drain;

    core::Result<void> start(const session::SessionSetup& setup) {
        auto tools = session::ToolPositions::create(setup);
        auto table = session::channelTableFor(setup);
        auto made = recording::CrashRing::create({.folder = recording::defaultRingFolder(),
                                                  .session = getpid(),
                                                  .tools = static_cast<int>(setup.devices.size())});
        if (!tools || !table || !made)
            return tl::unexpected(!tools ? tools.error() : !table ? table.error() : made.error());
        positions = std::move(*tools);
        ring = std::move(*made);
        recorder = std::make_unique<recording::Recorder>(std::move(*table), *positions, sink,
                                                         recording::RecorderSettings{});
        drain = std::make_unique<recording::FrameDrain>(*ring, *recorder);
        return {};
    }
    ~Recording() {
        if (ring)
            (void)ring->remove();
    }
};

/// One loop from its first tick on; `prepare(n)` sets what tick n gets, outside the measured time.
template <class Prepare>
TickTimes timeTicks(haptics::HapticLoop& loop, Recording& recording, std::size_t ticks, Prepare&& prepare) {
    TickTimes times;
    times.tick_ns.reserve(ticks);
    realtime::TickSource source;
    tests::resetForbiddenCounts();
    bool goOn = true;
    for (std::size_t n = 0; n < ticks && goOn; ++n) {
        const auto now_ns = static_cast<std::int64_t>(n) * 1'000'000;
        prepare(n);
        const realtime::HapticTick now = source.next(now_ns);
        {
            const tests::TickGuard guard;
            const std::int64_t start_ns = core::monotonicNow_ns();
            goOn = loop.tick(now);
            times.tick_ns.push_back(static_cast<double>(core::monotonicNow_ns() - start_ns));
        }
        if (n % kDrainEvery_ticks == kDrainEvery_ticks - 1)
            (void)recording.drain->drain(now_ns); // the sink takes everything
    }
    const tests::ForbiddenCounts counts = tests::forbiddenCounts();
    times.allocations = counts.of(tests::Forbidden::allocate);
    times.otherForbidden = counts.total() - times.allocations;
    times.dropped = loop.droppedFrames();
    return times;
}

core::Result<session::Station> stationOf(const session::SessionSetup& setup) {
    const auto kind = session::exerciseKind(setup.level.exercise);
    CHIRON_TRY(kind);
    auto station = session::scriptedStation(**kind, setup.level, kOperator, setup.seed);
    if (!station)
        return station;
    for (const auto& tool : station->tools)
        CHIRON_TRY(tool.device->open());
    return station;
}

std::vector<haptics::LoopTool> toolsOf(const session::Station& station) {
    std::vector<haptics::LoopTool> tools;
    for (std::size_t i = 0; i < station.tools.size(); ++i)
        tools.push_back({*station.tools[i].device, station.tools[i].mapping});
    return tools;
}

/// The frames' packets through a device of the past and live inputs, tick by tick.
struct Playback {
    std::vector<std::unique_ptr<devices::RecordedDevice>> devices;
    haptics::LiveInputs inputs;

    core::Result<void> open(const session::SessionSetup& setup) {
        for (const devices::DeviceDescriptor& descriptor : setup.devices) {
            auto device = devices::RecordedDevice::create(descriptor);
            CHIRON_TRY(device);
            devices.push_back(std::move(*device));
        }
        return {};
    }
    std::vector<haptics::LoopTool> tools(const session::SessionSetup& setup) const {
        std::vector<haptics::LoopTool> out;
        for (std::size_t i = 0; i < devices.size(); ++i)
            out.push_back({*devices[i], setup.mappings[i]});
        return out;
    }

    void prepare(const core::HapticFrame& frame) noexcept {
        for (const core::Command& command : frame.header.commands)
            if (command.kind != core::CommandKind::none)
                inputs.post(command);
        for (std::size_t i = 0; i < devices.size(); ++i) {
            core::DeviceSample sample = session::sampleOf(frame.tool[i]);
            sample.arrival_ns = frame.header.now_ns - static_cast<std::int64_t>(frame.tool[i].age_us) * 1'000;
            devices[i]->setSample(sample);
        }
    }
};

} // namespace

std::unique_ptr<simulation::IScene> sceneOf(const session::SessionSetup& setup) {
    return (*session::exerciseKind(setup.level.exercise))->makeScene(setup);
}

core::Result<RecordedSession> recordSession(const char* exercise, int level, std::uint64_t seed,
                                            std::size_t ticks) {
    const auto catalogue = catalogue::Catalogue::load(CHIRON_SOURCE_DIR "/curriculum/content");
    CHIRON_TRY(catalogue);
    RecordedSession recorded;
    recorded.setup.level = *catalogue->find(exercise, level);
    recorded.setup.seed = seed;
    recorded.setup.safety = session::headlessSafety(recorded.setup.level);
    auto station = stationOf(recorded.setup);
    CHIRON_TRY(station);
    for (const auto& tool : station->tools)
        recorded.setup.devices.push_back(tool.device->descriptor());
    recorded.setup.mappings = station->mappings();
    haptics::LiveInputs inputs;
    tests::FrameStore store(ticks);
    tests::LoopBench bench(toolsOf(*station), inputs, store, sceneOf(recorded.setup), recorded.setup.safety);
    inputs.post({core::CommandKind::start});
    realtime::TickSource source;
    for (std::size_t n = 0; n < ticks; ++n)
        if (!bench.loop->tick(source.next(static_cast<std::int64_t>(n) * 1'000'000)))
            break;
    recorded.frames = std::move(store.frames);
    return recorded;
}

core::Result<TickTimes> timeWithPlant(const RecordedSession& recorded) {
    auto station = stationOf(recorded.setup);
    Recording recording;
    if (auto started = recording.start(recorded.setup); !station || !started)
        return tl::unexpected(!station ? station.error() : started.error());
    haptics::LiveInputs inputs;
    tests::LoopBench bench(toolsOf(*station), inputs, *recording.ring, sceneOf(recorded.setup),
                           recorded.setup.safety);
    inputs.post({core::CommandKind::start});
    return timeTicks(*bench.loop, recording, recorded.frames.size(), [](std::size_t) {});
}

core::Result<TickTimes> timeWithRecordedDevice(const RecordedSession& recorded) {
    Playback playback;
    Recording recording;
    const auto opened = playback.open(recorded.setup);
    if (auto started = recording.start(recorded.setup); !opened || !started)
        return tl::unexpected(!opened ? opened.error() : started.error());
    tests::LoopBench bench(playback.tools(recorded.setup), playback.inputs, *recording.ring,
                           sceneOf(recorded.setup), recorded.setup.safety);
    return timeTicks(*bench.loop, recording, recorded.frames.size(),
                     [&](std::size_t n) { playback.prepare(recorded.frames[n]); });
}

core::Result<std::size_t> sameFrames(const RecordedSession& recorded) {
    Playback playback;
    CHIRON_TRY(playback.open(recorded.setup));
    tests::FrameStore store(recorded.frames.size());
    tests::LoopBench bench(playback.tools(recorded.setup), playback.inputs, store, sceneOf(recorded.setup),
                           recorded.setup.safety);
    realtime::TickSource source;
    for (const core::HapticFrame& frame : recorded.frames) {
        playback.prepare(frame);
        bench.loop->tick(source.next(frame.header.now_ns));
    }
    std::size_t same = 0;
    for (std::size_t n = 0; n < store.frames.size(); ++n)
        same +=
            std::memcmp(&store.frames[n].header, &recorded.frames[n].header, sizeof(core::TickHeader)) == 0 &&
                    std::memcmp(&store.frames[n].tool[0], &recorded.frames[n].tool[0],
                                sizeof(core::ToolFrame)) == 0
                ? 1
                : 0;
    return same;
}

} // namespace chiron::bench
