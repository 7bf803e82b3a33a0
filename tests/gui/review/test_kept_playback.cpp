// SPDX-License-Identifier: GPL-3.0-or-later
// Recordings of every exercise played back, moment after moment, against what was read and kept: what the
// scene is told to show, the words and numbers beside it, where keys and marks lead, what a second session
// adds. A change that is meant is kept anew, and the difference is read in review: CHIRON_STORE_OUTLINES=1
// QT_QPA_PLATFORM=offscreen build/release/tests/gui/review/test_kept_playback
#include "app/exercises/palpation/desktop/palpation_layer.h"
#include "app/exercises/palpation/scene/palpation_overlay.h"
#include "cues/laparoscopy_cues.h"
#include "desktop/playback/playback_data.h"
#include "desktop/playback/playback_plots.h"
#include "desktop/playback/playback_scene.h"
#include "desktop/playback/playback_screen.h"
#include "desktop/playback/scrubber.h"
#include "modules/exercises/urethra_insertion/cues/endoscope_cues.h"
#include "report/plot_view.h"
#include "support/every_place.h"
#include "support/kept_text.h"
#include "support/paint_outline.h"
#include "support/patience.h"
#include "support/screen_outline.h"

#include <QCheckBox>
#include <QComboBox>
#include <QHelpEvent>
#include <QLabel>
#include <QListWidget>
#include <QPlainTextEdit>
#include <QToolTip>
#include <tuple>

using chiron::tests::kPatience_ms;

using namespace chiron;

