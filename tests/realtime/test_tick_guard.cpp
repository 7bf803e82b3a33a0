// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/drivers/endoscope_pointer/endoscope_pointer_device.h"
#include "devices/drivers/keyboard_mouse/keyboard_mouse_device.h"
#include "devices/drivers/replay/replay_device.h"
#include "devices/drivers/simulated/simulated_device.h"
#include "devices/drivers/simulated/simulated_endoscope_device.h"
#include "devices/recorded_device.h"
#include "haptics/delay_probe.h"
#include "haptics/recorded_inputs.h"
#include "mechanisms/scripted_motion.h"
#include "modules/exercises/sphere_apex/operators/sphere_apex_operator.h"
#include "realtime/guarded_run.h"

#include <QtTest>

using namespace chiron;
using namespace chiron::tests;
using core::CommandKind;

namespace {

simulation::SphereApexParameters exercise(const QString& kind) {
    simulation::SphereApexParameters p = benchExercise(3, 3.0);
    if (kind == "visible")
        p.cues = {"object", "tool"};
    if (kind == "varied") {
        p.stiffnessLow_N_per_m = 300.0;
        p.stiffnessHigh_N_per_m = 700.0;
        p.stiffnessVariation = 0.3;
        p.frictionHigh = 0.6;
    }
    if (kind == "dimple")
        p.dimpleDepth_m = 0.001;
    return p;
}

std::vector<devices::TracePoint> trace() {
    std::vector<devices::TracePoint> rows;
    for (int n = 0; n <= 90; ++n)
        rows.push_back({.t_s = 0.1 * n,
                        .p_WT_m = circlingPath(static_cast<std::uint64_t>(100 * n)),
                        .q_WT = core::Quat(Eigen::AngleAxisd(0.01 * n, core::Vec3::UnitZ())),
                        .buttons = n % 40 == 39 ? 1u : 0u});
    return rows;
}

/// A gimbal whose hand moves up and down through the ball's top.
std::unique_ptr<devices::SimulatedDevice> gimbal(std::uint64_t seed) {
    devices::SimulatedDevice::Configuration configuration;
    configuration.seed = seed;
    configuration.frictionCompensation = 0.8; // fed forward by the loop
    auto hand = std::make_unique<mechanisms::ScriptedMotion>(
        core::Vec3(0.0, 0.0, 0.030),
        std::vector<mechanisms::ScriptedMotion::Term>{{core::Vec3(0.003, 0.002, -0.018), 0.25, 0.0}});
    auto device = std::move(*devices::SimulatedDevice::create(configuration, std::move(hand)));
    (void)device->open();
    return device;
}

/// An endoscope whose hand moves its tip up and down through the ball's top and turns it on the way.
class Turner final : public mechanisms::HandStrategy {
public:
    mechanisms::HandIntention decide(const mechanisms::HandPerception& seen) noexcept override {
        const double phase = 1.5 * seen.time_s;
        mechanisms::HandIntention wanted;
        wanted.p_DDesired = core::Vec3(0.0, 0.003, 0.030 - 0.018 * std::sin(phase));
        wanted.q_DDesired =
            mechanisms::SphericalJoint({0.4 * std::sin(phase), 0.2 * std::cos(phase), 0.5 * phase})
                .orientation_DT();
        return wanted;
    }
};

std::unique_ptr<devices::SimulatedEndoscopeDevice> endoscope() {
    devices::SimulatedEndoscopeDevice::Configuration configuration;
    configuration.start_D = core::Vec3(0.0, 0.003, 0.030);
    auto device =
        std::move(*devices::SimulatedEndoscopeDevice::create(configuration, std::make_unique<Turner>()));
    (void)device->open();
    return device;
}

} // namespace

class TestTickGuard : public QObject {
    Q_OBJECT

