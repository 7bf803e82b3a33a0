// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/drivers/keyboard_mouse/keyboard_mouse_device.h"
#include "devices/drivers/simulated/simulated_endoscope_device.h"
#include "devices/recorded_device.h"
#include "haptics/recorded_inputs.h"
#include "modules/exercises/urethra_insertion/cues/procedure_bits.h"
#include "modules/exercises/urethra_insertion/operators/urethra_insertion_operator.h"
#include "realtime/guarded_run.h"
#include "support/urethra_bench.h"

#include <QtTest>

using namespace chiron;
using namespace chiron::tests;

namespace {

simulation::UrethraInsertionParameters exercise(const QString& kind) {
    simulation::UrethraInsertionParameters p = wholeProcedure();
    if (kind == "stricture") {
        p.anatomy.changes[0] = {0.075, 0.012, 0.004, 0.0015, 15.0, 1.0};
        p.anatomy.changeCount = 1;
    }
    if (kind == "p1 sections")
        p.forces.sections = simulation::ForceSections::p1Basic;
    if (kind == "blind")
        p.cues = {"tool"};
    return p;
}

std::unique_ptr<simulation::IScene> urethraScene(const QString& kind) {
    return std::make_unique<simulation::UrethraInsertionScene>(exercise(kind));
}

/// Outside for 3 s (arming and its ramp), then 70 mm along the centre-line and about it, for a device without
/// orientation.
core::Vec3 insertingPath(std::uint64_t tick) {
    const simulation::AnatomyPose pose;
    const double t = static_cast<double>(tick) * core::kTickSeconds;
    const double z = -0.015 + 0.020 * std::clamp(t - 3.0, 0.0, 3.5);
    return pose.pointToW(core::Vec3(0.002 * std::sin(2.0 * t), z > 0.0 ? 13.0 * z * z : 0.0, z));
}

} // namespace

/// 10,000 ticks of every kind of urethra: nothing is allocated, locked or thrown in any of them.
class TestUrethraGuard : public QObject {
    Q_OBJECT

    void everyKind() {
        QTest::addColumn<QString>("kind");
        for (const char* kind : {"plain", "stricture", "p1 sections", "blind"})
            QTest::newRow(kind) << QString(kind);
    }

private slots:
    void wholeProcedureOfTheScene_data() { everyKind(); }
    void wholeProcedureOfTheScene() {
        QFETCH(QString, kind);
        const simulation::UrethraInsertionParameters p = exercise(kind);
        simulation::UrethraInsertionScene scene(p);
        IdealProcedure hand(p, 0.050);
        realtime::TickSource ticks;
        simulation::SceneInput in;
        simulation::SceneOutput out;
        in.started = in.forceReady = true;
        in.tools.count = 1;
        std::uint32_t events = 0;
        resetForbiddenCounts();
        for (int n = 0; n < kTicks; ++n) {
            in.tools.tools[0] = hand.next(scene.procedure().stage(), scene.procedure().nextLandmark());
            in.paused = n > 4000 && n < 4100;
            const realtime::HapticTick now = ticks.next(0);
            const TickGuard guard;
            scene.respond(now, in, out);
            events |= out.events;
        }
        QVERIFY2(forbiddenCounts().total() == 0, words(forbiddenCounts()));
        using namespace core::event_bits;
        using simulation::procedure_bits::kLandmarkSeen;
        const std::uint32_t all = kTrialStarted | kContactBegan | kStageChanged | kLandmarkSeen |
                                  kContactEnded | kCompleted | kFinished;
        QCOMPARE(events & all, all); // the run went all the way
    }

    void benchDevices_data() { everyKind(); }
    void benchDevices() {
        QFETCH(QString, kind);
        BenchDevice a(insertingPath);
        BenchDevice b(highPath);
        haptics::LiveInputs inputs;
        FrameStore store;
        LoopBench bench({{a, {}}, {b, {}}}, inputs, store, urethraScene(kind));
        const ForbiddenCounts counts = guardedRun(*bench.loop, inputs, nullptr);
        QVERIFY2(counts.total() == 0, words(counts));
        double strongest_N = 0.0;
        for (const core::HapticFrame& frame : store.frames)
            strongest_N = std::max(strongest_N, core::toWrench(frame.tool[0].commanded).force.norm());
        QVERIFY2(strongest_N > 0.1, qPrintable(QString::number(strongest_N))); // the run did touch
    }

    void keyboardAndMouse_data() { everyKind(); }
    void keyboardAndMouse() {
        QFETCH(QString, kind);
        const auto device = devices::KeyboardMouseDevice::create();
        haptics::LiveInputs inputs;
        FrameStore store;
        LoopBench bench({{**device, {}}}, inputs, store, urethraScene(kind));
        const ForbiddenCounts counts = guardedRun(*bench.loop, inputs, &(*device)->mailbox());
        QVERIFY2(counts.total() == 0, words(counts));
    }

    void scriptedEndoscopists_data() {
        QTest::addColumn<QString>("name");
        for (const std::string_view name : operators::urethraInsertionOperatorNames())
            QTest::newRow(std::string(name).c_str())
                << QString::fromUtf8(name.data(), static_cast<int>(name.size()));
    }
    void scriptedEndoscopists() {
        QFETCH(QString, name);
        auto mind = std::move(*operators::makeUrethraInsertionOperator(name.toStdString(), 5));
        const auto device = std::move(*devices::SimulatedEndoscopeDevice::create({}, std::move(mind)));
        QVERIFY(device->open().has_value());
        haptics::LiveInputs inputs;
        FrameStore store(120'000);
        simulation::UrethraInsertionParameters p = exercise("plain");
        p.trialLimit_s = 110.0;
        LoopBench bench({{*device, {}}}, inputs, store,
                        std::make_unique<simulation::UrethraInsertionScene>(p));
        realtime::TickSource ticks;
        inputs.post({core::CommandKind::start, 0});
        resetForbiddenCounts();
        bool on = true;
        for (std::int64_t n = 0; on && n < 120'000; ++n) {
            const realtime::HapticTick now = ticks.next(n * 1'000'000);
            const TickGuard guard;
            on = bench.loop->tick(now);
        }
        QVERIFY2(forbiddenCounts().total() == 0, words(forbiddenCounts()));
        std::uint32_t events = 0;
        for (const core::HapticFrame& frame : store.frames)
            events |= frame.header.events;
        QVERIFY((events & core::event_bits::kCompleted) !=
                0); // in, round and out again: all of the mind was at work
    }

    void recordedFrames() {
        BenchDevice original(insertingPath);
        haptics::LiveInputs live;
        FrameStore store;
        LoopBench session({{original, {}}}, live, store, urethraScene("plain"));
        guardedRun(*session.loop, live, nullptr);
        const auto device = devices::RecordedDevice::create(original.descriptor());
        haptics::RecordedInputs inputs;
        FrameStore again;
        LoopBench replay({{**device, {}}}, inputs, again, urethraScene("plain"));
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
        for (std::size_t i = 0; i < store.frames.size(); ++i)
            QVERIFY(again.frames[i].tool[0].tissue == store.frames[i].tool[0].tissue);
    }
};

QTEST_APPLESS_MAIN(TestUrethraGuard)
#include "test_urethra_guard.moc"
