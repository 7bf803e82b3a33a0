// SPDX-License-Identifier: GPL-3.0-or-later
#include "realtime/guarded_run.h"
#include "unit/simulation/palpation_driver.h"

#include <QtTest>
#include <cmath>
#include <limits>

using namespace chiron;
using namespace chiron::tests;
using namespace chiron::simulation;
using namespace chiron::simulation::testing;
using simulation::ReportField;
namespace bits = core::event_bits;

/// Palpations from the first press to the last report: nothing is allocated, locked or thrown in a tick.
class TestPalpationGuard : public QObject {
    Q_OBJECT
private slots:
    void everyKind_data() {
        QTest::addColumn<int>("law");
        QTest::addColumn<bool>("dome");
        QTest::addColumn<bool>("recast");
        QTest::addColumn<bool>("control");
        QTest::newRow("flat pad") << 0 << false << false << false;
        QTest::newRow("dome with a distractor") << 0 << true << false << false;
        QTest::newRow("second surface, ray cast again") << 1 << true << true << false;
        QTest::newRow("stiffness times depth, lumps that move") << 2 << false << false << true;
    }
    void everyKind();
};

void TestPalpationGuard::everyKind() {
    QFETCH(int, law);
    QFETCH(bool, dome);
    QFETCH(bool, recast);
    QFETCH(bool, control);
    PalpationParameters p = flatPad();
    p.hands = p.fingers = 2;
    p.tissue.lumps = static_cast<LumpLaw>(law);
    p.tissue.contact = recast ? TissueContactLaw::p3Recast : TissueContactLaw::anchored;
    p.lumpsLow = p.lumpsHigh = 3;
    if (dome) {
        p.tissue.shape = {-0.020, {{{0.0, 0.0}, {0.075, 0.075}, 0.0, 0.024}}};
        p.tissue.regions = {{"areola", {0.0, 0.0}, {0.014, 0.014}, 0.0, 0.35}};
    }
    if (control) {
        p.control.moveAfter_s = 1.0;
        p.control.move_m = {0.001, 0.0};
    }
    PalpationDriver d(p);
    resetForbiddenCounts();
    {
        const TickGuard guard;
        d.in.started = d.in.forceReady = true;
        for (int n = 0; n < 9'000; ++n) {
            const double t = 0.001 * n;
            for (int i = 0; i < 4; ++i) // circles, pressed and lifted, each finger in its own time
                d.at(i, 0.03 * std::cos(1.3 * t + i), 0.03 * std::sin(1.1 * t + 2.0 * i),
                     0.006 * std::sin(3.0 * t + i));
            if (n == 2'000)
                d.in.tools.tools[1].p_WT.x() = std::numeric_limits<double>::quiet_NaN();
            d.in.paused = n > 2'500 && n < 2'700;
            d.in.mark = n % 400 == 0;
            d.in.tools.tools[2].buttons =
                n % 300 < 150 ? core::kButtonMark
                              : core::reportButtons(simulation::reportWord(ReportField::hardness, 3));
            if (n % 700 == 0)
                d.command(ReportField::remove, static_cast<unsigned>(n / 700 % 8));
            d.scene.respond(d.source.next(0), d.in, d.out);
            d.in.reports = 0;
            d.events |= d.out.events;
        }
    }
    const ForbiddenCounts counts = forbiddenCounts();
    QVERIFY2(counts.total() == 0, words(counts));
    const std::uint32_t all = bits::kTrialStarted | bits::kTimedOut | bits::kContactBegan |
                              bits::kContactEnded | bits::kSceneChanged;
    QCOMPARE(d.events & all, all);
    QCOMPARE(int(d.out.trial), 1);
}

QTEST_APPLESS_MAIN(TestPalpationGuard)
#include "test_palpation_guard.moc"
