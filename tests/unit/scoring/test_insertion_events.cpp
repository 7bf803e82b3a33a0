// SPDX-License-Identifier: GPL-3.0-or-later
// Trauma events and reversals: their thresholds to the sample, their ends, and that pauses count for nothing.
#include "insertion_traces.h"

#include "curriculum/exercises/urethra_insertion/scoring/insertion_events.h"

#include <QtTest>

using namespace chiron;
using namespace chiron::scoring;
using traces::CanalSample;
using traces::canalTrial;
using traces::ProcedureStage;

namespace {

/// Lateral forces of a trial at 1 kHz.
TrialTrace forces(const std::vector<double>& lateral_N) {
    return canalTrial(1e-3 * static_cast<double>(lateral_N.size() - 1), 0.001, [&](double t) {
        CanalSample sample;
        sample.lateral_N = lateral_N[static_cast<std::size_t>(std::lround(t * 1e3))];
        return sample;
    });
}

std::vector<double> runs(const std::vector<std::pair<int, double>>& parts) {
    std::vector<double> values;
    for (const auto& [count, value] : parts)
        values.insert(values.end(), static_cast<std::size_t>(count), value);
    return values;
}

std::vector<InsertionEvent> traumaOf(const TrialTrace& trial) {
    return insertionEvents(traces::onGrids(trial)).trauma;
}

/// Depths in µm, a sample each 10 ms.
TrialTrace depths(const std::vector<int>& s_um, ProcedureStage stage = ProcedureStage::insertion) {
    return canalTrial(1e-2 * static_cast<double>(s_um.size() - 1), 0.01, [&](double t) {
        CanalSample sample;
        sample.s_m = 1e-6 * s_um[static_cast<std::size_t>(std::lround(t * 1e2))];
        sample.stage = stage;
        return sample;
    });
}

std::vector<InsertionEvent> reversalsOf(const TrialTrace& trial) {
    return insertionEvents(traces::onGrids(trial)).reversals;
}

} // namespace

class TestInsertionEvents : public QObject {
    Q_OBJECT
private slots:
    void traumaTakesTwentyMilliseconds_data();
    void traumaTakesTwentyMilliseconds();
    void traumaIsOverTheLimitOnly();
    void traumaIsOneUntilBelowEightyPercent_data();
    void traumaIsOneUntilBelowEightyPercent();
    void traumaTellsWhenAndHowMuch();
    void aBreakStartsTheTimeAnew();
    void traumaAtTheTrialsEnd();
    void traumaInSlowTraces();
    void traumaAndPauses();
    void reversalTakesOneMillimetre_data();
    void reversalTakesOneMillimetre();
    void reversalTellsWhenAndHowFar();
    void tremorIsNoReversal();
    void theWayBackEndsAtOneMillimetreForward();
    void reversalsAreOfTheInsertionOnly();
    void reversalThatGoesOnAtTheEnd();
    void reversalsAndPauses();
    void nothingWithoutACanal();
};

void TestInsertionEvents::traumaTakesTwentyMilliseconds_data() {
    QTest::addColumn<int>("samplesOver");
    QTest::addColumn<int>("events");
    QTest::newRow("19 ms") << 19 << 0;
    QTest::newRow("20 ms") << 20 << 1;
    QTest::newRow("21 ms") << 21 << 1;
    QTest::newRow("1 s") << 1000 << 1;
}

void TestInsertionEvents::traumaTakesTwentyMilliseconds() {
    QFETCH(int, samplesOver);
    QFETCH(int, events);
    for (const int before : {1, 7, 333}) { // also where 1e-3 i is not exact in binary
        const auto trial = forces(runs({{before, 0.0}, {samplesOver, 2.001}, {5, 0.0}}));
        QCOMPARE(traumaOf(trial).size(), static_cast<std::size_t>(events));
    }
}

void TestInsertionEvents::traumaIsOverTheLimitOnly() {
    QCOMPARE(traumaOf(forces(runs({{5, 0.0}, {100, 2.0}, {5, 0.0}}))).size(), std::size_t{0});
    QCOMPARE(traumaOf(forces(runs({{5, 0.0}, {100, 2.001}, {5, 0.0}}))).size(), std::size_t{1});
}

void TestInsertionEvents::traumaIsOneUntilBelowEightyPercent_data() {
    QTest::addColumn<double>("dip_N");
    QTest::addColumn<int>("events");
    QTest::newRow("just below the limit") << 1.999 << 1;
    QTest::newRow("at 80 %") << 1.6 << 1;
    QTest::newRow("just below 80 %") << 1.599 << 2;
    QTest::newRow("nothing") << 0.0 << 2;
}