namespace {

/// To four digits; lengths in mm.
QString number(double x) {
    return QString::number(std::abs(x) < 1e-6 ? 0.0 : x, 'g', 4);
}
template <class V> QString place(const V& p_m) {
    return QStringLiteral("%1,%2,%3").arg(number(1e3 * p_m[0]), number(1e3 * p_m[1]), number(1e3 * p_m[2]));
}

QString toolWords(const scene3d::ToolView& tool) {
    return QStringLiteral("at %1 drawn %2%3 turned %4,%5,%6,%7 force %8,%9,%10 jaw %11")
        .arg(place(tool.p_WT), place(tool.p_WProxy),
             tool.drawnAtSurface ? QStringLiteral(" at the surface") : QString(), number(tool.q_WT.w()),
             number(tool.q_WT.x()), number(tool.q_WT.y()), number(tool.q_WT.z()), number(tool.force_N.x()),
             number(tool.force_N.y()), number(tool.force_N.z()), number(tool.jaw_rad));
}

void addLaparoscopy(const core::LaparoscopyCues& cues, QStringList& lines) {
    if (!cues.present)
        return;
    QString text = QStringLiteral("grasp step %1 dwell %2%3%4")
                       .arg(static_cast<int>(cues.step))
                       .arg(number(cues.dwell), cues.torn ? QStringLiteral(" torn") : QString(),
                            cues.objectShown ? QString() : QStringLiteral(" hidden"));
    if (cues.tube)
        text += QStringLiteral("; tube %1 longer %2")
                    .arg(number(1e3 * cues.restLength_m), number(1e3 * cues.stretch_m));
    for (int i = 0; i < cues.grips; ++i) {
        const auto k = static_cast<std::size_t>(i);
        text += QStringLiteral("; grip %1 share %2 held %3%4")
                    .arg(place(cues.p_WGrip[k]), number(cues.gripAt[k]))
                    .arg(cues.gripHeldBy[k])
                    .arg(cues.gripAnchored[k] ? QStringLiteral(" fixed") : QString());
    }
    if (cues.tensionShown)
        text += QStringLiteral("; tension %1 of %2 to %3")
                    .arg(number(cues.tension_N), number(cues.bandLow_N), number(cues.bandHigh_N));
    if (cues.fold)
        text += QStringLiteral("; fold %1 from %2 held %3%4 pull %5 of %6 to %7")
                    .arg(place(cues.p_WFoldEdge), place(cues.p_WFoldBase))
                    .arg(cues.foldHeldBy)
                    .arg(cues.foldOpen ? QStringLiteral(" open") : QString(), number(cues.retraction_N),
                         number(cues.retractionLow_N), number(cues.retractionHigh_N));
    for (int i = 0; i < cues.bodies; ++i) {
        const core::BodyCue& body = cues.body[static_cast<std::size_t>(i)];
        text += QStringLiteral("; body %1 radius %2 held %3 squeezed %4")
                    .arg(place(body.p_W), number(1e3 * body.radius_m))
                    .arg(body.heldBy)
                    .arg(number(1e3 * body.squeeze_m));
    }
    if (cues.targetShown)
        text += QStringLiteral("; target %1 radius %2")
                    .arg(place(cues.p_WTarget), number(1e3 * cues.targetRadius_m));
    if (cues.squeezeShown)
        text += QStringLiteral("; squeeze %1 limit %2")
                    .arg(number(cues.squeeze_N[0]), number(cues.squeezeLimit_N));
    lines << text;
}

void addPalpation(const scene3d::SceneState& state, QStringList& lines) {
    const simulation::PalpationCues& cues = state.exercise.of<simulation::PalpationCues>();
    if (!cues.present)
        return;
    QString text = QStringLiteral("palpation searched %1 band %2 to %3 asks %4%5%6 leans over %7")
                       .arg(number(cues.coverage), number(cues.bandLow_N), number(cues.bandHigh_N))
                       .arg(cues.asksSize)
                       .arg(cues.asksHardness)
                       .arg(cues.asksConfidence)
                       .arg(cues.leanSaturated);
    for (std::size_t i = 0; i < 2; ++i)
        text += QStringLiteral("; finger depth %1 lean %2 squeeze %3")
                    .arg(number(1e3 * cues.depth_m[i]), number(cues.lean_rad[i]),
                         cues.squeezeShown ? number(cues.squeeze_N[i]) : QStringLiteral("none"));
    for (std::size_t i = 0; i < cues.finding.size(); ++i)
        if (cues.finding[i].present)
            text += QStringLiteral("; finding %1 radius %2 confidence %3%4 is %5")
                        .arg(place(cues.finding[i].p_W), number(1e3 * cues.finding[i].radius_m))
                        .arg(cues.finding[i].confidence)
                        .arg(int(i) == cues.selected ? QStringLiteral(" chosen") : QString())
                        .arg(static_cast<int>(state.overlay.of<scene3d::PalpationOverlay>().outcome[i]));
    for (int i = 0; i < cues.lumps; ++i)
        text +=
            QStringLiteral("; lump %1 radius %2%3")
                .arg(place(cues.lump[std::size_t(i)].p_W), number(1e3 * cues.lump[std::size_t(i)].radius_m),
                     state.overlay.of<scene3d::PalpationOverlay>().lumpsMissed >> i & 1
                         ? QStringLiteral(" missed")
                         : QString());
    if (state.overlay.of<scene3d::PalpationOverlay>().map)
        text += QStringLiteral("; map %1 searched %2")
                    .arg(static_cast<int>(state.overlay.of<scene3d::PalpationOverlay>().mapKind))
                    .arg(number(state.overlay.of<scene3d::PalpationOverlay>().map->coverage()));
    lines << text;
}

/// What the scene is told to show.
QStringList sceneLines(const scene3d::SceneState& state) {
    QStringList lines;
    for (const scene3d::ToolView& tool : state.tool)
        if (tool.present)
            lines << QStringLiteral("tool ") + toolWords(tool);
    if (state.ghost.present)
        lines << QStringLiteral("ghost ") + toolWords(state.ghost);
    lines << QStringLiteral("object%1 %2 turned %3%4%5")
                 .arg(state.objectShown ? QString() : QStringLiteral(" hidden"), place(state.p_WObject),
                      number(state.exercise.of<core::LaparoscopyCues>().body[0].q_W[3]),
                      state.dimpleShown ? QStringLiteral(" dimple %1,%2")
                                              .arg(number(1e3 * state.dimpleCentre_m.x()),
                                                   number(1e3 * state.dimpleCentre_m.y()))
                                        : QString(),
                      state.marked ? QStringLiteral(" marked ") + place(state.p_WMark) : QString());
    if (state.exercise.of<simulation::EndoscopeCues>().present)
        lines << QStringLiteral("endoscope stage %1 depth %2 landmarks %3 of %4 %5%6")
                     .arg(static_cast<int>(state.exercise.of<simulation::EndoscopeCues>().stage))
                     .arg(number(1e3 * state.exercise.of<simulation::EndoscopeCues>().depth_m))
                     .arg(state.exercise.of<simulation::EndoscopeCues>().landmarksSeen)
                     .arg(state.exercise.of<simulation::EndoscopeCues>().landmarks)
                     .arg(state.exercise.of<simulation::EndoscopeCues>().pictureShown)
                     .arg(state.exercise.of<simulation::EndoscopeCues>().guided);
    addLaparoscopy(state.exercise.of<core::LaparoscopyCues>(), lines);
    addPalpation(state, lines);
    return lines;
}

} // namespace

