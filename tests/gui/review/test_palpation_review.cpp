// SPDX-License-Identifier: GPL-3.0-or-later
// A palpation looked back at: playback, debrief and the curve over sessions, by real controls.
#include "app/exercises/palpation/desktop/palpation_box.h"
#include "app/exercises/palpation/desktop/palpation_layer.h"
#include "app/exercises/palpation/desktop/palpation_map_view.h"
#include "app/exercises/palpation/desktop/roc_box.h"
#include "app/exercises/palpation/scene/palpation_overlay.h"
#include "app/exercises/palpation/session/palpation_marks.h"
#include "database/repositories/score_repository.h"
#include "database/repositories/session_reader.h"
#include "desktop/playback/playback_plots.h"
#include "desktop/playback/playback_scene.h"
#include "desktop/playback/playback_screen.h"
#include "desktop/widgets/state_panel.h"
#include "report/plot_view.h"
#include "report/report_text.h"
#include "session_report/metric_words.h"
#include "support/every_place.h"
#include "support/palpation_session.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QListWidget>
#include <cmath>
#include <limits>
#include <sqlite3.h>

using namespace chiron;
using namespace chiron::tests;
using desktop::PalpationReplay;

namespace {

PalpationReplay& replayOf(desktop::PlaybackData& data) {
    return *dynamic_cast<desktop::PalpationLayer&>(*data.layer).replay();
}

} // namespace

