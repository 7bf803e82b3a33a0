// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact_bits.h"
#include "core/fp_environment.h"
#include "session/level_cues.h"
#include "session/run_task.h"
#include "session/station.h"
#include "support/haptic_bench.h"
#include "support/session_fixture.h"

#include <QtTest>

using namespace chiron;
using core::CommandKind;
using core::ForceState;

namespace {

constexpr std::int64_t kFrame_ns = 16'666'667; // a window of 60 Hz
constexpr std::int64_t kSecond_ns = 1'000'000'000;

/// A window and its loop on one virtual clock: each tick first does what the GUI thread would have done by
/// then.
class WindowedRun {
public:
    WindowedRun(tests::LoopBench& bench, session::LiveLink& link, session::TeeSink& sink, bool beats)
        : m_link(link), m_task(*bench.loop, link.inputs(), sink, {~0ull, nullptr, nullptr, &link}),
          m_beats(beats) {
        link.inputs().beat(0);
    }
    /// The GUI thread does nothing in [from, to) of the clock.
    void stall(std::int64_t from_ns, std::int64_t to_ns) {
        m_stallFrom_ns = from_ns;
        m_stallTo_ns = to_ns;
    }
    bool tick(const realtime::HapticTick& now) noexcept {
        const bool stalled = now.now_ns() >= m_stallFrom_ns && now.now_ns() < m_stallTo_ns;
        if (m_beats && !stalled && now.now_ns() >= m_nextFrame_ns) {
            m_link.inputs().beat(now.now_ns());
            m_nextFrame_ns = now.now_ns() + kFrame_ns;
            session::LiveSample sample;
            while (m_link.samples().tryPop(sample))
                ++drained;
        }
        m_task.tick(now);
        return ++executed < ticks;
    }
    void timing(const realtime::TickTiming& timing) noexcept { m_task.timing(timing); }

    std::uint64_t ticks = 0;
    std::uint64_t executed = 0;
    std::uint64_t drained = 0;

private:
    session::LiveLink& m_link;
    session::RunTask m_task;
    bool m_beats;
    std::int64_t m_nextFrame_ns = 0;
    std::int64_t m_stallFrom_ns = 0;
    std::int64_t m_stallTo_ns = 0;
};

/// Presses on the ball after arming, so that there is a force to lose.
struct Run {
    explicit Run(bool beats) : window(bench, link, sink, beats) { link.inputs().post({CommandKind::start}); }
    realtime::RunReport go(std::uint64_t ticks) {
        realtime::VirtualClock clock;
        realtime::TickSource source;
        std::atomic<bool> stop{false};
        window.ticks = ticks;
        return realtime::PeriodicRunner(clock, source).run(window, stop);
    }
    const core::HapticFrame& at(std::size_t tick) const { return store.frames[tick]; }

