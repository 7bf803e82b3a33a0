// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/urethra_insertion/report/insertion_report.h"
#include "app/exercises/urethra_insertion/session_report/insertion_profile.h"
#include "gui/review/made_insertion.h"
#include "report/plot_view.h"
#include "support/insertion_in.h"

#include <QtTest>
#include <algorithm>
#include <numbers>

using namespace chiron;
using simulation::ProcedureStage;
using tests::madeTrace;
using tests::madeTrack;

class TestInsertionProfile : public QObject {
    Q_OBJECT
private slots:
    void momentsAreTheSeriesAtTheirTime();
    void landmarksUpToAMoment();
    void theProfileIsTheLargestOfEachMillimetre();
    void pausesDoNotCount();
    void withoutASeriesThereIsNone();
    void thePlotReachesTheGoal();
};

void TestInsertionProfile::momentsAreTheSeriesAtTheirTime() {
    const session::PlaybackTrack track = madeTrack();
    QVERIFY(std::isnan(session::insertionAt(track, 1.0)->depth_m)); // before the trial
    QVERIFY(session::insertionAt(track, 1.0)->stage == ProcedureStage::outside);
    QVERIFY(std::abs(session::insertionAt(track, 4.0)->depth_m - 0.04) < 1e-4);
    QVERIFY(session::insertionAt(track, 5.5)->stage == ProcedureStage::inspection);
    QCOMPARE(session::insertionAt(track, 8.0)->offset_m, 0.002);
    QVERIFY(std::isnan(session::insertionAt(track, 9.4)->depth_m));                 // after its end
    QVERIFY(session::insertionAt(track, 9.4)->stage == ProcedureStage::withdrawal); // and where it stood
}

void TestInsertionProfile::landmarksUpToAMoment() {
    const session::PlaybackTrack track = madeTrack();
    QCOMPARE(track.of<session::PlaybackInsertion>()->landmarksSeenAt(5.49), 0u);
    QCOMPARE(track.of<session::PlaybackInsertion>()->landmarksSeenAt(5.51), 1u);
    QCOMPARE(track.of<session::PlaybackInsertion>()->landmarksSeen(), 1);
}

void TestInsertionProfile::theProfileIsTheLargestOfEachMillimetre() {
    scoring::SessionTrace trace = madeTrace();
    insertionIn(trace.trials[0]).offset_m[1001] = 0.0055; // 20.02 mm: one sample alone
    const auto profile = session_report::insertionProfileOf(trace);
    QVERIFY(profile.has_value());
    const auto at = [&](double depth_mm) {
        const auto found = std::find(profile->depth_mm.begin(), profile->depth_mm.end(), depth_mm);
        return static_cast<std::size_t>(found - profile->depth_mm.begin());
    };
    QCOMPARE(profile->offsetIn_mm[at(20.5)], 5.5);
    QCOMPARE(profile->offsetIn_mm[at(21.5)], 1.0);
    QCOMPARE(profile->offsetOut_mm[at(20.5)], 2.0);
    QVERIFY(std::abs(profile->alignmentIn_deg[at(40.5)] - 0.2 * 180.0 / std::numbers::pi) < 1e-9);
    QVERIFY(std::isnan(profile->offsetIn_mm[at(-5.5)])); // never there
    QCOMPARE(profile->landmarks, 2);
    QCOMPARE(profile->landmarksSeen, 1);
    QCOMPARE(profile->bend_mm, 30.0);
    const auto ofTrack = session_report::insertionProfileOf(madeTrack()); // fewer samples, the same way
    QCOMPARE(ofTrack->depth_mm, profile->depth_mm);
    QCOMPARE(ofTrack->offsetIn_mm[at(30.5)], profile->offsetIn_mm[at(30.5)]);
}

void TestInsertionProfile::pausesDoNotCount() {
    scoring::SessionTrace trace = madeTrace();
    insertionIn(trace.trials[0]).offset_m[1001] = 0.0055;
    trace.trials[0].tools[0].paused[1001] = 1;
    const auto profile = session_report::insertionProfileOf(trace);
    double most = 0.0;
    for (const double value : profile->offsetIn_mm)
        most = std::max(most, std::isnan(value) ? 0.0 : value);
    QCOMPARE(most, 1.0);
}

void TestInsertionProfile::withoutASeriesThereIsNone() {
    scoring::SessionTrace trace;
    QVERIFY(!session_report::insertionProfileOf(trace));
    trace.trials.emplace_back();
    QVERIFY(!session_report::insertionProfileOf(trace));
    QVERIFY(!session_report::insertionProfileOf(session::PlaybackTrack()));
}

/// Or as deep as it went, if that is deeper; where nothing is known, there is an axis all the same.
void TestInsertionProfile::thePlotReachesTheGoal() {
    const auto range = [](std::vector<double> depth_mm, double goal_mm) {
        report::InsertionProfile profile;
        profile.goal_mm = goal_mm;
        profile.depth_mm = std::move(depth_mm);
        profile.offsetIn_mm = profile.offsetOut_mm = std::vector<double>(profile.depth_mm.size(), 0.5);
        const auto plot = report::offsetDepthPlot(profile, report::lightTheme(QLocale::c()));
        plot->resize(400, 200);
        plot->grab();
        return std::pair(plot->xLow(), plot->xHigh());
    };
    QCOMPARE(range({}, 0.0), std::pair(0.0, 1.0));
    QCOMPARE(range({}, 60.0), std::pair(0.0, 60.0));
    QCOMPARE(range({0.5, 1.5, 2.5}, 60.0), std::pair(0.0, 60.0));
    QCOMPARE(range({-3.5, 20.5, 80.5}, 60.0), std::pair(-3.5, 80.5));
}

QTEST_MAIN(TestInsertionProfile)
#include "test_insertion_profile.moc"
