// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/recorded_device.h"
#include "haptics/recorded_inputs.h"
#include "support/haptic_bench.h"

#include <QtTest>
#include <cstring>

using namespace chiron;
using namespace chiron::tests;
using core::CommandKind;

namespace {

const devices::WorkspaceMapping kMirrored{.origin_m = {0.005, 0.0, 0.0}, .scale = 1.0, .leftHanded = true};

/// A session of two tools with commands on the way, as a task for any runner. 12 s.
struct Session {
    Session()
        : first(circlingPath), second(circlingPath),
          bench({{first, {}}, {second, kMirrored}}, inputs, store, apexScene()) {
        inputs.post({CommandKind::start});
    }
    bool tick(const realtime::HapticTick& now) noexcept {
        switch (now.index()) {
        case 4'800:
            inputs.post({CommandKind::mark});
            break;
        case 5'000:
            inputs.post({CommandKind::pause});
            break;
        case 5'600:
            inputs.post({CommandKind::resume});
            inputs.post({CommandKind::confirmHold});
            break;
        case 7'000:
            inputs.post({CommandKind::stopForce});
            break;
        case 7'050:
            inputs.post({CommandKind::rearm});
            break;
        case 11'999:
            inputs.post({CommandKind::end});
            break;
        default:
            break;
        }
        return bench.loop->tick(now);
    }
    BenchDevice first;
    BenchDevice second;
    haptics::LiveInputs inputs;
    FrameStore store;
    LoopBench bench;
};

/// The same on a machine that is often late: every tick wakes some hundred microseconds late, some take
/// milliseconds.
struct BusySession : Session {
    explicit BusySession(realtime::VirtualClock& clock) : m_clock(clock) {}
    bool tick(const realtime::HapticTick& now) noexcept {
        m_clock.advance(now.index() % 97 == 0 ? 2'400'000 : 3'000);
        m_clock.delayNextWake(static_cast<std::int64_t>(now.index() * 7919 % 400'000));
        return Session::tick(now);
    }
    realtime::VirtualClock& m_clock;
};

bool sameBits(const core::HapticFrame& a, const core::HapticFrame& b) {
    return a.layout == b.layout && a.tools == b.tools &&
           std::memcmp(&a.header, &b.header, sizeof a.header) == 0 &&
           std::memcmp(a.tool.data(), b.tool.data(), a.tools * sizeof(core::ToolFrame)) == 0;
}

std::vector<core::HapticFrame> replayOf(const std::vector<core::HapticFrame>& recorded,
                                        const Session& session) {
    const auto first = devices::RecordedDevice::create(session.first.descriptor());
    const auto second = devices::RecordedDevice::create(session.second.descriptor());
    haptics::RecordedInputs inputs;
    FrameStore store;
    LoopBench bench({{**first, {}}, {**second, kMirrored}}, inputs, store, apexScene());
    realtime::TickSource ticks;
    for (const core::HapticFrame& frame : recorded) {
        inputs.setFrame(frame);
        bench.loop->tick(ticks.next(frame.header.now_ns));
    }
    return store.frames;
}

int firstDifference(const std::vector<core::HapticFrame>& a, const std::vector<core::HapticFrame>& b) {
    for (std::size_t n = 0; n < std::min(a.size(), b.size()); ++n)
        if (!sameBits(a[n], b[n]))
            return static_cast<int>(n);
    return -1;
}

} // namespace

class TestLoopReplay : public QObject {
    Q_OBJECT

    const std::atomic<bool> m_stop{false};

private slots:
    void aReplayGivesTheSameBits() {
        Session session;
        realtime::TickSource ticks;
        realtime::AsFastRunner(ticks).run(session, m_stop);
        QCOMPARE(session.store.frames.size(), std::size_t{12'000});
        double strongest_N = 0.0;
        for (const core::HapticFrame& frame : session.store.frames)
            strongest_N = std::max(strongest_N, frame.tool[1].commanded[2]);
        QVERIFY2(strongest_N > 0.5, "the session must have felt something");
        const auto replayed = replayOf(session.store.frames, session);
        QCOMPARE(replayed.size(), session.store.frames.size());
        QCOMPARE(firstDifference(session.store.frames, replayed), -1);
    }

    void aReplayOfALateSessionGivesTheSameBits() {
        realtime::VirtualClock clock(123'456'789);
        BusySession session(clock);
        realtime::TickSource ticks;
        const realtime::RunReport report = realtime::PeriodicRunner(clock, ticks).run(session, m_stop);
        QVERIFY(report.skipped > 100);
        QCOMPARE(firstDifference(session.store.frames, replayOf(session.store.frames, session)), -1);
    }

    void oneChangedCountIsFound() {
        Session session;
        realtime::TickSource ticks;
        realtime::AsFastRunner(ticks).run(session, m_stop);
        auto recorded = session.store.frames;
        std::size_t touching = 4'100;
        while (touching < 5'000 && recorded[touching].tool[0].tissue[2] < 0.5)
            ++touching;
        QVERIFY(touching < 5'000);
        recorded[touching].tool[0].counts[2] -= 1; // 1 µm deeper
        QCOMPARE(firstDifference(session.store.frames, replayOf(recorded, session)),
                 static_cast<int>(touching));
        QVERIFY(replayOf(recorded, session)[touching].tool[0].tissue !=
                session.store.frames[touching].tool[0].tissue);
        recorded = session.store.frames;
        recorded[4'800].header.commands[0] = {}; // the mark is gone
        QCOMPARE(firstDifference(recorded, replayOf(recorded, session)), 4'800);
    }

    /// A tick-stepped device does not know what time it is: late and as-fast runs give the same frames but
    /// for now_ns.
    void realTimeAndAsFastRunsAreTheSame() {
        Session fast;
        realtime::TickSource fastTicks;
        realtime::AsFastRunner(fastTicks).run(fast, m_stop);
        realtime::VirtualClock clock;
        BusySession late(clock);
        realtime::TickSource lateTicks;
        realtime::PeriodicRunner(clock, lateTicks).run(late, m_stop);
        auto timeless = late.store.frames;
        QCOMPARE(timeless.size(), fast.store.frames.size());
        QVERIFY(timeless[6'000].header.now_ns != fast.store.frames[6'000].header.now_ns);
        for (std::size_t n = 0; n < timeless.size(); ++n)
            timeless[n].header.now_ns = fast.store.frames[n].header.now_ns;
        QCOMPARE(firstDifference(timeless, fast.store.frames), -1);
    }
};

QTEST_APPLESS_MAIN(TestLoopReplay)
#include "test_loop_replay.moc"