    tests::BenchDevice device{tests::circlingPath};
    tests::FrameStore store{20'000};
    session::TeeSink sink{store, nullptr};
    std::unique_ptr<session::LiveLink> own = std::make_unique<session::LiveLink>();
    session::LiveLink& link = *own;
    tests::LoopBench bench{
        {{device, {}}}, link.inputs(), sink, tests::apexScene(tests::benchExercise(1, 60.0))};
    WindowedRun window;
};

double normOf(const core::Array6& wrench) {
    return std::hypot(wrench[0], wrench[1], wrench[2]);
}

/// The largest rise of the commanded force from one tick to the next, measured as the supervisor's slew stage
/// does: from what is left when the last force only gives way.
double largestStep_N(const std::vector<core::HapticFrame>& frames) {
    double largest = 0.0;
    for (std::size_t n = 1; n < frames.size(); ++n) {
        const core::Vec3 before = core::toWrench(frames[n - 1].tool[0].commanded).force;
        const core::Vec3 now = core::toWrench(frames[n].tool[0].commanded).force;
        const double share =
            before.squaredNorm() > 0.0 ? std::clamp(now.dot(before) / before.squaredNorm(), 0.0, 1.0) : 0.0;
        largest = std::max(largest, (now - share * before).norm());
    }
    return largest;
}

} // namespace

class TestLiveLink : public QObject {
    Q_OBJECT
private slots:
    void aStalledWindowDelaysNoTick();
    void aWindowThatNeverBeatsIsHeld();
    void samplesAreWhole();
    void aSampleHasAllThatTheStateSays();
    void aFullRingDropsAndCounts();
    void ownCommandsAndTheWindowsBothArrive();
    void mouseStationReachesTheSameBox();
    void mappingsOutOfRangeAreRefused_data();
    void mappingsOutOfRangeAreRefused();
    void cuesFollowTheDevice();
};

void TestLiveLink::aSampleHasAllThatTheStateSays() {
    haptics::DisplayState shown;
    shown.tools = 2;
    shown.tick = 7;
    shown.now_ns = 1'500'000'000;
    for (std::size_t i = 0; i < 3; ++i) {
        const double a = static_cast<double>(i) + 1.0;
        shown.tool[0].tissue[i] = 0.25 * a;
        shown.tool[0].tissue[i + 3] = 0.125 * a;
        shown.tool[0].commanded[i] = 0.5 * a;
        shown.tool[0].v_WT_m_per_s[i] = 0.0625 * a;
        shown.tool[0].p_WT_m[i] = 0.75 * a;
        shown.tool[0].p_WProxy_m[i] = 0.5 * a;
    }
    for (std::size_t i = 0; i < 4; ++i)
        shown.tool[0].q_WT[i] = 0.125 * static_cast<double>(i + 1);
    shown.tool[1].p_WProxy_m = {4.0, 5.0, 6.0};
    shown.tool[1].displayPose[0] = 0.875;
    shown.tool[1].contact = core::contact_bits::kThrough | core::contact_bits::kBeyondChecked;
    QVERIFY(!session::liveSampleOf(shown, 1'000'000'000).yielded);
    shown.tool[2].contact = core::contact_bits::kYielded; // of no tool
    QVERIFY(!session::liveSampleOf(shown, 1'000'000'000).yielded);
    shown.tool[1].contact = core::contact_bits::kYielded | core::contact_bits::kThrough;
    const session::LiveSample sample = session::liveSampleOf(shown, 1'000'000'000);
    QVERIFY(sample.yielded);             // whichever of the tools it was
    const double norm = std::sqrt(14.0); // of (1, 2, 3)
    QCOMPARE(sample.tick, std::uint64_t{7});
    QCOMPARE(sample.t_s, 0.5);
    for (std::size_t i = 0; i < 3; ++i) {
        QCOMPARE(sample.tissue_N[i], static_cast<float>(shown.tool[0].tissue[i]));
        QCOMPARE(sample.p_WT_m[i], static_cast<float>(shown.tool[0].p_WT_m[i]));
    }
    for (std::size_t i = 0; i < 4; ++i)
        QCOMPARE(sample.q_WT[i], static_cast<float>(shown.tool[0].q_WT[i]));
    QCOMPARE(sample.tissueNorm_N, static_cast<float>(0.25 * norm));
    QCOMPARE(sample.torque_Nm, static_cast<float>(0.125 * norm));
    QCOMPARE(sample.commanded_N, static_cast<float>(0.5 * norm));
    QCOMPARE(sample.speed_m_per_s, static_cast<float>(0.0625 * norm));
    QCOMPARE(sample.depth_m, static_cast<float>(0.25 * norm));
    QCOMPARE(sample.press[0][0], 0.5f);
    QCOMPARE(sample.press[1][0], 4.0f);
    QCOMPARE(sample.press[1][1], 5.0f);
    QCOMPARE(sample.press[1][2], 0.875f);
    QCOMPARE(sample.press[2][0], 0.0f); // no third tool
}

void TestLiveLink::aStalledWindowDelaysNoTick() {
    constexpr std::int64_t kFrom_ns = 6 * kSecond_ns;
    constexpr std::uint64_t kTicks = 12'000;
    Run run(true);
    run.window.stall(kFrom_ns, kFrom_ns + kSecond_ns);
    const realtime::RunReport report = run.go(kTicks);
    QCOMPARE(report.executed, kTicks);
    QCOMPARE(report.skipped, std::uint64_t{0});
    QCOMPARE(run.store.frames.size(), std::size_t{kTicks});
    for (std::size_t n = 0; n < kTicks; ++n)
        QCOMPARE(run.at(n).header.index, std::uint64_t{n});
    const haptics::SafetySettings safety;
    QVERIFY(largestStep_N(run.store.frames) <= safety.slewForce_N_per_ms * 1.000001);
    QVERIFY(largestStep_N(run.store.frames) > 0.0);
    // Full force before; held and gone during the stall; armed again after it.
    QVERIFY(run.at(5'900).header.force == ForceState::on && normOf(run.at(5'900).tool[0].commanded) > 0.1);
    const core::HapticFrame& held = run.at(6'990);
    QVERIFY(held.header.force == ForceState::heldByHeartbeat);
    QVERIFY((held.header.guards & core::guard_bits::kHeartbeat) != 0);
    QCOMPARE(normOf(held.tool[0].commanded), 0.0);
    QVERIFY(normOf(held.tool[0].tissue) > 0.1); // there was something to feel
    QVERIFY(run.at(7'100).header.force == ForceState::arming);
    QCOMPARE(
        run.window.drained +
            [&] {
                std::uint64_t left = 0;
                for (session::LiveSample sample; run.link.samples().tryPop(sample);)
                    ++left;
                return left;
            }(),
        kTicks);
}

void TestLiveLink::aWindowThatNeverBeatsIsHeld() {
    Run run(false);
    run.go(1'000);
    for (std::size_t n = 0; n < 1'000; ++n)
        QCOMPARE((run.at(n).header.guards & core::guard_bits::kHeartbeat) != 0, n >= 250);
    QCOMPARE(run.at(999).header.heartbeatAge_ms, std::uint16_t{999});
}

void TestLiveLink::samplesAreWhole() {
    Run run(false);
    run.go(5'000);
    session::LiveSample sample;
    bool touched = false;
    for (std::size_t n = 0; n < 5'000; ++n) {
        QVERIFY(run.link.samples().tryPop(sample));
        const core::HapticFrame& frame = run.at(n);
        QCOMPARE(sample.tick, frame.header.index);
        QCOMPARE(sample.t_s, static_cast<double>(n) * 1e-3);
        QCOMPARE(sample.tissueNorm_N, static_cast<float>(normOf(frame.tool[0].tissue)));
        QCOMPARE(sample.commanded_N, static_cast<float>(normOf(frame.tool[0].commanded)));
        QCOMPARE(sample.events, frame.header.events);
        QCOMPARE(sample.guards, frame.header.guards);
        QCOMPARE(sample.depth_m > 0.0f, sample.tissueNorm_N > 0.0f);
        QVERIFY(sample.phase == frame.header.phase);
        touched = touched || sample.depth_m > 0.0f;
    }
    QVERIFY(touched);
    QCOMPARE(run.link.display().latest().tick, std::uint64_t{4'999});
    QCOMPARE(run.link.statistics().latest().ticks(), std::uint64_t{4'864}); // 19 times 256
}

void TestLiveLink::aFullRingDropsAndCounts() {
    Run run(false);
    run.go(session::LiveLink::kSamples + 100);
    QCOMPARE(run.link.droppedSamples(), std::uint64_t{100});
    QCOMPARE(run.store.frames.size(), session::LiveLink::kSamples + 100); // the recording is untouched
}

void TestLiveLink::ownCommandsAndTheWindowsBothArrive() {
    haptics::LiveInputs inputs;
    for (const CommandKind kind : {CommandKind::pause, CommandKind::resume, CommandKind::mark})
        QVERIFY(inputs.post({kind}));
    QVERIFY(inputs.postOwn({CommandKind::end}));
    realtime::TickSource ticks;
    haptics::TickInputs in;
    const auto kinds = [&] {
        inputs.gather(ticks.next(0), {}, in);
        return std::pair(in.commands[0].kind, in.commands[1].kind);
    };
    QVERIFY(kinds() == std::pair(CommandKind::end, CommandKind::pause));
    QVERIFY(kinds() == std::pair(CommandKind::resume, CommandKind::mark));
    QVERIFY(kinds() == std::pair(CommandKind::none, CommandKind::none));
    QVERIFY(inputs.postOwn({CommandKind::mark}) && inputs.postOwn({CommandKind::end}));
    QVERIFY(!inputs.postOwn({CommandKind::end}));
}

void TestLiveLink::mouseStationReachesTheSameBox() {
    for (const double scale : {0.5, 1.0, 2.0}) {
        auto station = session::keyboardMouseStation({.scale = scale, .origin_m = {0.010, 0.0, 0.0}});
        QVERIFY2(station, station ? "" : station.error().message.c_str());
        QCOMPARE(station->pointers().size(), std::size_t(1));
        QVERIFY(station->operatorName.empty());
        const devices::WorkspaceMap map(station->tools.front().mapping);
        const auto& axes = station->tools.front().device->descriptor().axes;
        const core::Vec3 low = map.pointToW({axes[0].minimum, axes[1].minimum, axes[2].minimum});
        const core::Vec3 high = map.pointToW({axes[0].maximum, axes[1].maximum, axes[2].maximum});
        QVERIFY((low - core::Vec3(-0.070, -0.080, -0.030)).norm() < 1e-9);
        QVERIFY((high - core::Vec3(0.090, 0.080, 0.080)).norm() < 1e-9);
    }
}

void TestLiveLink::mappingsOutOfRangeAreRefused_data() {
    QTest::addColumn<double>("scale");
    QTest::addColumn<double>("shift_m");
    QTest::newRow("small") << 0.2 << 0.0;
    QTest::newRow("large") << 4.1 << 0.0;
    QTest::newRow("not a number") << std::nan("") << 0.0;
    QTest::newRow("far") << 1.0 << 0.031;
    QTest::newRow("far the other way") << 1.0 << -0.031;
}

void TestLiveLink::mappingsOutOfRangeAreRefused() {
    QFETCH(double, scale);
    QFETCH(double, shift_m);
    const session::WorkspaceChoice choice{.scale = scale, .origin_m = {0.0, shift_m, 0.0}};
    QVERIFY(!session::mappingOf(choice));
    QVERIFY(!session::keyboardMouseStation(choice));
}

void TestLiveLink::cuesFollowTheDevice() {
    const catalogue::ExerciseLevel visible = tests::shortLevel(1, 1, 1.0);
    QVERIFY(session::cuesOf(visible, true).object && session::cuesOf(visible, false).object);
    const catalogue::ExerciseLevel alone = tests::shortLevel(2, 1, 1.0);
    QVERIFY(alone.needsForce);
    QVERIFY(!session::cuesOf(alone, true).object && !session::cuesOf(alone, true).arrow);
    QVERIFY(!session::cuesOf(alone, false).object);
    QCOMPARE(session::cuesOf(alone, false).arrow,
             std::count(alone.shownForce->cues.begin(), alone.shownForce->cues.end(), "arrow") == 1);
}

QTEST_APPLESS_MAIN(TestLiveLink)
#include "test_live_link.moc"
