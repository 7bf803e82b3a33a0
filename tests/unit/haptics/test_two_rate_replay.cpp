// SPDX-License-Identifier: GPL-3.0-or-later
// A session with a late slow model gives the same bits when it is replayed; as-fast runs too, and on a thread
// of its own.
#include "core/fp_environment.h"
#include "devices/recorded_device.h"
#include "haptics/recorded_inputs.h"
#include "haptics/slow_model_thread.h"
#include "realtime/monotonic_clock.h"
#include "support/haptic_bench.h"
#include "support/two_rate_bench.h"

#include <QtTest>
#include <chrono>
#include <cstring>
#include <thread>

using namespace chiron;
using namespace chiron::tests;
using core::CommandKind;
using simulation::SlowUpdate;

namespace {

/// Two tools on one soft dome, with commands on the way. `ticks` long.
struct Session {
    explicit Session(SlowUpdate when) : first(circlingPath), second(circlingPath) {
        simulation::SphereApexParameters p = softDome();
        p.trials = 2;
        p.trialLimit_s = 8.0;
        auto scene = std::make_unique<simulation::SphereApexScene>(p, 7);
        model = scene->slowModel();
        inputs.setSlowUpdate(when);
        bench = std::make_unique<LoopBench>(std::vector<haptics::LoopTool>{{first, {}}, {second, {}}}, inputs,
                                            store, std::move(scene));
        inputs.post({CommandKind::start});
    }
    bool tick(const realtime::HapticTick& now) noexcept {
        if (now.index() == 6'000)
            inputs.post({CommandKind::mark}); // the next trial begins while an answer is on its way
        return bench->loop->tick(now);
    }
    int applied() const {
        int count = 0;
        for (const core::HapticFrame& frame : store.frames)
            count += (frame.header.events & core::event_bits::kSlowApplied) != 0 ? 1 : 0;
        return count;
    }
    BenchDevice first, second;
    haptics::LiveInputs inputs;
    FrameStore store;
    simulation::ISlowModel* model = nullptr;
    std::unique_ptr<LoopBench> bench;
};

bool sameBits(const core::HapticFrame& a, const core::HapticFrame& b) {
    return std::memcmp(&a.header, &b.header, sizeof a.header) == 0 &&
           std::memcmp(a.tool.data(), b.tool.data(), a.tools * sizeof(core::ToolFrame)) == 0;
}

int firstDifference(const std::vector<core::HapticFrame>& recorded, const Session& session) {
    const auto first = devices::RecordedDevice::create(session.first.descriptor());
    const auto second = devices::RecordedDevice::create(session.second.descriptor());
    haptics::RecordedInputs inputs;
    FrameStore store;
    simulation::SphereApexParameters p = softDome();
    p.trials = 2;
    p.trialLimit_s = 8.0;
    LoopBench bench({{**first, {}}, {**second, {}}}, inputs, store,
                    std::make_unique<simulation::SphereApexScene>(p, 7));
    realtime::TickSource ticks;
    for (const core::HapticFrame& frame : recorded) {
        inputs.setFrame(frame);
        bench.loop->tick(ticks.next(frame.header.now_ns));
    }
    for (std::size_t n = 0; n < recorded.size(); ++n)
        if (!sameBits(recorded[n], store.frames[n]))
            return static_cast<int>(n);
    return -1;
}

/// Takes its time, now and then.
class SlowedModel final : public simulation::ISlowModel {
public:
    explicit SlowedModel(simulation::ISlowModel& model) : m_model(model) {}
    bool step() noexcept override {
        if (++m_looks % 7 == 0)
            std::this_thread::sleep_for(std::chrono::milliseconds(70));
        return m_model.step();
    }

private:
    simulation::ISlowModel& m_model;
    int m_looks = 0;
};

} // namespace

class TestTwoRateReplay : public QObject {
    Q_OBJECT
    const std::atomic<bool> m_stop{false};

private slots:
    void inLockStep() {
        Session session(SlowUpdate::asDue);
        realtime::TickSource ticks;
        for (std::int64_t n = 0; n < 10'000; ++n)
            session.tick(ticks.next(n * 1'000'000));
        QVERIFY(session.applied() > 100);
        QCOMPARE(firstDifference(session.store.frames, session), -1);
    }

    void lateWithoutAClock() {
        Session session(SlowUpdate::whenReady);
        LateModel late(*session.model, 5);
        realtime::TickSource ticks;
        for (std::int64_t n = 0; n < 10'000; ++n) {
            session.tick(ticks.next(n * 1'000'000));
            late.tick();
        }
        QVERIFY(session.applied() > 50 && session.applied() < 250); // every second or third was late
        double strongest_N = 0.0;
        for (const core::HapticFrame& frame : session.store.frames)
            strongest_N = std::max(strongest_N, frame.tool[0].tissue[2]);
        QVERIFY(strongest_N > 0.3);
        QCOMPARE(firstDifference(session.store.frames, session), -1);
        // So that it can fail: one answer a tick later is another session.
        auto changed = session.store.frames;
        std::size_t touching = 5'000;
        while ((changed[touching].header.events & core::event_bits::kSlowApplied) == 0)
            ++touching;
        changed[touching].header.events &= ~core::event_bits::kSlowApplied;
        changed[touching + 1].header.events |= core::event_bits::kSlowApplied;
        QVERIFY(firstDifference(changed, session) >= 0);
    }

    void lateOnAThreadOfItsOwn() {
        Session session(SlowUpdate::whenReady);
        SlowedModel slowed(*session.model);
        realtime::MonotonicClock clock;
        realtime::TickSource ticks;
        std::uint64_t answered = 0;
        {
            haptics::SlowModelThread thread(slowed);
            core::setModelFloatingPointEnvironment();
            for (int n = 0; n < 6'000; ++n) { // 6 s of ticks in about 1.5 s
                const std::int64_t now = clock.now_ns();
                session.tick(ticks.next(now));
                clock.waitUntil(now + 250'000);
            }
            thread.stop();
            answered = thread.answered();
        }
        QVERIFY(session.applied() > 0);
        QVERIFY(answered >= static_cast<std::uint64_t>(session.applied()));
        QCOMPARE(firstDifference(session.store.frames, session), -1);
    }
};

QTEST_APPLESS_MAIN(TestTwoRateReplay)
#include "test_two_rate_replay.moc"