void TestInsertionEvents::traumaIsOneUntilBelowEightyPercent() {
    QFETCH(double, dip_N);
    QFETCH(int, events);
    for (const int dip : {1, 50}) {
        const auto trial = forces(runs({{3, 0.0}, {30, 2.5}, {dip, dip_N}, {30, 2.5}, {3, 0.0}}));
        QCOMPARE(traumaOf(trial).size(), static_cast<std::size_t>(events));
    }
}

void TestInsertionEvents::traumaTellsWhenAndHowMuch() {
    // Over from 10 ms, 3.2 N at most while it goes on at 1.7 N, over at 80 ms.
    const auto trial =
        forces(runs({{10, 0.5}, {30, 2.5}, {10, 3.2}, {30, 1.7}, {10, 0.1}, {10, 3.9}, {5, 0.0}}));
    const auto found = traumaOf(trial);
    QCOMPARE(found.size(), std::size_t{1}); // the last peak lasted 10 ms
    QCOMPARE(found[0].begin_s, 0.010);
    QCOMPARE(found[0].end_s, 0.080);
    QCOMPARE(found[0].value, 3.2);
    const auto early = traumaOf(forces(runs({{10, 0.5}, {5, 3.6}, {30, 2.5}, {5, 0.0}})));
    QCOMPARE(early.at(0).value, 3.6); // the peak before it counted as an event is part of it
}

void TestInsertionEvents::aBreakStartsTheTimeAnew() {
    QCOMPARE(traumaOf(forces(runs({{3, 0.0}, {15, 2.5}, {1, 2.0}, {15, 2.5}, {3, 0.0}}))).size(),
             std::size_t{0});
    QCOMPARE(traumaOf(forces(runs({{3, 0.0}, {15, 2.5}, {1, 2.0}, {20, 2.5}, {3, 0.0}}))).size(),
             std::size_t{1});
}

void TestInsertionEvents::traumaAtTheTrialsEnd() {
    QCOMPARE(traumaOf(forces(runs({{3, 0.0}, {20, 2.5}}))).size(),
             std::size_t{0}); // the last sample holds for no time
    const auto found = traumaOf(forces(runs({{3, 0.0}, {21, 2.5}})));
    QCOMPARE(found.size(), std::size_t{1});
    QCOMPARE(found[0].end_s, 0.023);
}

void TestInsertionEvents::traumaInSlowTraces() {
    const auto slow = [](int over) {
        return canalTrial(0.1, 0.01, [=](double t) {
            const auto i = std::lround(t * 100.0);
            CanalSample sample;
            sample.lateral_N = i >= 3 && i < 3 + over ? 2.5 : 0.0;
            return sample;
        });
    };
    QCOMPARE(traumaOf(slow(1)).size(), std::size_t{0});
    QCOMPARE(traumaOf(slow(2)).size(), std::size_t{1});
}

void TestInsertionEvents::traumaAndPauses() {
    auto trial = forces(runs({{3, 0.0}, {15, 2.5}, {15, 2.5}, {15, 2.5}, {3, 0.0}}));
    for (std::size_t i = 18; i < 33; ++i)
        trial.tools[0].paused[i] = 1;
    QCOMPARE(traumaOf(trial).size(), std::size_t{0}); // 15 ms before it and 15 ms after it
    auto longer = forces(runs({{3, 0.0}, {30, 2.5}, {30, 9.0}, {30, 2.5}, {3, 0.0}}));
    for (std::size_t i = 33; i < 63; ++i)
        longer.tools[0].paused[i] = 1;
    const auto found = traumaOf(longer);
    QCOMPARE(found.size(), std::size_t{1}); // it was never below 80 %
    QCOMPARE(found[0].end_s, 0.033);
    QCOMPARE(found[0].value, 2.5);
    auto upToThePause = forces(runs({{3, 0.0}, {20, 2.5}, {5, 0.0}}));
    for (std::size_t i = 23; i < 28; ++i)
        upToThePause.tools[0].paused[i] = 1;
    QCOMPARE(traumaOf(upToThePause).size(), std::size_t{1});
}

void TestInsertionEvents::reversalTakesOneMillimetre_data() {
    QTest::addColumn<int>("back_um");
    QTest::addColumn<int>("events");
    QTest::newRow("0.999 mm") << 999 << 0;
    QTest::newRow("1 mm") << 1000 << 1;
    QTest::newRow("1.001 mm") << 1001 << 1;
    QTest::newRow("5 mm") << 5000 << 1;
}