class TestPalpationReview : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() {
        m_desktop = std::make_unique<DesktopFixture>();
        m_session = addPalpation(*m_desktop, "tina");
        QVERIFY2(m_session != 0, "the catalogue has no palpation");
        m_desktop->logIn("tina");
    }
    void cleanupTestCase() { m_desktop.reset(); }

    void everyMomentIsAsItWas() {
        auto data = load();
        PalpationReplay& replay = replayOf(data);
        const PalpatingHand hand(replay.level(), kPalpationSeed);
        const auto& trials = data.track.trials;
        QCOMPARE(trials.size(), hand.trials().size());
        for (std::size_t i = 0; i < trials.size(); ++i) {
            const bool lump = hand.trials()[i].lumps > 0;
            const auto before = replay.cuesAt(data.track, trials[i].start_s + 0.3, true);
            QCOMPARE(desktop_count(before), 0);
            QCOMPARE(before.lumps, hand.trials()[i].lumps);
            QCOMPARE(replay.cuesAt(data.track, trials[i].start_s + 0.3, false).lumps, 0);
            const auto end = replay.cuesAt(data.track, trials[i].end_s - 0.05, true);
            QCOMPARE(desktop_count(end), (lump && i != 2 ? 1 : 0) + (i == 1 ? 1 : 0));
            if (lump && i != 2)
                QCOMPARE(int(end.finding[0].confidence), int(5 - i));
        }
    }

    void theMapGrowsAndIsTheSameWherever() {
        auto data = load();
        PalpationReplay& replay = replayOf(data);
        const session::PlaybackTrial& trial = data.track.trials[0];
        const auto coverageAt = [&](double t_s, bool whole) {
            scene3d::SceneState state;
            replay.showIn(state, data.track, t_s, {true, whole, simulation::SurfaceMapKind::coverage});
            return state.overlay.of<scene3d::PalpationOverlay>().map->coverage();
        };
        const double early = coverageAt(trial.start_s + 1.1, false);
        const double late = coverageAt(trial.end_s, false);
        QVERIFY(coverageAt(trial.start_s + 0.3, false) == 0.0);
        QVERIFY(early > 0.0 && late > 1.5 * early);
        QCOMPARE(coverageAt(trial.start_s + 1.1, false), early); // back in time, and the same
        QCOMPARE(coverageAt(trial.start_s + 0.3, true), late);   // of the whole trial, whenever
        QVERIFY(std::abs(late - replay.record(0)->coverage) < 0.02);
        const auto direct = session::mapAt(replay.level(), data.track, 0, trial.start_s + 1.1);
        QCOMPARE(direct.coverage(), early);
    }

    /// Of several fingers, the one that presses hardest is told, whichever it is.
    void theReadoutIsOfTheFingerThatPressesHardest() {
        const QLocale english(QLocale::English, QLocale::UnitedKingdom);
        const desktop::PalpationLayer layer(PalpationReplay(simulation::PalpationParameters{}, {}));
        constexpr int kFingers = 4;
        for (int hardest = 0; hardest < kFingers; ++hardest) {
            session::PlaybackTrack track;
            track.toolCount = kFingers;
            track.moments.resize(1);
            for (int finger = 0; finger < kFingers; ++finger) {
                session::PlaybackTool tool;
                tool.tissue_N = core::Vec3(0.0, 0.0, finger == hardest ? 2.5 : 0.5 + 0.1 * finger);
                track.tools.push_back(tool);
                const std::string number = std::to_string(finger);
                track.quantities.push_back({"depth_" + number + "_m", "m", {0.001 * (finger + 1)}});
                track.quantities.push_back({"lean_" + number + "_rad", "rad", {0.1 * (finger + 1)}});
            }
            const QString said = layer.readout(track, track.at(0.0), 0.0, english);
            const QString depth = report::formatValue(hardest + 1.0, QStringLiteral("mm"), english);
            for (const QString& part :
                 {QStringLiteral("force ") + report::formatValue(2.5, QStringLiteral("N"), english),
                  QStringLiteral("tilt %1°").arg(qRound(0.1 * (hardest + 1) * 180.0 / M_PI)),
                  QStringLiteral("depth ") + depth, QStringLiteral("Trial 1")})
                QVERIFY2(said.contains(part), qPrintable(said + QStringLiteral(" lacks ") + part));
        }
    }

    void whatBecameOfFindingsIsDrawn() {
        auto data = load();
        scene3d::SceneState state;
        replayOf(data).showIn(state, data.track, data.track.trials[1].end_s - 0.05, {});
        const PalpatingHand hand(replayOf(data).level(), kPalpationSeed);
        const bool lump = hand.trials()[1].lumps > 0;
        const std::size_t wrong = lump ? 1 : 0;
        QCOMPARE(int(state.overlay.of<scene3d::PalpationOverlay>().outcome[wrong]),
                 int(simulation::FindingOutcome::falseAlarm));
        if (lump)
            QCOMPARE(int(state.overlay.of<scene3d::PalpationOverlay>().outcome[0]),
                     int(simulation::FindingOutcome::hit));
        replayOf(data).showIn(state = {}, data.track, data.track.trials[1].end_s - 0.05, {.truth = false});
        QCOMPARE(int(state.overlay.of<scene3d::PalpationOverlay>().outcome[wrong]),
                 int(simulation::FindingOutcome::open));
        if (hand.trials()[2].lumps > 0) { // taken back: missed
            replayOf(data).showIn(state = {}, data.track, data.track.trials[2].end_s - 0.05, {});
            QCOMPARE(int(state.overlay.of<scene3d::PalpationOverlay>().lumpsMissed), 1);
        }
    }

    void playbackHasItsSwitchesPlotsAndMarks() {
        go("playback");
        auto* screen = m_desktop->screen<desktop::PlaybackScreen>();
        QVERIFY(screen);
        auto* truth = m_desktop->find<QCheckBox>(QStringLiteral("playback.truth"));
        QVERIFY(truth && truth->isChecked());
        truth->click();
        QVERIFY(!m_desktop->context.navigator().current().parameters.value(QStringLiteral("truth")).toBool());
        m_desktop->find<QCheckBox>(QStringLiteral("playback.whole_trial"))->click();
        m_desktop->find<QCheckBox>(QStringLiteral("playback.force_map"))->click();
        QVERIFY(m_desktop->find<report::PlotView>(QStringLiteral("playback.lean_plot")));
        QVERIFY(m_desktop->find<report::PlotView>(QStringLiteral("playback.depth_plot")));
        bool jumped = false;
        for (auto* list : m_desktop->window->findChildren<QListWidget*>())
            for (int row = 0; row < list->count(); ++row)
                if (list->item(row)->text().contains(QStringLiteral("Finding 1 marked"))) {
                    list->setCurrentRow(row);
                    emit list->itemActivated(list->item(row));
                    jumped = true;
                }
        QVERIFY(jumped);
        QVERIFY(m_desktop->find<QLabel>(QStringLiteral("playback.readout"))
                    ->text()
                    .contains(QStringLiteral("findings")));
    }

    void missesAndFalseAlarmsAreEventsAsScored() {
        auto connection = m_desktop->database().openReader();
        const database::Actor tina = m_desktop->actor("tina");
        const auto card = database::ScoreRepository(**connection, tina).scores(m_session);
        const auto events = database::SessionReader(**connection, tina).events(m_session);
        QVERIFY(card && events);
        const auto data = load();
        const auto scored = [&](const char* id) {
            for (const scoring::MetricValue& metric : card->metrics)
                if (metric.id == id)
                    return static_cast<long>(metric.value.value_or(-1.0));
            return -1L;
        };
        const auto stored = [&](const char* kind) {
            return std::count_if(events->begin(), events->end(),
                                 [kind](const auto& event) { return event.kind == kind; });
        };
        const auto marked = [&](const session::PlaybackMarkKind& kind) {
            return std::count_if(data.track.marks.begin(), data.track.marks.end(),
                                 [kind](const auto& mark) { return mark.kind == kind; });
        };
        QVERIFY(scored("palpation_misses") > 0 && scored("palpation_false_alarms") > 0);
        QCOMPARE(stored("lump_missed"), scored("palpation_misses"));
        QCOMPARE(stored("false_alarm"), scored("palpation_false_alarms"));
        QCOMPARE(marked(session::mark_kinds::kLumpMissed), scored("palpation_misses"));
        QCOMPARE(marked(session::mark_kinds::kFalseAlarm), scored("palpation_false_alarms"));
        QVERIFY(std::is_sorted(events->begin(), events->end(),
                               [](const auto& a, const auto& b) { return a.tick < b.tick; }));
        for (const database::EventRecord& event : *events)
            if (event.kind == "false_alarm" || event.kind == "lump_missed")
                QVERIFY(std::abs(data.track.timeOfTick(event.tick) - event.time_s) < 0.005);
    }

    void theDebriefTellsEachTrial() {
        go("debrief");
        auto* choice = m_desktop->find<QComboBox>(QStringLiteral("debrief.trial"));
        QVERIFY(choice);
        QCOMPARE(choice->count(), 4);
        auto* words = m_desktop->find<QLabel>(QStringLiteral("debrief.palpation"));
        choice->setCurrentIndex(1);
        QVERIFY2(words->text().contains(QStringLiteral("Findings where there was no lump: 1")),
                 qPrintable(words->text()));
        auto* map = m_desktop->find<desktop::PalpationMapView>(QStringLiteral("debrief.force_map"));
        QVERIFY(map && !map->accessibleDescription().isEmpty());
        QCOMPARE(int(map->view().kind), int(simulation::SurfaceMapKind::force));
        QVERIFY(m_desktop->find<QLabel>(QStringLiteral("debrief.lumps"))
                    ->text()
                    .contains(QStringLiteral("no lump there")));
    }

    /// What there was, what was reported, and how much was searched.
    void aTrialIsSummedUp() {
        session::PalpationTrialRecord record;
        record.coverage = 0.847;
        const auto words = [&] { return desktop::palpationSummary(record, QLocale::c()); };
        QCOMPARE(words(), QStringLiteral("There was no lump, and none was reported. Searched: 84 %."));
        record.answer.matches = {{0, scoring::FindingMatch::kNone, std::numeric_limits<double>::infinity()}};
        QCOMPARE(words(),
                 QStringLiteral("There was no lump. Findings where there was no lump: 1. Searched: 84 %."));
        QCOMPARE(desktop::palpationLines(record, {}, QLocale::c()),
                 QStringList{QStringLiteral("Finding 1: no lump there")});
        record.answer.truth.lumps.resize(3);
        record.answer.matches = {{0, 1, 0.004}, {1, 2, 0.005}};
        record.timedOut = true;
        QCOMPARE(words(), QStringLiteral("Lumps found: 2 of 3. Searched: 84 %. Time was up before the search "
                                         "was reported as done."));
    }

    /// Each lump with the finding that found it and what was stated of it, then each finding that found none.
    void eachLumpIsToldWithItsFinding() {
        using simulation::ReportField;
        session::PalpationTrialRecord record;
        record.answer.truth.lumps = {{core::Vec3::Zero(), 0.012, 0.0075, 5},
                                     {core::Vec3::Zero(), 0.010, 0.005, 3}};
        simulation::FindingsBook& book = record.answer.findings;
        book.place(0, {0.01, 0.0, 0.0});
        (void)book.rate(0, ReportField::size, 70); // tenths of a millimetre
        (void)book.rate(0, ReportField::hardness, 4);
        (void)book.rate(0, ReportField::confidence, 5);
        book.place(2, {0.0, 0.03, 0.0});
        record.answer.matches = {{0, 1, 0.0042}, {2, scoring::FindingMatch::kNone, 0.0306}};
        simulation::PalpationParameters level;
        level.asksSize = level.asksHardness = level.asksConfidence = true;
        QCOMPARE(
            desktop::palpationLines(record, level, QLocale::c()),
            (QStringList{"Lump 1 (15 mm across, 12 mm deep): missed",
                         "Lump 2: found, finding 1, 4 mm from its centre; stated size 14 mm across, true "
                         "size 10 mm across; stated hardness firm, true hardness medium; confidence: "
                         "certain",
                         "Finding 3: no lump there; the nearest was 31 mm away"}));
        level.asksSize = level.asksHardness = level.asksConfidence = false;
        QCOMPARE(desktop::palpationLines(record, level, QLocale::c()).at(1),
                 QStringLiteral("Lump 2: found, finding 1, 4 mm from its centre"));
    }

    void tooFewAnswersMakeNoCurve() {
        m_desktop->go(QStringLiteral("results"), {{QStringLiteral("exercise"), QStringLiteral("palpation")},
                                                  {QStringLiteral("level"), 1}});
        QVERIFY(waitUntilLoaded(*m_desktop));
        auto* box = m_desktop->find<desktop::RocBox>(QStringLiteral("results.detection"));
        QVERIFY(box && box->isVisible());
        QCOMPARE(int(box->findChild<desktop::StatePanel*>()->state()),
                 int(desktop::StatePanel::State::empty));
    }

    void enoughAnswersMakeOne() {
        session::PooledDetection pooled;
        pooled.sessions = 6;
        pooled.ratings.ofSignal = {12, 5, 3, 1, 1, 0, 2};
        pooled.ratings.ofNoise = {0, 1, 2, 3, 4, 0, 40};
        const auto curve = scoring::rocOf(pooled.ratings);
        QVERIFY(curve && curve->area > 0.8);
        const QString words = desktop::rocSummary(pooled, true, *curve, QLocale::c());
        QVERIFY2(words.contains(QStringLiteral("24, without: 50")), qPrintable(words));
        desktop::Theme theme = desktop::Theme::load(desktop::ThemeName::light, 1.0).value();
        desktop::RocBox box(theme, QLocale::c());
        box.show(pooled, true);
        QVERIFY(box.findChild<report::PlotView*>(QStringLiteral("results.roc")));
        pooled.ratings.ofSignal = {5, 1, 0, 0, 0, 0, 2};
        desktop::RocBox few(theme, QLocale::c());
        few.show(pooled, true);
        QVERIFY(!few.findChild<report::PlotView*>(QStringLiteral("results.roc")));
    }

    /// Scores, movement and force do not hang on what was reported.
    void lostReportsLoseFindingsOnly() {
        const database::SessionId lost = addPalpation(*m_desktop, "tina", kPalpationSeed + 1);
        loseReports(lost);
        m_desktop->go(QStringLiteral("debrief"), {{QStringLiteral("session"), qlonglong(lost)}});
        QVERIFY(waitUntilLoaded(*m_desktop));
        QStringList titles;
        for (const auto* title :
             m_desktop->window->screen()->findChildren<QLabel*>(QStringLiteral("state.title")))
            if (title->isVisible())
                titles << title->text();
        QCOMPARE(titles.size(), 1); // everything else is there
        QVERIFY2(titles[0].contains(QStringLiteral("Findings and maps could not be read")),
                 qPrintable(titles[0]));
        m_desktop->go(QStringLiteral("playback"), {{QStringLiteral("session"), qlonglong(lost)}});
        QVERIFY(waitUntilLoaded(*m_desktop));
        auto* said = m_desktop->find<QLabel>(QStringLiteral("playback.layer_lost"));
        QVERIFY(said && said->isVisible());
        QVERIFY2(said->text().contains(QStringLiteral("trial 1: the trace has no reports")),
                 qPrintable(said->text()));
        QVERIFY(!m_desktop->find<QCheckBox>(QStringLiteral("playback.truth")));
        QVERIFY(m_desktop->find<QLabel>(QStringLiteral("playback.readout"))
                    ->text()
                    .contains(QStringLiteral("force")));
    }

    void everyMetricHasWords() {
        const auto* level = m_desktop->context.site().catalogue().find("palpation", 1);
        for (const auto& metric : level->metrics)
            QVERIFY2(!session_report::metricMeaning(QString::fromStdString(metric.id)).isEmpty(),
                     metric.id.c_str());
    }

