// SPDX-License-Identifier: GPL-3.0-or-later
#include "cues/laparoscopy_cues.h"
#include "modules/exercises/palpation/cues/palpation_cues.h"
#include "support/haptic_bench.h"

#include <QtTest>

using namespace chiron;
using namespace chiron::tests;
using core::Vec3;

namespace {

/// Answers every tool with the same force, and says when it is deleted.
class ConstantScene final : public simulation::IScene {
public:
    ConstantScene(const Vec3& force, int* alive) : m_force(force), m_alive(alive) { ++*m_alive; }
    ~ConstantScene() override { --*m_alive; }
    ConstantScene(const ConstantScene&) = delete;
    ConstantScene& operator=(const ConstantScene&) = delete;
    void respond(const realtime::HapticTick&, const simulation::SceneInput& in,
                 simulation::SceneOutput& out) noexcept override {
        out = {};
        out.cues = cues;
        out.events = events;
        out.trial = trial;
        out.phase = core::TrialPhase::running;
        out.tissue.count = in.tools.count;
        for (int i = 0; i < in.tools.count; ++i) {
            out.tissue.tools[static_cast<std::size_t>(i)].force = m_force;
            out.tissue.tools[static_cast<std::size_t>(i)].torque = Vec3(0.001, 0.002, 0.003);
        }
        last = in;
    }
    simulation::SceneInput last;
    core::VisibleCues cues; ///< shown at every tick
    std::uint32_t events = 0;
    std::uint16_t trial = 0;

private:
    Vec3 m_force;
    int* m_alive;
};

void run(haptics::HapticLoop& loop, realtime::TickSource& ticks, int count) {
    for (int n = 0; n < count; ++n)
        if (!loop.tick(ticks.next(static_cast<std::int64_t>(ticks.executed()) * 1'000'000)))
            return;
}

/// A loop that takes its time: 3.2 ms in tick 5.
struct SlowTask {
    haptics::HapticLoop& loop;
    realtime::VirtualClock& clock;
    int left;
    bool tick(const realtime::HapticTick& now) noexcept {
        loop.tick(now);
        clock.advance(now.index() == 5 ? 3'200'000 : 1'000);
        return --left > 0;
    }
    void timing(const realtime::TickTiming& t) noexcept { loop.timing(t); }
};

} // namespace

class TestHapticLoop : public QObject {
    Q_OBJECT
private slots:
    void aMissedDeadlineShowsInTimeAndNotInTheIndex() {
        BenchDevice device(highPath);
        haptics::LiveInputs inputs;
        FrameStore store;
        LoopBench bench({{device, {}}}, inputs, store, apexScene());
        realtime::VirtualClock clock;
        realtime::TickSource ticks;
        SlowTask task{*bench.loop, clock, 10};
        const std::atomic<bool> stop{false};
        realtime::PeriodicRunner(clock, ticks).run(task, stop);
        QCOMPARE(store.frames.size(), std::size_t{10});
        for (std::size_t n = 0; n < 10; ++n)
            QCOMPARE(store.frames[n].header.index, n);
        QCOMPARE(store.frames[5].header.now_ns, 5'000'000);
        QCOMPARE(store.frames[6].header.now_ns, 8'200'000);
        QCOMPARE(store.frames[7].header.now_ns, 9'000'000);
        QCOMPARE(bench.loop->statistics().skippedDeadlines(), 2u);
        QCOMPARE(bench.loop->statistics().late(), 1u);
        QCOMPARE(bench.loop->statistics().ticks(), 10u);
        QCOMPARE(bench.loop->display().latest().skippedDeadlines, 2u);
    }

    void theScreenIsToldEveryQuarterOfASecond() {
        BenchDevice device(highPath);
        haptics::LiveInputs inputs;
        FrameStore store;
        LoopBench bench({{device, {}}}, inputs, store, apexScene());
        const auto time = [&](int ticks) {
            for (int n = 0; n < ticks; ++n)
                bench.loop->timing({150'000, 90'000, 0});
        };
        haptics::LoopStatistics told;
        time(255);
        QVERIFY(!bench.loop->statisticsTap().read(told));
        time(1);
        QVERIFY(bench.loop->statisticsTap().read(told));
        QCOMPARE(told.ticks(), 256u);
        QCOMPARE(told.late(), 256u);
        time(255);
        QVERIFY(!bench.loop->statisticsTap().read(told));
        time(1);
        QCOMPARE(bench.loop->statisticsTap().latest().ticks(), 512u);
    }