class TestKeptPlayback : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() {
        m_desktop = std::make_unique<tests::DesktopFixture>();
        const tests::VisitedSessions sessions = tests::addVisitedSessions(*m_desktop);
        m_sessions = {{"sphere", sessions.good},
                      {"sphere pressed too hard", sessions.bad},
                      {"insertion", sessions.insertion},
                      {"tube", sessions.tube},
                      {"tube in two hands", sessions.tubeTwoHanded},
                      {"objects", sessions.handling},
                      {"palpation", sessions.palpation}};
        for (const auto& [name, exercise, level] : {std::tuple{"tube passed on", "elastic_tube", 3},
                                                    {"tube under a fold", "elastic_tube", 6},
                                                    {"many objects", "object_handling", 4}})
            m_sessions.push_back({name, tests::addGrasping(*m_desktop, "tina", exercise, level)});
        m_desktop->logIn("tina");
        m_desktop->window->resize(1280, 720);
    }
    void cleanupTestCase() { m_desktop.reset(); }

    void isPlayedAsItWas_data() {
        QTest::addColumn<qint64>("session");
        for (const auto& [name, session] : m_sessions)
            QTest::newRow(name) << qint64(session);
    }
    void isPlayedAsItWas() {
        QFETCH(qint64, session);
        QVERIFY(session != 0);
        auto data = load(session);
        open(session);
        m_lines.clear();
        std::vector<double> moments_s{0.0, data.track.duration_s};
        for (const double share : {0.11, 0.27, 0.43, 0.61, 0.79, 0.93})
            moments_s.push_back(share * data.track.duration_s);
        for (const session::PlaybackTrial& trial : data.track.trials)
            if (trial.index < 3)
                moments_s.insert(moments_s.end(),
                                 {trial.start_s + 0.5, trial.end_s - 0.02, trial.end_s + 0.02});
        for (const double t_s : moments_s)
            moment(data, t_s, nullptr);
        lists();
        keys();
        timeBar(data);
        ghosts(session);
        if (auto* palpation = dynamic_cast<desktop::PalpationLayer*>(data.layer.get()))
            looks(data, *palpation->replay());
        const QString differs = m_kept.differs(QLatin1String(QTest::currentDataTag()), m_lines);
        QVERIFY2(differs.isEmpty(), qPrintable(differs));
        ++m_held;
    }
    /// A second session beside the first: where its instrument was at that moment of its own trial, and its
    /// lines in the plots.
    void aSecondOneIsBesideItAsItWas() {
        m_lines.clear();
        auto first = load(m_sessions[1].second);
        auto second = load(m_sessions[0].second);
        for (const double share : {0.05, 0.2, 0.4, 0.6, 0.8, 1.0})
            moment(first, share * first.track.duration_s, &second.track, false);
        auto third = load(m_sessions[2].second);
        moment(third, 0.4 * third.track.duration_s, &third.track, false);
        const auto theme = desktop::Theme::load(desktop::ThemeName::light, 1.0).value();
        for (const auto& [of, beside] : {std::pair{&first, &second}, {&third, &third}}) {
            desktop::PlaybackPlots plots(theme, m_desktop->context.locale(), of->track, of->setup.level,
                                         of->layer.get());
            plots.setGhost(session::ghostSeries(of->track, beside->track), QStringLiteral("second session"));
            plots.showCursor(1.5);
            m_lines << tests::ScreenOutline::of(plots);
        }
        const QString differs = m_kept.differs(QStringLiteral("a second session"), m_lines);
        QVERIFY2(differs.isEmpty(), qPrintable(differs));
    }
    /// What nobody asks for again is no longer kept.
    void keepsNothingOfNoSession() {
        if (m_held > 1) // not of one row alone
            QCOMPARE(m_kept.unseen(), QStringList());
    }

