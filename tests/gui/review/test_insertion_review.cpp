// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/playback/playback_plots.h"
#include "desktop/playback/playback_scene.h"
#include "report/session_plots.h"
#include "session/playback_ghost.h"
#include "session_report/insertion_profile.h"
#include "session_report/track_series.h"

#include <QtTest>
#include <numbers>

using namespace chiron;
using core::ProcedureStage;

namespace {

/// In by 20 mm/s to 60 mm, a second of inspection, and out again; off-centre by 1 mm on the way in and 2 mm on the way out.
scoring::SessionTrace madeTrace(double begin_s = 2.0) {
    scoring::TrialTrace trial;
    trial.tools.resize(1);
    trial.insertion.emplace();
    scoring::InsertionSeries& series = *trial.insertion;
    series.length_m = 0.05;
    series.bend_m = 0.03;
    series.goal_m = 0.06;
    series.landmarkSeen_s = {begin_s + 3.5, std::nan("")};
    for (int i = 0; i <= 7000; ++i) {
        const double t_s = 1e-3 * i;
        const double s_m = t_s < 3.0 ? 0.02 * t_s : t_s < 4.0 ? 0.06 : 0.06 - 0.02 * (t_s - 4.0);
        const ProcedureStage stage = t_s < 3.0 ? ProcedureStage::insertion : t_s < 4.0 ? ProcedureStage::inspection : ProcedureStage::withdrawal;
        trial.tools[0].t_s.push_back(begin_s + t_s);
        trial.tools[0].paused.push_back(0);
        series.s_m.push_back(s_m);
        series.offset_m.push_back(stage == ProcedureStage::withdrawal ? 0.002 : 0.001);
        series.alignment_rad.push_back(s_m > 0.03 ? 0.2 : 0.1);
        series.stage.push_back(static_cast<std::uint8_t>(stage));
    }
    scoring::SessionTrace trace;
    trace.trials.push_back(std::move(trial));
    return trace;
}

/// A track of 9.5 s, 250 samples a second, that the made trace belongs to.
session::PlaybackTrack madeTrack() {
    session::PlaybackTrack track;
    track.toolCount = 1;
    track.forceLimit_N = 4.0;
    track.exercise = "urethra_insertion";
    std::vector<double> times_s;
    for (int i = 0; i < 2375; ++i) {
        session::PlaybackMoment moment;
        moment.t_s = 4e-3 * i;
        moment.tick = static_cast<std::uint64_t>(4 * i);
        track.moments.push_back(moment);
        track.tools.emplace_back();
        times_s.push_back(moment.t_s);
    }
    session::PlaybackTrial trial;
    trial.start_s = 2.0;
    trial.end_s = 9.0;
    track.trials.push_back(trial);
    track.duration_s = track.moments.back().t_s;
    track.insertion = session::playbackInsertionOf(madeTrace(), times_s);
    return track;
}

} // namespace

class TestInsertionReview : public QObject {
    Q_OBJECT
private slots:
    void momentsAreTheSeriesAtTheirTime();
    void landmarksUpToAMoment();
    void theProfileIsTheLargestOfEachMillimetre();
    void pausesDoNotCount();
    void theSceneIsToldTheProcedure();
    void plotsOfACanal();
    void theGhostHasItsOwnLines();
    void withoutASeriesNothingIsAdded();
};

void TestInsertionReview::momentsAreTheSeriesAtTheirTime() {
    const session::PlaybackTrack track = madeTrack();
    QVERIFY(std::isnan(track.at(1.0).insertion->depth_m)); // before the trial
    QVERIFY(track.at(1.0).insertion->stage == ProcedureStage::outside);
    QVERIFY(std::abs(track.at(4.0).insertion->depth_m - 0.04) < 1e-4);
    QVERIFY(track.at(5.5).insertion->stage == ProcedureStage::inspection);
    QCOMPARE(track.at(8.0).insertion->offset_m, 0.002);
    QVERIFY(std::isnan(track.at(9.4).insertion->depth_m)); // after its end
    QVERIFY(track.at(9.4).insertion->stage == ProcedureStage::withdrawal); // and where it stood
}

void TestInsertionReview::landmarksUpToAMoment() {
    const session::PlaybackTrack track = madeTrack();
    QCOMPARE(track.insertion->landmarksSeenAt(5.49), 0u);
    QCOMPARE(track.insertion->landmarksSeenAt(5.51), 1u);
    QCOMPARE(track.insertion->landmarksSeen(), 1);
}

