// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/units.h"
#include "modules/exercises/elastic_tube/simulation/elastic_tube_scene.h"
#include "realtime/haptic_tick.h"
#include "realtime/tick_guard.h"

#include <QtTest>
#include <cmath>

using namespace chiron;
using namespace chiron::tests;
using simulation::TubeTask;

namespace {

/// Hands that follow what is shown: they grasp, pull to and fro, hand over, let go, and tear at the end.
void move(simulation::SceneInput& in, const simulation::SceneOutput& out, int n) {
    const core::LaparoscopyCues& cues = out.cues.exercise.of<core::LaparoscopyCues>();
    for (std::size_t i = 0; i < 2; ++i) {
        core::ToolState& tool = in.tools.tools[i];
        const std::size_t node = cues.grips > 2 ? 2 - i : (i == 0 ? 1 : 0);
        const int turn = (n + 700 * static_cast<int>(i)) % 2000;
        if (turn < 200 || cues.grips == 0) {
            tool.jaw_rad = 0.7;
        } else if (turn < 300) {
            tool.p_WT = {cues.p_WGrip[node][0], cues.p_WGrip[node][1], cues.p_WGrip[node][2]};
            tool.jaw_rad = 0.0;
        } else {
            const double t = 1e-3 * n;
            tool.v_WT = {(i == 0 ? 0.01 : -0.01), 0.005 * std::sin(t),
                         n > 8000 ? 0.2 : 0.02 * std::cos(3.0 * t)};
            tool.p_WT += tool.v_WT * core::kTickSeconds;
        }
    }
}

} // namespace

/// 10,000 ticks of every task of the elastic tube: nothing is allocated, locked or thrown in any of them.
class TestElasticTubeGuard : public QObject {
    Q_OBJECT
private slots:
    void everyTask_data() {
        QTest::addColumn<int>("task");
        QTest::addColumn<double>("stiffening_per_m");
        QTest::newRow("hold") << static_cast<int>(TubeTask::hold) << 0.0;
        QTest::newRow("stiffening") << static_cast<int>(TubeTask::hold) << 60.0;
        QTest::newRow("stretch") << static_cast<int>(TubeTask::stretch) << 0.0;
        QTest::newRow("two-handed") << static_cast<int>(TubeTask::twoHanded) << 0.0;
        QTest::newRow("transfer") << static_cast<int>(TubeTask::transfer) << 0.0;
    }
    void everyTask() {
        QFETCH(int, task);
        QFETCH(double, stiffening_per_m);
        simulation::ElasticTubeParameters p;
        p.task = static_cast<TubeTask>(task);
        p.tube.stiffness_N_per_m = 60.0;
        p.tube.stiffening_per_m = stiffening_per_m;
        p.tube.viscosity_Ns_per_m = 0.2;
        p.trials = 3;
        p.hold_s = 0.2;
        p.trialLimit_s = 4.0;
        p.betweenTrials_s = 0.3;
        p.cues = {"object", "tool", "bars"};
        simulation::ElasticTubeScene scene(p, 5);
        realtime::TickSource ticks;
        simulation::SceneInput in;
        simulation::SceneOutput out;
        in.started = in.forceReady = true;
        in.tools.count = 2;
        std::uint32_t events = 0;
        double strongest_N = 0.0;
        resetForbiddenCounts();
        for (int n = 0; n < 10'000; ++n) {
            move(in, out, n);
            in.paused = n > 3000 && n < 3100;
            const realtime::HapticTick now = ticks.next(0);
            const TickGuard guard;
            scene.respond(now, in, out);
            events |= out.events;
            strongest_N = std::max(strongest_N, out.tissue.tools[0].force.norm());
        }
        QByteArray counts;
        for (std::size_t i = 0; i < kForbiddenNames.size(); ++i)
            counts +=
                QByteArray(kForbiddenNames[i]) + "=" + QByteArray::number(forbiddenCounts().count[i]) + " ";
        QVERIFY2(forbiddenCounts().total() == 0, counts);
        using namespace core::event_bits;
        const std::uint32_t all =
            kTrialStarted | kGrasped | kReleased | kStageChanged | kContactBegan | kContactEnded;
        QCOMPARE(events & all, all); // the run went on with something in its hands
        QVERIFY(strongest_N > 0.1);
    }
};

QTEST_APPLESS_MAIN(TestElasticTubeGuard)
#include "test_elastic_tube_guard.moc"