private:
    desktop::PlaybackScreen& screen() { return *m_desktop->screen<desktop::PlaybackScreen>(); }
    template <class W> W* find(const char* name) { return screen().findChild<W*>(QLatin1String(name)); }
    desktop::PlaybackData load(database::SessionId session) {
        auto connection = m_desktop->database().openReader();
        auto data = desktop::loadPlayback(**connection, m_desktop->actor("tina"), session,
                                          [](double) { return true; });
        if (!data)
            qFatal("%s", data.error().message.c_str());
        return std::move(*data);
    }
    void open(database::SessionId session) {
        m_desktop->go(QStringLiteral("playback"), {{QStringLiteral("session"), qlonglong(session)}});
        QVERIFY(tests::waitUntilLoaded(*m_desktop));
        QTRY_VERIFY_WITH_TIMEOUT(find<QWidget>("playback.scene"), kPatience_ms);
    }
    void say(const QString& line) { m_lines << line; }
    QString position() { return number(screen().clock().position_s()); }

    void moment(desktop::PlaybackData& data, double t_s, const session::PlaybackTrack* ghost,
                bool shown = true) {
        say(QStringLiteral("-- at %1 s").arg(number(t_s)));
        scene3d::SceneState state = desktop::sceneStateAt(data.track, ghost, t_s, data.layer.get());
        m_lines << sceneLines(state);
        if (!shown)
            return;
        screen().clock().seek(t_s);
        say(QStringLiteral("reads \"%1\" \"%2\" \"%3\" heard \"%4\"")
                .arg(find<QLabel>("playback.readout")->text(), find<QLabel>("playback.time")->text(),
                     find<QPushButton>("playback.comment_add")->text(),
                     find<QWidget>("playback.scrubber")->accessibleDescription()));
        for (auto* plot : screen().findChildren<QWidget*>())
            if (const auto* view = dynamic_cast<const report::PlotView*>(plot);
                view && std::abs(view->cursorX() - screen().clock().position_s()) > 1e-9)
                say(QStringLiteral("elsewhere %1 %2").arg(plot->objectName(), number(view->cursorX())));
    }
    void lists() {
        auto* marks = find<QListWidget>("playback.marks");
        for (const bool penalties : {false, true}) {
            find<QCheckBox>("playback.contacts")->setChecked(!penalties);
            find<QCheckBox>("playback.penalties_only")->setChecked(penalties);
            say(penalties ? QStringLiteral("-- penalties") : QStringLiteral("-- all events"));
            m_lines << tests::ScreenOutline::of(*marks->parentWidget());
        }
        find<QCheckBox>("playback.penalties_only")->setChecked(false);
        for (const int row : {0, marks->count() / 2, marks->count() - 1}) {
            marks->setCurrentRow(row);
            say(QStringLiteral("event %1 leads to %2").arg(row).arg(position()));
        }
    }
    void keys() {
        say(QStringLiteral("-- keys"));
        auto* bar = find<desktop::Scrubber>("playback.scrubber");
        const auto press = [&](const char* what, Qt::Key key, Qt::KeyboardModifiers with = {},
                               int times = 1) {
            QStringList places;
            for (int i = 0; i < times; ++i) {
                QTest::keyClick(bar, key, with);
                places << position();
            }
            say(QStringLiteral("%1: %2").arg(QLatin1String(what), places.join(QLatin1Char(' '))));
        };
        screen().clock().seek(0.0);
        press("next event", Qt::Key_Right, Qt::ControlModifier, 6);
        press("last event", Qt::Key_Left, Qt::ControlModifier, 7);
        press("a second on", Qt::Key_Right, Qt::ShiftModifier, 2);
        press("a second back", Qt::Key_Left, Qt::ShiftModifier);
        press("page on", Qt::Key_PageUp, {}, 2);
        press("page back", Qt::Key_PageDown);
        press("a picture on", Qt::Key_Right, {}, 2);
        press("a picture back", Qt::Key_Left);
        press("the end", Qt::Key_End);
        press("no further", Qt::Key_Right, Qt::ShiftModifier);
        press("the beginning", Qt::Key_Home);
        press("nothing before it", Qt::Key_Left, Qt::ControlModifier);
    }
    /// How the time bar is painted, and its tooltips.
    void timeBar(const desktop::PlaybackData& data) {
        auto* bar = find<desktop::Scrubber>("playback.scrubber");
        bar->resize(800, 48);
        say(QStringLiteral("-- time bar"));
        screen().clock().seek(0.4 * data.track.duration_s);
        m_lines << tests::OutlineDevice::of(*bar);
        say(QStringLiteral("-- tips"));
        for (const double share : {-0.1, 0.0, 0.3, 0.5, 0.7, 1.0, 1.1}) {
            const QPoint at(qRound(bar->xOf(share * data.track.duration_s)), bar->height() / 2);
            QHelpEvent asks(QEvent::ToolTip, at, bar->mapToGlobal(at));
            QCoreApplication::sendEvent(bar, &asks);
            say(QStringLiteral("at %1 \"%2\"")
                    .arg(number(share), QToolTip::text().replace(QLatin1Char('\n'), QLatin1Char('|'))));
            QToolTip::hideText();
        }
    }
    void ghosts(database::SessionId session) {
        say(QStringLiteral("-- sessions beside it"));
        QTRY_VERIFY_WITH_TIMEOUT(m_desktop->context.background().idle(), kPatience_ms);
        const auto* choice = find<QComboBox>("playback.ghost");
        for (int i = 0; i < choice->count(); ++i)
            say(QStringLiteral("%1 %2")
                    .arg(choice->itemData(i).toLongLong() - session)
                    .arg(tests::withoutToday(choice->itemText(i))));
        say(choice->isEnabled() ? QStringLiteral("may be chosen") : QStringLiteral("none to choose"));
    }
    /// A palpation with and without the truth, and by each map.
    void looks(const desktop::PlaybackData& data, desktop::PalpationReplay& replay) {
        for (const auto& [name, look] :
             {std::pair{"without the truth", desktop::PalpationLook{.truth = false}},
              {"the whole trial's map of force",
               desktop::PalpationLook{true, true, simulation::SurfaceMapKind::force}}})
            for (const session::PlaybackTrial& trial : data.track.trials) {
                say(QStringLiteral("-- %1, trial %2").arg(QLatin1String(name)).arg(trial.index));
                scene3d::SceneState state =
                    desktop::sceneStateAt(data.track, nullptr, trial.end_s - 1.0, nullptr);
                replay.showIn(state, data.track, trial.end_s - 1.0, look);
                m_lines << sceneLines(state);
            }
    }

    std::unique_ptr<tests::DesktopFixture> m_desktop;
    std::vector<std::pair<const char*, database::SessionId>> m_sessions;
    QStringList m_lines;
    tests::KeptText m_kept{QStringLiteral(CHIRON_SOURCE_DIR "/tests/gui/review/kept_playback.txt")};
    int m_held = 0;
};

QTEST_MAIN(TestKeptPlayback)
#include "test_kept_playback.moc"