void TestInsertionReview::theProfileIsTheLargestOfEachMillimetre() {
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

void TestInsertionReview::pausesDoNotCount() {
    scoring::SessionTrace trace = madeTrace();
    trace.trials[0].insertion->offset_m[1001] = 0.0055;
    trace.trials[0].tools[0].paused[1001] = 1;
    const auto profile = session_report::insertionProfileOf(trace);
    double most = 0.0;
    for (const double value : profile->offsetIn_mm)
        most = std::max(most, std::isnan(value) ? 0.0 : value);
    QCOMPARE(most, 1.0);
}

void TestInsertionReview::theSceneIsToldTheProcedure() {
    const session::PlaybackTrack track = madeTrack();
    const scene3d::SceneState state = desktop::sceneStateAt(track, nullptr, 6.0);
    QVERIFY(state.endoscope.present && state.endoscope.pictureShown && state.endoscope.guided);
    QVERIFY(state.endoscope.stage == ProcedureStage::withdrawal);
    QCOMPARE(state.endoscope.landmarks, 2);
    QCOMPARE(state.endoscope.landmarksSeen, 1u);
    QVERIFY(std::abs(state.endoscope.depth_m - 0.06) < 1e-4);
    QVERIFY(!desktop::sceneStateAt(session::PlaybackTrack(track), nullptr, 0.0).objectShown);
}

void TestInsertionReview::plotsOfACanal() {
    const desktop::Theme theme = desktop::Theme::load(desktop::ThemeName::light, 1.0).value();
    const session::PlaybackTrack track = madeTrack();
    desktop::PlaybackPlots plots(theme, QLocale::c(), track);
    for (const char* name : {"playback.force", "playback.offset_plot", "playback.alignment_plot", "playback.speed_plot"})
        QVERIFY2(plots.findChild<report::PlotView*>(QLatin1String(name)), name);
    plots.showCursor(3.0);
    QCOMPARE(plots.findChild<report::PlotView*>(QStringLiteral("playback.offset_plot"))->cursorX(), 3.0);
    const report::SampleSeries series = session_report::seriesOf(track);
    QCOMPARE(series.offset_mm.size(), series.t_s.size());
    QVERIFY(series.events.empty()); // one procedure has no numbers
    const auto profile = session_report::insertionProfileOf(track);
    QVERIFY(report::offsetDepthPlot(*profile, report::lightTheme(QLocale::c()))->legendTexts().size() >= 2); // in and out
    QVERIFY(report::alignmentDepthPlot({}, report::lightTheme(QLocale::c()))); // nothing is no crash
}

void TestInsertionReview::theGhostHasItsOwnLines() {
    const session::PlaybackTrack track = madeTrack();
    const session::GhostSeries series = session::ghostSeries(track, track);
    QCOMPARE(series.offset_m.size(), series.t_s.size());
    const desktop::Theme theme = desktop::Theme::load(desktop::ThemeName::dark, 1.0).value();
    desktop::PlaybackPlots plots(theme, QLocale::c(), track);
    plots.setGhost(series, QStringLiteral("other"));
    QVERIFY(plots.force().legendTexts().contains(QStringLiteral("other")));
    QCOMPARE(plots.findChildren<report::PlotView*>(QStringLiteral("playback.offset_plot")).size(), 1); // drawn anew, not twice
    const auto ghost = session::ghostAt(track, track, 4.0);
    QVERIFY(ghost.has_value());
}

void TestInsertionReview::withoutASeriesNothingIsAdded() {
    scoring::SessionTrace trace;
    QVERIFY(!session_report::insertionProfileOf(trace));
    trace.trials.emplace_back();
    QVERIFY(!session_report::insertionProfileOf(trace));
    session::PlaybackTrack track = madeTrack();
    track.insertion.reset();
    QVERIFY(!track.at(4.0).insertion);
    QVERIFY(session_report::seriesOf(track).offset_mm.empty());
    QVERIFY(!desktop::sceneStateAt(track, nullptr, 4.0).endoscope.present);
    const desktop::Theme theme = desktop::Theme::load(desktop::ThemeName::light, 1.0).value();
    QVERIFY(!desktop::PlaybackPlots(theme, QLocale::c(), track).findChild<report::PlotView*>(QStringLiteral("playback.offset_plot")));
}

QTEST_MAIN(TestInsertionReview)
#include "test_insertion_review.moc"