private:
    static int desktop_count(const simulation::PalpationCues& cues) {
        return static_cast<int>(std::count_if(cues.finding.begin(), cues.finding.end(),
                                              [](const simulation::Finding& one) { return one.present; }));
    }
    desktop::PlaybackData load() {
        auto connection = m_desktop->database().openReader();
        auto data = desktop::loadPlayback(**connection, m_desktop->actor("tina"), m_session,
                                          [](double) { return true; });
        if (!data)
            qFatal("%s", data.error().message.c_str());
        return std::move(*data);
    }
    /// In the file, past everything that keeps it whole: the channel that counts reports is another one's.
    void loseReports(database::SessionId session) {
        sqlite3* raw = nullptr;
        QCOMPARE(sqlite3_open(m_desktop->file().toUtf8().constData(), &raw), SQLITE_OK);
        sqlite3_stmt* read = nullptr;
        const QByteArray select =
            "SELECT channel_table FROM session WHERE id = " + QByteArray::number(qlonglong(session));
        QCOMPARE(sqlite3_prepare_v2(raw, select.constData(), -1, &read, nullptr), SQLITE_OK);
        QCOMPARE(sqlite3_step(read), SQLITE_ROW);
        QByteArray table(static_cast<const char*>(sqlite3_column_blob(read, 0)),
                         sqlite3_column_bytes(read, 0));
        sqlite3_finalize(read);
        QVERIFY(table.contains("report_count"));
        table.replace("report_count", "report_other");
        const QByteArray write = "UPDATE session SET channel_table = x'" + table.toHex() +
                                 "' WHERE id = " + QByteArray::number(qlonglong(session));
        QCOMPARE(sqlite3_exec(raw, write.constData(), nullptr, nullptr, nullptr), SQLITE_OK);
        sqlite3_close(raw);
    }
    void go(const char* screen) {
        m_desktop->go(QLatin1String(screen), {{QStringLiteral("session"), qlonglong(m_session)}});
        QVERIFY(waitUntilLoaded(*m_desktop));
    }

    std::unique_ptr<DesktopFixture> m_desktop;
    database::SessionId m_session = 0;
};

QTEST_MAIN(TestPalpationReview)
#include "test_palpation_review.moc"
