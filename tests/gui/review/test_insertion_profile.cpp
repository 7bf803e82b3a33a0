// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/review/made_insertion.h"
#include "app/exercises/urethra_insertion/session_report/insertion_profile.h"

#include <QtTest>
#include <algorithm>
#include <numbers>

using namespace chiron;
using core::ProcedureStage;
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
};

void TestInsertionProfile::momentsAreTheSeriesAtTheirTime() {
    const session::PlaybackTrack track = madeTrack();
    QVERIFY(std::isnan(track.at(1.0).insertion->depth_m)); // before the trial
    QVERIFY(track.at(1.0).insertion->stage == ProcedureStage::outside);
    QVERIFY(std::abs(track.at(4.0).insertion->depth_m - 0.04) < 1e-4);
    QVERIFY(track.at(5.5).insertion->stage == ProcedureStage::inspection);
    QCOMPARE(track.at(8.0).insertion->offset_m, 0.002);
    QVERIFY(std::isnan(track.at(9.4).insertion->depth_m)); // after its end
    QVERIFY(track.at(9.4).insertion->stage == ProcedureStage::withdrawal); // and where it stood
}

void TestInsertionProfile::landmarksUpToAMoment() {
    const session::PlaybackTrack track = madeTrack();
    QCOMPARE(track.insertion->landmarksSeenAt(5.49), 0u);
    QCOMPARE(track.insertion->landmarksSeenAt(5.51), 1u);
    QCOMPARE(track.insertion->landmarksSeen(), 1);
}

void TestInsertionProfile::theProfileIsTheLargestOfEachMillimetre() {
    scoring::SessionTrace trace = madeTrace();
    trace.trials[0].insertion->offset_m[1001] = 0.0055; // 20.02 mm: one sample alone
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
    trace.trials[0].insertion->offset_m[1001] = 0.0055;
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

QTEST_APPLESS_MAIN(TestInsertionProfile)
#include "test_insertion_profile.moc"
