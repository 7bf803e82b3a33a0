// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/delay_measurement.h"

#include "core/fp_environment.h"
#include "haptics/haptic_loop.h"
#include "haptics/live_inputs.h"
#include "realtime/monotonic_clock.h"
#include "realtime/periodic_runner.h"
#include "realtime/realtime_thread.h"

#include <thread>

namespace chiron::session {

namespace {

constexpr std::uint64_t kArming_ticks = 30'000; ///< longest time to wait for somebody who does not hold still

/// Runs the loop until its scene is over; requests the end if this takes too long or the measurement is
/// cancelled.
struct ProbeTask {
    haptics::HapticLoop& loop;
    haptics::LiveInputs& inputs;
    std::uint64_t atMost_ticks;
    const std::atomic<bool>* cancel;

    bool tick(const realtime::HapticTick& now) noexcept {
        const bool cancelled = cancel != nullptr && cancel->load(std::memory_order_relaxed);
        if (cancelled || now.index() >= atMost_ticks)
            inputs.postOwn({core::CommandKind::end});
        return loop.tick(now);
    }
    void timing(const realtime::TickTiming& timing) noexcept { loop.timing(timing); }
};

void runProbe(ProbeTask& task, bool realtime) {
    std::atomic<bool> stop{false};
    std::thread haptic([&] {
        realtime::TickSource ticks;
        if (realtime) {
            // Without real-time priority ticks are late, and a burst of the excitation with a gap is
            // discarded.
            (void)realtime::setUpRealtimeThread();
            realtime::MonotonicClock clock;
            realtime::PeriodicRunner(clock, ticks).run(task, stop);
        } else {
            core::setModelFloatingPointEnvironment();
            realtime::AsFastRunner(ticks).run(task, stop);
        }
    });
    haptic.join();
}

core::Result<void> shake(devices::IDevice& device, const devices::WorkspaceMapping& mapping,
                         const haptics::DelayProbeSettings& settings, const std::atomic<bool>* cancel,
                         haptics::DelayRecord& record) {
    haptics::LiveInputs inputs;
    haptics::SafetySupervisor supervisor;
    haptics::SceneExchange scenes;
    std::unique_ptr<simulation::IScene> scene = std::make_unique<haptics::DelayProbe>(settings, record);
    scenes.offer(scene);
    haptics::DelayListener listener(settings, record);
    haptics::SafetySettings safety;
    // The scene ends by itself and requests only half a newton.
    safety.heartbeatWatched = false;
    const haptics::LoopTool tool{device, mapping};
    auto loop = haptics::HapticLoop::create({{&tool, 1}, inputs, supervisor, safety, scenes, listener});
    CHIRON_TRY(loop);
    inputs.postOwn({core::CommandKind::start});
    ProbeTask task{**loop, inputs, kArming_ticks + haptics::DelayProbe::ticksOf(settings), cancel};
    runProbe(task, !device.descriptor().inProcess);
    return {};
}

} // namespace

core::Result<haptics::DelayEstimate> measureDelay(devices::IDevice& device,
                                                  const devices::WorkspaceMapping& mapping,
                                                  const haptics::DelayProbeSettings& settings,
                                                  const std::atomic<bool>* cancel) {
    if (!device.descriptor().rendersForce)
        return core::fail(core::ErrorCode::wrongUse, "delay: " + device.descriptor().model +
                                                         " renders no force, so it has none to measure");
    CHIRON_TRY(device.open());
    haptics::DelayRecord record;
    const auto shaken = shake(device, mapping, settings, cancel, record);
    device.close();
    CHIRON_TRY(shaken);
    if (cancel != nullptr && cancel->load())
        return core::fail(core::ErrorCode::cancelled, "delay: stopped");
    if (record.forces < record.force_N.size())
        return core::fail(core::ErrorCode::doesNotHold,
                          "delay: force did not come to full strength, or stopped half-way: hold the device "
                          "still, and try again");
    return haptics::estimateDelay(record);
}

} // namespace chiron::session
