// SPDX-License-Identifier: GPL-3.0-or-later
#include "realtime/guarded_run.h"
#include "realtime/tick_guard.h"
#include "session/run_task.h"

#include <QtTest>

using namespace chiron;
using namespace chiron::tests;

/// A window's taps, full ring included, do nothing in a tick that a tick must not.
class TestLiveLinkGuard : public QObject {
    Q_OBJECT
private slots:
    void tapsOfAWindow() {
        BenchDevice device(circlingPath);
        FrameStore store;
        session::TeeSink sink(store, nullptr);
        const auto link = std::make_unique<session::LiveLink>();
        LoopBench bench({{device, {}}}, link->inputs(), sink, apexScene(benchExercise(1, 60.0)));
        session::RunTask task(*bench.loop, link->inputs(), sink, {9'990, nullptr, nullptr, link.get()});
        link->inputs().post({core::CommandKind::start});
        realtime::TickSource ticks;
        resetForbiddenCounts();
        for (std::int64_t n = 0; n < 10'000; ++n) {
            link->inputs().beat(n * 1'000'000);
            const realtime::HapticTick now = ticks.next(n * 1'000'000);
            const TickGuard guard;
            const bool goOn = task.tick(now);
            task.timing({n * 10, n, 0});
            if (!goOn)
                break;
        }
        QVERIFY2(forbiddenCounts().total() == 0, words(forbiddenCounts()));
        QVERIFY(link->droppedSamples() > 0);
        QVERIFY(link->display().latest().ended);
    }
};

QTEST_APPLESS_MAIN(TestLiveLinkGuard)
#include "test_live_link_guard.moc"
