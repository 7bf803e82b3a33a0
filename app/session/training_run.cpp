// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/training_run.h"

#include "core/clock.h"
#include "core/fp_environment.h"
#include "database/repositories/session_repository.h"
#include "haptics/slow_model_thread.h"
#include "realtime/monotonic_clock.h"
#include "realtime/periodic_runner.h"
#include "session/channels.h"
#include "session/run_task.h"
#include "session/session_outcome.h"

#include <limits>
#include <optional>
#include <thread>

namespace chiron::session {

namespace {

/// A quarter of the smallest ring: runs faster than real time wait at this interval for the drain, so that no
/// frame is ever dropped.
constexpr std::uint64_t kFlushEvery_ticks = 1024;

/// A person may pause for any length of time, and can end the session by hand.
constexpr std::uint64_t kNoTickLimit = std::numeric_limits<std::uint64_t>::max();

/// The same task for runs faster than real time, with regular waits for the writer, and for devices that are
/// stepped over a link. One that is gone is not waited for; the supervisor sees that its packets end.
struct ThrottledTask {
    RunTask& task;
    database::WriterThread& writer;
    std::vector<StationTool>& tools;
    bool tick(const realtime::HapticTick& now) noexcept {
        if (now.index() % kFlushEvery_ticks == kFlushEvery_ticks - 1)
            (void)writer.flush(); // an error stays with the source and is reported at the end
        const bool goOn = task.tick(now);
        for (StationTool& tool : tools)
            (void)tool.device->awaitStep();
        return goOn;
    }
};

/// A separate thread steps the scene's slow model (null: none), from before the first tick until after the
/// last one.
LoopReport runRealtime(RunTask& task, haptics::HapticLoop& loop, simulation::ISlowModel* slowModel) {
    LoopReport report;
    std::atomic<bool> stop{false};
    std::optional<haptics::SlowModelThread> slow;
    if (slowModel != nullptr)
        slow.emplace(*slowModel);
    std::thread haptic([&] {
        const realtime::RealtimeStatus status = realtime::setUpRealtimeThread();
        realtime::MonotonicClock clock;
        realtime::TickSource ticks;
        realtime::PeriodicRunner runner(clock, ticks);
        const realtime::RunReport run = runner.run(task, stop);
        report.ticks = run.executed;
        report.skipped = run.skipped;
        report.priorityGranted = status.priorityGranted;
        report.priorityDetail = status.priorityDetail;
    });
    haptic.join();
    // After the ticks that use it, before the devices close and the scene is destroyed.
    slow.reset();
    setPunctuality(report, loop.statistics());
    return report;
}

LoopReport runAsFast(RunTask& task, database::WriterThread& writer, std::vector<StationTool>& tools) {
    LoopReport report;
    std::atomic<bool> stop{false};
    std::thread haptic([&] {
        core::setModelFloatingPointEnvironment();
        realtime::TickSource ticks;
        realtime::AsFastRunner runner(ticks);
        ThrottledTask throttled{task, writer, tools};
        report.ticks = runner.run(throttled, stop).executed;
    });
    haptic.join();
    return report;
}

SessionSetup setupOf(const TrainingRequest& request) {
    SessionSetup setup;
    setup.level = request.level;
    setup.seed = request.seed;
    setup.mappings = request.station.mappings();
    setup.safety = headlessSafety(request.level);
    setup.safety.heartbeatWatched = request.live != nullptr;
    for (const StationTool& tool : request.station.tools)
        setup.devices.push_back(tool.device->descriptor());
    return setup;
}

void closeAll(std::vector<StationTool>& tools) {
    for (StationTool& tool : tools)
        tool.device->close();
}

/// A device with a clock of its own cannot be hurried.
core::Result<void> checkClocks(const TrainingRequest& request) {
    for (const StationTool& tool : request.station.tools)
        if (!request.realtime && !tool.device->steppedByHost())
            return core::fail(core::ErrorCode::wrongUse,
                              "device " + tool.device->descriptor().driver +
                                  ": it runs by its own clock; expected a session in "
                                  "real time");
    return {};
}

core::Result<void> openAll(std::vector<StationTool>& tools) {
    for (std::size_t i = 0; i < tools.size(); ++i) {
        if (auto opened = tools[i].device->open(); !opened) {
            for (std::size_t j = 0; j < i; ++j)
                tools[j].device->close();
            return opened;
        }
    }
    return {};
}

core::Result<database::SessionId> beginSession(database::Database& database, const database::Actor& actor,
                                               const TrainingRequest& request, const SessionSetup& setup) {
    auto table = channelTableFor(setup);
    CHIRON_TRY(table);
    database::NewSession session = toNewSession(setup);
    session.operatorName = request.station.operatorName;
    session.familiarisation = request.familiarisation;
    session.realtime = request.realtime;
    session.studyRun = request.studyRun;
    session.channelTable = table->encode();
    session.ringFile = request.ringFolder.string();
    return database.write([&](database::WriteContext& context) {
        return database::SessionRepository(context.connection(), actor).beginSession(session);
    });
}

/// Ends a session that had no tick: it is stored as faulted instead of staying open for ever.
tl::unexpected<core::Error> abandon(database::Database& database, const database::Actor& actor,
                                    database::SessionId session, core::Error why) {
    (void)database.write([&](database::WriteContext& context) {
        return database::SessionRepository(context.connection(), actor)
            .finishSession(session, {.state = database::SessionState::faulted});
    }); // the first error is the one to report
    return tl::unexpected(std::move(why));
}

/// Creates the loop and its parts for the duration of one run.
core::Result<LoopReport> runLoop(database::Database& database, TrainingRequest& request,
                                 const SessionSetup& setup, const ExerciseKind& kind,
                                 LiveRecording& recording) {
    std::vector<devices::IDevice*> devices;
    std::vector<haptics::LoopTool> tools;
    for (const StationTool& tool : request.station.tools) {
        devices.push_back(tool.device.get());
        tools.push_back({*tool.device, tool.mapping});
    }
    haptics::LiveInputs own;
    haptics::LiveInputs& inputs = request.live ? request.live->inputs() : own;
    haptics::SafetySupervisor supervisor;
    haptics::SceneExchange scenes;
    auto scene = kind.makeScene(setup);
    simulation::ISlowModel* const slowModel = scene->slowModel();
    if (request.realtime && slowModel != nullptr)
        inputs.setSlowUpdate(simulation::SlowUpdate::whenReady);
    scenes.offer(scene);
    TeeSink sink(recording.sink(), request.director ? request.director : request.witness);
    auto loop = haptics::HapticLoop::create({tools, inputs, supervisor, setup.safety, scenes, sink});
    CHIRON_TRY(loop);
    if (!request.live)
        inputs.postOwn({core::CommandKind::start});
    else // so that a window that never opens counts as frozen
        inputs.beat(request.realtime ? core::monotonicNow_ns() : 0);
    if (request.director)
        request.director->connect(inputs);
    const std::uint64_t tickLimit =
        request.live || request.director ? kNoTickLimit : kind.tickLimit(setup.level);
    RunTask task(**loop, inputs, sink,
                 {tickLimit, devices.front(), request.cancel, request.live,
                  kind.markRole() != MarkRole::oneOfSeveral});
    LoopReport report = request.realtime ? runRealtime(task, **loop, slowModel)
                                         : runAsFast(task, database.writer(), request.station.tools);
    report.passivity_J = (*loop)->passivityKept_J();
    report.passivityWithheld_J = (*loop)->passivityWithheld_J();
    return report;
}

} // namespace

haptics::SafetySettings headlessSafety(const catalogue::ExerciseLevel& level) {
    haptics::SafetySettings safety;
    if (const auto kind = exerciseKind(level.exercise)) {
        safety.exerciseForce_N = (*kind)->forceLimit_N(level);
        const SessionCaps caps = (*kind)->caps(level);
        safety.exerciseTorque_Nm = caps.torque_Nm;
        safety.capKnee = caps.knee;
    }
    safety.heartbeatWatched = false; // there is no window that could freeze
    return safety;
}

core::Result<TrainingResult> runTraining(database::Database& database, const database::Actor& actor,
                                         TrainingRequest request) {
    return runTrainingOn(database, actor, request);
}

core::Result<TrainingResult> runTrainingOn(database::Database& database, const database::Actor& actor,
                                           TrainingRequest& request) {
    auto kind = exerciseKind(request.level.exercise);
    CHIRON_TRY(kind);
    if (request.ringFolder.empty())
        request.ringFolder = recording::defaultRingFolder();
    CHIRON_TRY(checkClocks(request));
    CHIRON_TRY(openAll(request.station.tools));
    // After opening: a connected device then knows the delay of its link.
    const SessionSetup setup = setupOf(request);
    TrainingResult result;
    auto session = beginSession(database, actor, request, setup);
    if (!session) {
        closeAll(request.station.tools);
        return tl::unexpected(session.error());
    }
    result.session = *session;
    if (request.live)
        request.live->setSession(*session);
    if (request.onSession)
        request.onSession(*session);
    auto recording =
        LiveRecording::start(database, actor, *session, setup, request.ringFolder, request.realtime);
    if (!recording) {
        closeAll(request.station.tools);
        return abandon(database, actor, *session, recording.error());
    }
    auto loop = runLoop(database, request, setup, **kind, **recording);
    closeAll(request.station.tools);
    if (!loop) { // no tick was executed, so the ring is empty
        (void)(*recording)->finish();
        return abandon(database, actor, *session, loop.error());
    }
    result.loop = *loop;
    auto stored = (*recording)->finish();
    CHIRON_TRY(stored);
    result.recording = *stored;
    auto scores = concludeSession(database, actor, *session,
                                  {.dropped = stored->dropped, .loopJson = loopJson(result.loop)});
    CHIRON_TRY(scores);
    result.scores = std::move(*scores);
    return result;
}

} // namespace chiron::session