    void twoToolsEachInItsOwnFrame() {
        BenchDevice right(highPath);
        BenchDevice left(highPath);
        haptics::LiveInputs inputs;
        FrameStore store;
        int alive = 0;
        auto scene = std::make_unique<ConstantScene>(Vec3(0.1, 0.05, 0.02), &alive);
        const ConstantScene* const watched = scene.get();
        const devices::WorkspaceMapping mirrored{
            .origin_m = {0.1, 0.0, -0.02}, .scale = 2.0, .leftHanded = true};
        LoopBench bench({{right, {}}, {left, mirrored}}, inputs, store, std::move(scene));
        realtime::TickSource ticks;
        run(*bench.loop, ticks, 2500); // arming needs 4 ticks and its ramp 2 s
        QVERIFY((watched->last.tools.tools[0].p_WT - Vec3(0.0, 0.0, 0.060)).norm() < 1e-3);
        QVERIFY(std::abs(watched->last.tools.tools[1].p_WT.z() - 0.100) < 1e-3);
        const devices::ForceCommand& r = right.received.back();
        const devices::ForceCommand& l = left.received.back();
        QVERIFY(r.enabled && l.enabled);
        QVERIFY((r.wrench_D.force - Vec3(0.1, 0.05, 0.02)).norm() < 1e-12);
        QVERIFY((l.wrench_D.force - Vec3(-0.1, 0.05, 0.02)).norm() < 1e-12);
        const core::HapticFrame& frame = store.frames.back();
        QCOMPARE(frame.tools, 2u);
        QVERIFY(frame.tool[1].commanded == frame.tool[0].commanded); // both in W
        QVERIFY(frame.tool[0].tissue == (core::Array6{0.1, 0.05, 0.02, 0.001, 0.002, 0.003}));
    }

    void aDroppedSampleIsRecordedButNotUsed() {
        BenchDevice device([](std::uint64_t tick) { return Vec3(tick < 3 ? 50.0 : 0.0, 0.0, 0.06); });
        haptics::LiveInputs inputs;
        FrameStore store;
        int alive = 0;
        auto scene = std::make_unique<ConstantScene>(Vec3(0.1, 0.0, 0.0), &alive);
        const ConstantScene* const watched = scene.get();
        LoopBench bench({{device, {}}}, inputs, store, std::move(scene));
        realtime::TickSource ticks;
        run(*bench.loop, ticks, 1);
        QVERIFY(watched->last.tools.count == 1); // the first packet is the reference, wherever it is
        // Tick 3 jumps by 1 m: dropped, and the scene goes on with the last good place.
        run(*bench.loop, ticks, 3);
        QCOMPARE(watched->last.tools.tools[0].p_WT.x(), 50.0);
        QVERIFY((store.frames.back().header.guards & core::guard_bits::kBadSample) != 0);
        QCOMPARE(store.frames.back().tool[0].counts[0], 49'000'000); // recorded as read
        QVERIFY((store.frames.back().tool[0].status & core::sample_status::kRefused) !=
                0); // and marked, for the metrics
        QVERIFY((store.frames.front().tool[0].status & core::sample_status::kRefused) == 0);
    }

    void scenesAreSwappedInTheTickAndDeletedByTheirOwner() {
        BenchDevice device(highPath);
        haptics::LiveInputs inputs;
        FrameStore store;
        int alive = 0;
        LoopBench bench({{device, {}}}, inputs, store,
                        std::make_unique<ConstantScene>(Vec3(0.1, 0, 0), &alive));
        realtime::TickSource ticks;
        run(*bench.loop, ticks, 2);
        std::unique_ptr<simulation::IScene> next = std::make_unique<ConstantScene>(Vec3(0.2, 0, 0), &alive);
        QVERIFY(bench.scenes.offer(next));
        QVERIFY(next == nullptr);
        run(*bench.loop, ticks, 2);
        QCOMPARE(store.frames[1].tool[0].tissue[0], 0.1);
        QCOMPARE(store.frames[2].tool[0].tissue[0], 0.2);
        QCOMPARE(store.frames[2].header.events, core::event_bits::kSceneChanged);
        QCOMPARE(store.frames[3].header.events, 0u);
        QCOMPARE(alive, 2);
        QCOMPARE(bench.scenes.collect(), 1);
        QCOMPARE(alive, 1);
        bench.loop.reset();
        QCOMPARE(alive, 1); // given back, not deleted, by the loop
        QCOMPARE(bench.scenes.collect(), 1);
        QCOMPARE(alive, 0);
    }

