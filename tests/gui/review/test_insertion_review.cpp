// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/urethra_insertion/desktop/insertion_layer.h"
#include "app/exercises/urethra_insertion/report/insertion_report.h"
#include "app/exercises/urethra_insertion/session/insertion_marks.h"
#include "app/exercises/urethra_insertion/session_report/insertion_profile.h"
#include "desktop/playback/playback_plots.h"
#include "desktop/playback/playback_scene.h"
#include "desktop/playback/playback_screen.h"
#include "gui/review/made_insertion.h"
#include "modules/exercises/urethra_insertion/simulation/urethra_insertion_parameters.h"
#include "report/report_writer.h"
#include "report/session_plots.h"
#include "session/playback_ghost.h"
#include "session_report/mark_words.h"
#include "session_report/session_report.h"
#include "session_report/track_series.h"
#include "support/insertion_session.h"
#include "support/patience.h"

#include <QCheckBox>
#include <QLabel>
#include <QtTest>

using chiron::tests::kPatience_ms;

using namespace chiron;
using simulation::ProcedureStage;
using tests::madeTrack;

namespace {
catalogue::ExerciseLevel insertionLevel() {
    catalogue::ExerciseLevel level;
    level.exercise = "urethra_insertion";
    level.parameters = simulation::UrethraInsertionParameters{};
    return level;
}
} // namespace

class TestInsertionReview : public QObject {
    Q_OBJECT
private slots:
    void theSceneIsToldTheProcedure();
    void plotsOfACanal();
    void tissueIsSaidToGiveWayToWhatItGaveWayTo();
    void eachLimitOfAPushHasItsName();
    void theGhostHasItsOwnLines();
    void withoutASeriesNothingIsAdded();
    void aStoredProcedureIsPlayedBack();
    void itsDebriefShowsTheWay();
};

void TestInsertionReview::theSceneIsToldTheProcedure() {
    desktop::InsertionLayer layer(true);
    const session::PlaybackTrack track = madeTrack();
    const scene3d::SceneState state = desktop::sceneStateAt(track, nullptr, 6.0, &layer);
    QVERIFY(state.objectShown && state.exercise.of<simulation::EndoscopeCues>().present &&
            state.exercise.of<simulation::EndoscopeCues>().pictureShown &&
            state.exercise.of<simulation::EndoscopeCues>().guided);
    QVERIFY(state.exercise.of<simulation::EndoscopeCues>().stage == ProcedureStage::withdrawal);
    QCOMPARE(state.exercise.of<simulation::EndoscopeCues>().landmarks, 2);
    QCOMPARE(state.exercise.of<simulation::EndoscopeCues>().landmarksSeen, 1u);
    QVERIFY(std::abs(state.exercise.of<simulation::EndoscopeCues>().depth_m - 0.06) < 1e-4);
}

void TestInsertionReview::plotsOfACanal() {
    desktop::InsertionLayer layer(true);
    const desktop::Theme theme = desktop::Theme::load(desktop::ThemeName::light, 1.0).value();
    const session::PlaybackTrack track = madeTrack();
    desktop::PlaybackPlots plots(theme, QLocale::c(), track, insertionLevel(), &layer);
    for (const char* name :
         {"playback.force", "playback.offset_plot", "playback.alignment_plot", "playback.speed_plot"})
        QVERIFY2(plots.findChild<report::PlotView*>(QLatin1String(name)), name);
    plots.showCursor(3.0);
    QCOMPARE(plots.findChild<report::PlotView*>(QStringLiteral("playback.offset_plot"))->cursorX(), 3.0);
    const report::SampleSeries series = session_report::seriesOf(track, insertionLevel(), QLocale::c());
    QCOMPARE(series.derivedValues(session::kOffsetSeries).size(), series.t_s.size());
    QVERIFY(series.events.empty()); // one procedure has no numbers
    const auto profile = session_report::insertionProfileOf(track);
    QVERIFY(report::offsetDepthPlot(*profile, report::lightTheme(QLocale::c()))->legendTexts().size() >=
            2);                                                                // in and out
    QVERIFY(report::alignmentDepthPlot({}, report::lightTheme(QLocale::c()))); // nothing is no crash
}

void TestInsertionReview::tissueIsSaidToGiveWayToWhatItGaveWayTo() {
    session::PlaybackMark mark;
    mark.kind = session::mark_kinds::kYielded;
    mark.value = 8.0;
    const auto said = [&] { return session_report::markText(mark, "urethra_insertion", QLocale::c()); };
    QVERIFY2(said().contains(QStringLiteral("8.00\u00a0N")) && !said().contains(QStringLiteral("orque")),
             qPrintable(said()));
    mark.detail = session::kByTorque;
    mark.value = 0.213;
    QVERIFY2(said().contains(QStringLiteral("torque")) && said().contains(QStringLiteral("213")) &&
                 said().contains(QStringLiteral("mN·m")),
             qPrintable(said()));
}

/// One hard push can be over both limits, and has a line for each: they must not look like the same event
/// twice.
void TestInsertionReview::eachLimitOfAPushHasItsName() {
    session::PlaybackMark mark;
    mark.end_s = 0.3;
    mark.value = 4.2;
    const auto said = [&](const session::PlaybackMarkKind& kind) {
        mark.kind = kind;
        return session_report::markText(mark, "urethra_insertion", QLocale::c());
    };
    const QString trauma = said(session::mark_kinds::kTrauma), force = said(session::mark_kinds::kOverLimit);
    QVERIFY2(trauma.startsWith(QStringLiteral("Trauma event: pressed sideways")), qPrintable(trauma));
    QVERIFY2(force.startsWith(QStringLiteral("Over the force limit")), qPrintable(force));
}