    void everyExercise() {
        QTest::addColumn<QString>("kind");
        for (const char* kind : {"plain", "visible", "varied", "dimple"})
            QTest::newRow(kind) << QString(kind);
    }

private slots:
    void benchDevicesAndSphereApex_data() { everyExercise(); }
    void benchDevicesAndSphereApex() {
        QFETCH(QString, kind);
        BenchDevice a(circlingPath);
        BenchDevice b(circlingPath);
        BenchDevice c(circlingPath, false);
        BenchDevice d(highPath);
        haptics::LiveInputs inputs;
        FrameStore store;
        const devices::WorkspaceMapping mirrored{.origin_m = {}, .scale = 1.5, .leftHanded = true};
        LoopBench bench({{a, {}}, {b, mirrored}, {c, {}}, {d, {}}}, inputs, store, apexScene(exercise(kind)));
        const ForbiddenCounts counts = guardedRun(*bench.loop, inputs, nullptr);
        QVERIFY2(counts.total() == 0, words(counts));
        QVERIFY(store.frames[5'999].tool[0].tissue[2] > 0.1); // the run did touch
    }

    void keyboardAndMouse_data() { everyExercise(); }
    void keyboardAndMouse() {
        QFETCH(QString, kind);
        const auto device = devices::KeyboardMouseDevice::create();
        haptics::LiveInputs inputs;
        FrameStore store;
        LoopBench bench({{**device, {}}}, inputs, store, apexScene(exercise(kind)));
        const ForbiddenCounts counts = guardedRun(*bench.loop, inputs, &(*device)->mailbox());
        QVERIFY2(counts.total() == 0, words(counts));
        QVERIFY(store.frames.back().tool[0].counts[2] != store.frames.front().tool[0].counts[2]);
    }

    void replayedTrace_data() { everyExercise(); }
    void replayedTrace() {
        QFETCH(QString, kind);
        const auto device = devices::ReplayDevice::create(trace());
        haptics::LiveInputs inputs;
        FrameStore store;
        LoopBench bench({{**device, {}}}, inputs, store, apexScene(exercise(kind)));
        const ForbiddenCounts counts = guardedRun(*bench.loop, inputs, nullptr);
        QVERIFY2(counts.total() == 0, words(counts));
        QVERIFY((*device)->finished());
    }

    void simulatedGimbals_data() { everyExercise(); }
    void simulatedGimbals() {
        QFETCH(QString, kind);
        const auto first = gimbal(1);
        const auto second = gimbal(2);
        haptics::LiveInputs inputs;
        FrameStore store;
        LoopBench bench({{*first, {}}, {*second, {}}}, inputs, store, apexScene(exercise(kind)));
        const ForbiddenCounts counts = guardedRun(*bench.loop, inputs, nullptr);
        QVERIFY2(counts.total() == 0, words(counts));
        double strongest_N = 0.0;
        for (const core::HapticFrame& frame : store.frames)
            strongest_N = std::max(strongest_N, frame.tool[0].commanded[2]);
        QVERIFY(strongest_N > 0.1);
    }

    void simulatedEndoscope() {
        const auto device = endoscope();
        haptics::LiveInputs inputs;
        FrameStore store;
        LoopBench bench({{*device, {}}}, inputs, store, apexScene(exercise("plain")));
        const ForbiddenCounts counts = guardedRun(*bench.loop, inputs, nullptr);
        QVERIFY2(counts.total() == 0, words(counts));
        double strongest_N = 0.0, widest_rad = 0.0;
        for (const core::HapticFrame& frame : store.frames) {
            strongest_N = std::max(strongest_N, frame.tool[0].commanded[2]);
            widest_rad = std::max(
                widest_rad, std::abs(frame.tool[0].counts[4] * device->descriptor().axes[4].resolution));
        }
        QVERIFY(strongest_N > 0.1 && widest_rad > 1.0);
    }

    void mouseMovingAnEndoscope() {
        const auto device = devices::EndoscopePointerDevice::create();
        haptics::LiveInputs inputs;
        FrameStore store;
        LoopBench bench({{**device, {}}}, inputs, store, apexScene(exercise("plain")));
        const ForbiddenCounts counts = guardedRun(*bench.loop, inputs, nullptr, &(*device)->mailbox());
        QVERIFY2(counts.total() == 0, words(counts));
        for (const std::size_t axis : {1u, 2u, 3u, 5u})
            QVERIFY(store.frames.back().tool[0].counts[axis] != store.frames.front().tool[0].counts[axis]);
    }

    void scriptedTrainees_data() {
        QTest::addColumn<QString>("name");
        for (const std::string_view name : operators::sphereApexOperatorNames())
            QTest::newRow(std::string(name).c_str())
                << QString::fromUtf8(name.data(), static_cast<int>(name.size()));
    }
    void scriptedTrainees() {
        QFETCH(QString, name);
        auto trainee = std::move(*operators::makeSphereApexOperator(name.toStdString(), 5));
        const auto device = std::move(*devices::SimulatedDevice::create({}, std::move(trainee)));
        QVERIFY(device->open().has_value());
        haptics::LiveInputs inputs;
        FrameStore store(60'000);
        LoopBench bench({{*device, {}}}, inputs, store, apexScene(benchExercise(2, 25.0)));
        realtime::TickSource ticks;
        inputs.post({CommandKind::start});
        resetForbiddenCounts();
        bool on = true;
        for (std::int64_t n = 0; on && n < 60'000; ++n) {
            const realtime::HapticTick now = ticks.next(n * 1'000'000);
            const TickGuard guard;
            on = bench.loop->tick(now);
        }
        QVERIFY2(forbiddenCounts().total() == 0, words(forbiddenCounts()));
        QVERIFY(!on); // both trials are over: every stage of a search was seen
        QVERIFY(store.frames.size() > kTicks);
    }

    void recordedFrames() {
        BenchDevice original(circlingPath);
        haptics::LiveInputs live;
        FrameStore store;
        LoopBench session({{original, {}}}, live, store, apexScene());
        guardedRun(*session.loop, live, nullptr);
        const auto device = devices::RecordedDevice::create(original.descriptor());
        haptics::RecordedInputs inputs;
        FrameStore again;
        LoopBench replay({{**device, {}}}, inputs, again, apexScene());
        realtime::TickSource ticks;
        resetForbiddenCounts();
        for (const core::HapticFrame& frame : store.frames) {
            const realtime::HapticTick now = ticks.next(frame.header.now_ns);
            const TickGuard guard;
            inputs.setFrame(frame);
            replay.loop->tick(now);
        }
        QVERIFY2(forbiddenCounts().total() == 0, words(forbiddenCounts()));
        QCOMPARE(again.frames.size(), store.frames.size());
    }

    void aDelayIsMeasured() {
        const auto device = gimbal(1);
        haptics::DelayRecord record;
        haptics::DelayListener listener({}, record);
        haptics::LiveInputs inputs;
        LoopBench bench({{*device, {}}}, inputs, listener,
                        std::make_unique<haptics::DelayProbe>(haptics::DelayProbeSettings{}, record));
        const ForbiddenCounts counts = guardedRun(*bench.loop, inputs, nullptr);
        QVERIFY2(counts.total() == 0, words(counts));
        QVERIFY(record.forces > 1000 && record.forces == record.places);
    }

    void swappingScenes() {
        BenchDevice device(circlingPath);
        haptics::LiveInputs inputs;
        FrameStore store;
        LoopBench bench({{device, {}}}, inputs, store, apexScene());
        realtime::TickSource ticks;
        inputs.post({CommandKind::start});
        resetForbiddenCounts();
        for (int n = 0; n < kTicks; ++n) {
            if (n % 100 == 50) {
                auto next = apexScene();
                QVERIFY(bench.scenes.offer(next));
            }
            const realtime::HapticTick now = ticks.next(static_cast<std::int64_t>(n) * 1'000'000);
            {
                const TickGuard guard;
                bench.loop->tick(now);
            }
            bench.scenes.collect();
        }
        QVERIFY2(forbiddenCounts().total() == 0, words(forbiddenCounts()));
    }
};

QTEST_APPLESS_MAIN(TestTickGuard)
#include "test_tick_guard.moc"