    void theExchangeNeverHoldsMoreThanItCanGiveBack() {
        BenchDevice device(highPath);
        haptics::LiveInputs inputs;
        FrameStore store;
        int alive = 0;
        {
            LoopBench bench({{device, {}}}, inputs, store,
                            std::make_unique<ConstantScene>(Vec3::Zero(), &alive));
            realtime::TickSource ticks;
            std::unique_ptr<simulation::IScene> next;
            for (int n = 0; n < 3; ++n) {
                next = std::make_unique<ConstantScene>(Vec3::Zero(), &alive);
                QVERIFY(bench.scenes.offer(next));
            }
            next = std::make_unique<ConstantScene>(Vec3::Zero(), &alive);
            QVERIFY(!bench.scenes.offer(next));
            QVERIFY(next != nullptr);
            run(*bench.loop, ticks, 5);
            QVERIFY(!bench.scenes.offer(next)); // taken, but not collected
            QCOMPARE(bench.scenes.collect(), 3);
            QVERIFY(bench.scenes.offer(next));
        }
        QCOMPARE(alive, 0); // the one never taken and the one in use
    }

    void aFullRecorderIsCountedAndTheLoopGoesOn() {
        BenchDevice device(highPath);
        haptics::LiveInputs inputs;
        FrameStore store;
        LoopBench bench({{device, {}}}, inputs, store, apexScene());
        realtime::TickSource ticks;
        run(*bench.loop, ticks, 5);
        store.full = true;
        run(*bench.loop, ticks, 3);
        store.full = false;
        run(*bench.loop, ticks, 2);
        QCOMPARE(bench.loop->droppedFrames(), 3u);
        QCOMPARE(bench.loop->display().latest().droppedFrames, 3u);
        QCOMPARE(store.frames.back().header.index, 9u);
    }

    void ageIsWholeMicrosecondsAndNeverNegative() {
        BenchDevice device(highPath);
        haptics::LiveInputs inputs;
        FrameStore store;
        LoopBench bench({{device, {}}}, inputs, store, apexScene());
        realtime::TickSource ticks;
        const std::vector<std::pair<std::int64_t, std::uint32_t>> cases{
            {0, 0},          {999, 0},
            {1'000, 1},      {1'234'567, 1'234},
            {-5'000'000, 0}, {INT64_C(9'000'000'000'000), UINT32_MAX}};
        for (const auto& [before_ns, expected_us] : cases) {
            device.arrivedBefore_ns = before_ns;
            run(*bench.loop, ticks, 1);
            QCOMPARE(store.frames.back().tool[0].age_us, expected_us);
        }
    }

    void shownForceReachesOnlyHandsThatFeelNothing() {
        BenchDevice felt(highPath, true);
        BenchDevice shown(highPath, false);
        haptics::LiveInputs inputs;
        FrameStore store;
        int alive = 0;
        LoopBench bench({{felt, {}}, {shown, {}}}, inputs, store,
                        std::make_unique<ConstantScene>(Vec3(0.0, 0.3, 0.4), &alive));
        realtime::TickSource ticks;
        run(*bench.loop, ticks, 3);
        QCOMPARE(felt.seen.shownForce_N, 0.0);
        QVERIFY(std::abs(shown.seen.shownForce_N - 0.5) < 1e-15);
        QVERIFY(!shown.received.back().enabled);
        QVERIFY(shown.received.back().wrench_D.force.isZero());
    }

    void theScreenGetsWhatTheTickKnew() {
        BenchDevice device(circlingPath);
        haptics::LiveInputs inputs;
        FrameStore store;
        LoopBench bench({{device, {.origin_m = {}, .scale = 1.0}}}, inputs, store, apexScene());
        realtime::TickSource ticks;
        inputs.post({core::CommandKind::start});
        run(*bench.loop, ticks, 6000);
        const haptics::DisplayState& shown = bench.loop->display().latest();
        const core::HapticFrame& frame = store.frames.back();
        QCOMPARE(shown.tick, frame.header.index);
        QCOMPARE(shown.tools, 1);
        QVERIFY(shown.started);
        QVERIFY(shown.force == frame.header.force);
        QVERIFY(shown.phase == core::TrialPhase::running);
        QVERIFY(shown.tool[0].tissue == frame.tool[0].tissue);
        QVERIFY(shown.tool[0].commanded == frame.tool[0].commanded);
        QCOMPARE(shown.tool[0].p_WT_m[0], frame.tool[0].counts[0] * 1e-6);
        QVERIFY(shown.tool[0].rendersForce && shown.tool[0].enabled);
        QVERIFY(shown.tool[0].tissue[2] > 0.5); // in contact
        QVERIFY(shown.tool[0].p_WProxy_m[2] > shown.tool[0].p_WT_m[2]);
        QVERIFY(shown.timeLeft_s > 0.0 && shown.timeLeft_s < 8.0);
    }