void TestInsertionEvents::reversalTakesOneMillimetre() {
    QFETCH(int, back_um);
    QFETCH(int, events);
    for (const int top_um : {3000, 49999, 70001}) {
        const auto trial = depths({0, top_um / 2, top_um, top_um - back_um, top_um, top_um + 2000});
        QCOMPARE(reversalsOf(trial).size(), static_cast<std::size_t>(events));
    }
}

void TestInsertionEvents::reversalTellsWhenAndHowFar() {
    // The farthest place is at 20 ms, the turn at 50 ms, 6 mm back; 1 mm forward again at 70 ms.
    const auto found = reversalsOf(depths({0, 10000, 20000, 19500, 17000, 14000, 14900, 15000, 30000}));
    QCOMPARE(found.size(), std::size_t{1});
    QCOMPARE(found[0].begin_s, 0.02);
    QCOMPARE(found[0].end_s, 0.05);
    QVERIFY(std::abs(found[0].value - 0.006) < 1e-12);
}

void TestInsertionEvents::tremorIsNoReversal() {
    const auto trial = canalTrial(10.0, 0.001, [](double t) {
        CanalSample sample;
        sample.s_m =
            0.005 * t + 4e-4 * std::sin(2.0 * 3.14159265358979 * 10.0 * t); // 0.8 mm from peak to peak
        return sample;
    });
    QCOMPARE(reversalsOf(trial).size(), std::size_t{0});
    const auto large = canalTrial(10.0, 0.001, [](double t) {
        CanalSample sample;
        sample.s_m = 0.02 + 6e-4 * std::sin(2.0 * 3.14159265358979 * 0.5 * t); // 1.2 mm, five times
        return sample;
    });
    QCOMPARE(reversalsOf(large).size(), std::size_t{5});
}

void TestInsertionEvents::theWayBackEndsAtOneMillimetreForward() {
    // 0.9 mm forward inside one way back does not split it; 1 mm does.
    QCOMPARE(reversalsOf(depths({20000, 17000, 17900, 15000, 20000})).size(), std::size_t{1});
    QCOMPARE(reversalsOf(depths({20000, 17000, 18000, 15000, 20000})).size(), std::size_t{2});
}

void TestInsertionEvents::reversalsAreOfTheInsertionOnly() {
    for (const auto stage : {ProcedureStage::outside, ProcedureStage::inspection, ProcedureStage::withdrawal,
                             ProcedureStage::completed})
        QCOMPARE(reversalsOf(depths({20000, 10000, 20000, 0}, stage)).size(), std::size_t{0});
    QCOMPARE(reversalsOf(depths({20000, 10000, 20000, 0})).size(), std::size_t{2});
    auto withdrawing = depths({0, 20000, 20000, 10000, 0});
    for (std::size_t i = 3; i < 5; ++i)
        insertionIn(withdrawing).stage[i] = static_cast<std::uint8_t>(ProcedureStage::withdrawal);
    QCOMPARE(reversalsOf(withdrawing).size(), std::size_t{0}); // the way out is none
}

void TestInsertionEvents::reversalThatGoesOnAtTheEnd() {
    const auto found = reversalsOf(depths({0, 20000, 15000, 12000, 12500}));
    QCOMPARE(found.size(), std::size_t{1});
    QCOMPARE(found[0].end_s, 0.03);
    QVERIFY(std::abs(found[0].value - 0.008) < 1e-12);
}

void TestInsertionEvents::reversalsAndPauses() {
    auto trial = depths({0, 20000, 15000, 10000, 11000, 30000}); // moved back in the pause
    trial.tools[0].paused[2] = trial.tools[0].paused[3] = 1;
    QCOMPARE(reversalsOf(trial).size(), std::size_t{0});
    auto during = depths({0, 20000, 17000, 10000, 16000, 30000});
    during.tools[0].paused[3] = 1;
    const auto found = reversalsOf(during);
    QCOMPARE(found.size(), std::size_t{1});
    QCOMPARE(found[0].end_s, 0.02);
    QVERIFY(std::abs(found[0].value - 0.003) < 1e-12);
}

void TestInsertionEvents::nothingWithoutACanal() {
    auto trial = forces(runs({{3, 0.0}, {30, 2.5}}));
    trial.own.reset();
    QVERIFY(insertionEvents(traces::onGrids(trial)).trauma.empty());
    QVERIFY(insertionEvents(TrialTrace{}).reversals.empty());
}

QTEST_APPLESS_MAIN(TestInsertionEvents)
#include "test_insertion_events.moc"