void TestInsertionReview::theGhostHasItsOwnLines() {
    desktop::InsertionLayer layer(true);
    const session::PlaybackTrack track = madeTrack();
    const session::GhostSeries series = session::ghostSeries(track, track);
    QCOMPARE(series.derived.size(), std::size_t{2});
    for (const session::PlaybackQuantity& derived : series.derived)
        QCOMPARE(derived.values.size(), series.t_s.size());
    const desktop::Theme theme = desktop::Theme::load(desktop::ThemeName::dark, 1.0).value();
    desktop::PlaybackPlots plots(theme, QLocale::c(), track, insertionLevel(), &layer);
    plots.setGhost(series, QStringLiteral("other"));
    QVERIFY(plots.force().legendTexts().contains(QStringLiteral("other")));
    QCOMPARE(plots.findChildren<report::PlotView*>(QStringLiteral("playback.offset_plot")).size(),
             1); // drawn anew, not twice
    const auto ghost = session::ghostAt(track, track, 4.0);
    QVERIFY(ghost.has_value());
}

void TestInsertionReview::withoutASeriesNothingIsAdded() {
    desktop::InsertionLayer layer(true);
    session::PlaybackTrack track = madeTrack();
    track.own.reset();
    track.derived.clear();
    QVERIFY(!session::insertionAt(track, 4.0));
    QVERIFY(session_report::seriesOf(track, insertionLevel(), QLocale::c()).derived.empty());
    QVERIFY(
        !desktop::sceneStateAt(track, nullptr, 4.0, &layer).exercise.of<simulation::EndoscopeCues>().present);
    const desktop::Theme theme = desktop::Theme::load(desktop::ThemeName::light, 1.0).value();
    QVERIFY(!desktop::PlaybackPlots(theme, QLocale::c(), track, insertionLevel(), &layer)
                 .findChild<report::PlotView*>(QStringLiteral("playback.offset_plot")));
}

/// Stored, scored and read again: what was done at a moment is told in words, and the scene takes the other
/// picture.
void TestInsertionReview::aStoredProcedureIsPlayedBack() {
    tests::DesktopFixture desktop;
    const database::SessionId id = tests::addInsertion(desktop, "tina");
    desktop.logIn("tina");
    desktop.go(QStringLiteral("playback"), {{QStringLiteral("session"), qlonglong(id)}});
    QTRY_VERIFY_WITH_TIMEOUT(desktop.find<QLabel>(QStringLiteral("playback.readout")), kPatience_ms);
    auto* screen = desktop.screen<desktop::PlaybackScreen>();
    const auto readout = [&] { return desktop.find<QLabel>(QStringLiteral("playback.readout"))->text(); };
    screen->clock().seek(0.5 * screen->clock().duration_s());
    QVERIFY2(readout().contains(QStringLiteral("depth")), qPrintable(readout()));
    screen->clock().seek(screen->clock().duration_s());
    QVERIFY2(readout().startsWith(QStringLiteral("Completed")), qPrintable(readout()));
    auto* box = desktop.find<QCheckBox>(QStringLiteral("playback.depth_of_field"));
    QVERIFY(box && box->isEnabled() && !box->isChecked());
    QTest::qWait(100); // the scene is there
    box->click();
    QVERIFY(
        desktop.context.navigator().current().parameters.value(QStringLiteral("depth_of_field")).toBool());
    QVERIFY(desktop.find<report::PlotView>(QStringLiteral("playback.alignment_plot")));
}

void TestInsertionReview::itsDebriefShowsTheWay() {
    tests::DesktopFixture desktop;
    const database::SessionId id = tests::addInsertion(desktop, "tina");
    desktop.logIn("tina");
    desktop.go(QStringLiteral("debrief"), {{QStringLiteral("session"), qlonglong(id)}});
    QTRY_VERIFY_WITH_TIMEOUT(desktop.find<report::PlotView>(QStringLiteral("debrief.alignment")),
                             kPatience_ms);
    QVERIFY(desktop.find<report::PlotView>(QStringLiteral("debrief.offset")));
    QVERIFY(!desktop.find<report::PlotView>(QStringLiteral("debrief.scatter")));
    QVERIFY(desktop.find<QLabel>(QStringLiteral("debrief.verdict")));
    auto connection = desktop.database().openReader();
    auto stored = session::SessionView::open(**connection, desktop.actor("tina"), id);
    QVERIFY(stored.has_value());
    QVERIFY((*stored)->record().summary.state == database::SessionState::completed);
    const auto report = session_report::reportDataOf(**stored, **connection, desktop.actor("tina"), "en");
    QVERIFY(report.has_value() && report->sections.size() == 1);
    const auto* section = dynamic_cast<const report::InsertionSection*>(report->sections.front().get());
    QVERIFY(section && section->profile().depth_mm.back() > 34.0);
    QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("report.pdf"));
    QVERIFY(report::writeSessionPdf(file, *report, report::lightTheme(QLocale::c())).has_value());
    const auto pictures = report::writeSessionPngs(folder.path(), *report, report::lightTheme(QLocale::c()));
    QVERIFY(pictures.has_value());
    QVERIFY(QFile::exists(folder.filePath(QStringLiteral("insertion.png"))));
    if (const QString keep = qEnvironmentVariable("CHIRON_KEEP_PICTURES"); !keep.isEmpty())
        QFile::copy(folder.filePath(QStringLiteral("insertion.png")),
                    keep + QStringLiteral("/insertion.png"));
}

QTEST_MAIN(TestInsertionReview)
#include "test_insertion_review.moc"