    /// Whatever the scene lets be seen is seen: each cue by itself, and none that it does not.
    void theScreenGetsEveryCue() {
        BenchDevice device(highPath);
        const auto shownOf = [&](const core::VisibleCues& cues) {
            haptics::LiveInputs inputs;
            FrameStore store;
            int alive = 0;
            auto scene = std::make_unique<ConstantScene>(Vec3(0.0, 0.0, 0.1), &alive);
            scene->cues = cues;
            scene->events = core::event_bits::kMarked;
            scene->trial = 7;
            LoopBench bench({{device, {}}}, inputs, store, std::move(scene));
            realtime::TickSource ticks;
            run(*bench.loop, ticks, 1);
            return bench.loop->display().latest();
        };
        const haptics::DisplayState none = shownOf({});
        QVERIFY(!none.objectShown && !none.exercise.holds<simulation::PalpationCues>() &&
                !none.exercise.of<simulation::PalpationCues>().present);
        QVERIFY(none.objectRadius_m == 0.0 && none.timeLeft_s == 0.0 && none.trial == 7 &&
                none.events == core::event_bits::kMarked);
        core::VisibleCues cues;
        cues.objectShown = true;
        const haptics::DisplayState object = shownOf(cues);
        QVERIFY(object.objectShown);
        cues = {};
        cues.p_WObject = Vec3(0.01, -0.02, 0.03);
        cues.objectRadius_m = 0.04;
        cues.timeLeft_s = 5.5;
        const haptics::DisplayState placed = shownOf(cues);
        QVERIFY((placed.p_WObject_m == std::array<double, 3>{0.01, -0.02, 0.03}));
        QVERIFY(placed.objectRadius_m == 0.04 && placed.timeLeft_s == 5.5 && !placed.objectShown);
        cues = {}; // an exercise's own, whole and as no other's
        cues.exercise.own<simulation::PalpationCues>().present = true;
        cues.exercise.own<simulation::PalpationCues>().squeeze_N = {0.5, 1.5};
        const haptics::DisplayState own = shownOf(cues);
        QVERIFY(own.exercise.of<simulation::PalpationCues>().present &&
                own.exercise.of<simulation::PalpationCues>().squeeze_N[1] == 1.5);
        QVERIFY(!own.exercise.holds<core::LaparoscopyCues>() &&
                !own.exercise.of<core::LaparoscopyCues>().present);
        cues.exercise.own<core::LaparoscopyCues>().stretch_m = 0.01; // another's takes its place
        const haptics::DisplayState other = shownOf(cues);
        QVERIFY(other.exercise.of<core::LaparoscopyCues>().stretch_m == 0.01 &&
                !other.exercise.of<core::LaparoscopyCues>().present);
        QVERIFY(!other.exercise.of<simulation::PalpationCues>().present);
    }

    void partsThatDoNotFitAreRefused() {
        BenchDevice device(highPath);
        haptics::LiveInputs inputs;
        FrameStore store;
        haptics::SafetySupervisor supervisor;
        haptics::SceneExchange scenes;
        QVERIFY(!haptics::HapticLoop::create({{}, inputs, supervisor, {}, scenes, store}));
        const std::vector<haptics::LoopTool> one{{device, {}}};
        const auto noScene = haptics::HapticLoop::create({one, inputs, supervisor, {}, scenes, store});
        QVERIFY(!noScene);
        QVERIFY(noScene.error().message.find("scene") != std::string::npos);
        const std::vector<haptics::LoopTool> five(5, haptics::LoopTool{device, {}});
        QVERIFY(!haptics::HapticLoop::create({five, inputs, supervisor, {}, scenes, store}));
        haptics::SafetySettings bad;
        bad.siteForce_N = -1.0;
        QVERIFY(!haptics::HapticLoop::create({one, inputs, supervisor, bad, scenes, store}));
    }
};

QTEST_APPLESS_MAIN(TestHapticLoop)
#include "test_haptic_loop.moc"
