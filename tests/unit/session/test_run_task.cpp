// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/drivers/replay/replay_device.h"
#include "session/run_task.h"
#include "support/haptic_bench.h"

#include <QtTest>

using namespace chiron;
using core::CommandKind;
using devices::TracePoint;

namespace {

/// A loop around a device, driven by a RunTask until it says that it is over.
class Run {
public:
    Run(devices::IDevice& device, double limit_s)
        : m_loop({{device, {}}}, m_inputs, m_sink, tests::apexScene(tests::benchExercise(2, limit_s))) {
        m_inputs.post({CommandKind::start});
    }
    /// `cancelAt`: the tick after which cancel is set.
    bool go(session::RunLimits limits, std::uint64_t most, std::uint64_t cancelAt = ~0ull) {
        std::atomic<bool> cancel{false};
        limits.cancel = &cancel;
        session::RunTask task(*m_loop.loop, m_inputs, m_sink, limits);
        realtime::TickSource ticks;
        for (std::uint64_t i = 0; i < most; ++i) {
            if (i == cancelAt)
                cancel = true;
            if (!task.tick(ticks.next(static_cast<std::int64_t>(i) * 1'000'000)))
                return true;
        }
        return false;
    }
    const std::vector<core::HapticFrame>& frames() const { return m_store.frames; }
    /// Tick and kind of every command after the start.
    std::vector<std::pair<std::uint64_t, CommandKind>> commands() const {
        std::vector<std::pair<std::uint64_t, CommandKind>> all;
        for (const core::HapticFrame& frame : m_store.frames) {
            for (const core::Command& command : frame.header.commands) {
                if (command.kind != CommandKind::none && command.kind != CommandKind::start)
                    all.emplace_back(frame.header.index, command.kind);
            }
        }
        return all;
    }

private:
    tests::FrameStore m_store;
    session::TeeSink m_sink{m_store, nullptr};
    haptics::LiveInputs m_inputs;
    tests::LoopBench m_loop;
};

using Commands = std::vector<std::pair<std::uint64_t, CommandKind>>;

std::unique_ptr<devices::ReplayDevice> traceOf(double seconds) {
    return std::move(
        *devices::ReplayDevice::create({TracePoint{.t_s = 0.0, .p_WT_m = core::Vec3(0.0, 0.0, 0.06)},
                                        TracePoint{.t_s = seconds, .p_WT_m = core::Vec3(0.01, 0.0, 0.06)}}));
}

} // namespace

class TestRunTask : public QObject {
    Q_OBJECT
private slots:
    void endOfATraceMarksThenEnds();
    void endOfATraceBetweenTrialsOnlyEnds();
    void cancelEnds();
    void cancelOfATraceDoesNotMark();
    void tickLimitEnds();
    void exerciseEndsByItself();
    void witnessSeesWhatIsRecorded();
};

void TestRunTask::endOfATraceMarksThenEnds() {
    const auto device = traceOf(4.0);
    QVERIFY(device->open());
    Run run(*device, 60.0);
    QVERIFY(run.go({.tickLimit = 100'000, .device = device.get()}, 10'000));
    const std::uint64_t last = run.frames().back().header.index;
    QCOMPARE(run.commands(), (Commands{{last - 1, CommandKind::mark}, {last, CommandKind::end}}));
    QVERIFY(last >= 4000 && last < 4010);
    const core::HapticFrame& marked = run.frames()[last - 1];
    QVERIFY(marked.header.events & core::event_bits::kMarked);
    QCOMPARE(marked.tool[0].counts[0], 10'000); // the trace's last position, 10 mm on a grid of 1 µm
}

void TestRunTask::endOfATraceBetweenTrialsOnlyEnds() {
    const auto device = traceOf(1.5);
    QVERIFY(device->open());
    Run run(*device, 1.0); // the first trial times out, the second is still to come
    QVERIFY(run.go({.tickLimit = 100'000, .device = device.get()}, 10'000));
    QVERIFY(run.frames().back().header.phase == core::TrialPhase::between);
    for (const auto& [tick, kind] : run.commands())
        QCOMPARE(kind, CommandKind::end);
    for (const core::HapticFrame& frame : run.frames())
        QVERIFY(!(frame.header.events & core::event_bits::kMarked));
}

void TestRunTask::cancelEnds() {
    tests::BenchDevice device(tests::circlingPath);
    Run run(device, 60.0);
    QVERIFY(run.go({.tickLimit = 100'000}, 10'000, 5000));
    QCOMPARE(run.commands().front(), (std::pair<std::uint64_t, CommandKind>{5001, CommandKind::end}));
    QCOMPARE(run.frames().back().header.index, std::uint64_t{5001}); // and with the next tick it is over
    QCOMPARE(core::toWrench(run.frames().back().tool[0].commanded).force.norm(), 0.0);
}

void TestRunTask::cancelOfATraceDoesNotMark() {
    const auto device = traceOf(60.0);
    QVERIFY(device->open());
    Run run(*device, 60.0);
    QVERIFY(run.go({.tickLimit = 100'000, .device = device.get()}, 10'000, 5000));
    QVERIFY(run.frames()[5000].header.phase == core::TrialPhase::running); // there was something to mark
    QCOMPARE(run.commands().front().second, CommandKind::end);
    for (const core::HapticFrame& frame : run.frames())
        QVERIFY(!(frame.header.events & core::event_bits::kMarked));
}

void TestRunTask::tickLimitEnds() {
    tests::BenchDevice device(tests::circlingPath);
    Run run(device, 60.0);
    QVERIFY(run.go({.tickLimit = 3000}, 10'000));
    QCOMPARE(run.frames().back().header.index, std::uint64_t{3001});
    QCOMPARE(run.commands().front(), (std::pair<std::uint64_t, CommandKind>{3001, CommandKind::end}));
}

void TestRunTask::exerciseEndsByItself() {
    tests::BenchDevice device(tests::highPath);
    Run run(device, 1.0); // two trials that time out
    QVERIFY(run.go({.tickLimit = 100'000}, 30'000));
    QVERIFY(run.commands().empty());
    QVERIFY(run.frames().back().header.phase == core::TrialPhase::finished);
}

void TestRunTask::witnessSeesWhatIsRecorded() {
    tests::FrameStore recording(2);
    tests::FrameStore witness;
    session::TeeSink tee(recording, &witness);
    core::HapticFrame frame;
    for (std::uint64_t i = 0; i < 3; ++i) {
        frame.header.index = i;
        frame.header.phase = i == 2 ? core::TrialPhase::between : core::TrialPhase::running;
        QCOMPARE(tee.tryPush(frame), i < 2); // what the recording says is what counts
    }
    QCOMPARE(witness.frames.size(), std::size_t{3});
    QVERIFY(tee.phase() == core::TrialPhase::between);
    witness.full = true;
    tests::FrameStore room;
    session::TeeSink full(room, &witness);
    QVERIFY(full.tryPush(frame));
}

QTEST_APPLESS_MAIN(TestRunTask)
#include "test_run_task.moc"
