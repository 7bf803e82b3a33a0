// SPDX-License-Identifier: GPL-3.0-or-later
// Every scene, flat and in three dimensions, as it was looked at (support/kept_pictures.h). On a display with
// OpenGL those of three dimensions, else the flat ones, these as lines of what is painted, too
// (support/paint_outline.h), as are the faces that both have. CHIRON_STORE_PICTURES=1 CHIRON_STORE_OUTLINES=1
// QT_QPA_PLATFORM=offscreen build/release/tests/gui/scene3d/test_kept_scenes
#include "app/exercises/palpation/scene/finding_flag.h"
#include "app/exercises/palpation/scene/map_legend.h"
#include "app/exercises/palpation/scene/palpation_overlay.h"
#include "app/exercises/urethra_insertion/scene/notice_painter.h"
#include "desktop/scene3d/gauge_painter.h"
#include "desktop/scene3d/scene_loader.h"
#include "desktop/scene3d/scene_note_painter.h"
#include "gui/scene3d/picture_states.h"
#include "support/kept_pictures.h"
#include "support/kept_text.h"
#include "support/paint_outline.h"
#include "support/patience.h"

#include <QApplication>
#include <QScreen>
#include <QTest>
#include <QVBoxLayout>
#include <QWidget>

using chiron::tests::kPatience_ms;

using namespace chiron;
using namespace chiron::scene3d;

namespace {

constexpr double kSame3d = 0.6; // edges that a rasteriser of several threads blends in another order

/// A state of each part of the scenes.
const QStringList kOfEachPart{
    "apex_contact",   "apex_playback",           "apex_dimple",    "apex_z_turned",   "pad_visible",
    "prostate",       "breast_two_hands",        "playback_force", "tube_two_handed", "tube_torn",
    "tube_transfer",  "tube_large_contrast",     "ovary_organ",    "ovary_squeezed",  "urethra_b_up",
    "urethra_f_neck", "urethra_h_ureters_focus", "urethra_i_seen", "urethra_j_over"};

struct Kept {
    SceneSetup setup;
    SceneState state;
    std::shared_ptr<simulation::SurfaceMap> map;
};

std::map<QString, Kept> all() {
    std::map<QString, Kept> pictures;
    for (const auto& [name, state] : samples::apexStates())
        pictures["apex_" + name] = {samples::setup(), state, {}};
    for (const auto& list : {samples::palpationPictures(), samples::laparoscopyPictures()})
        for (const samples::Picture& each : list)
            pictures[QLatin1String(each.name)] = {
                each.setup, each.state,
                each.mapShown ? std::make_shared<simulation::SurfaceMap>(each.map) : nullptr};
    for (const auto& [name, each] : samples::urethraPictures())
        pictures["urethra_" + name] = {each.setup, each.state, {}};
    pictures["comparison_pads"] = {samples::comparisonSetup(simulation::ComparedAttribute::stiffness),
                                   samples::comparisonState(0.0),
                                   {}};
    pictures["comparison_hooked"] = {
        samples::comparisonSetup(simulation::ComparedAttribute::mass), samples::comparisonState(0.030), {}};
    pictures["comparison_one"] = pictures["comparison_pads"]; // of an adjustment: nothing to number
    pictures["comparison_one"].state.exercise.own<core::LaparoscopyCues>().bodies = 1;
    pictures["comparison_none"] = pictures["comparison_pads"]; // between two trials
    pictures["comparison_none"].state.exercise.own<core::LaparoscopyCues>().objectShown = false;
    pictures["apex_dark"] = {samples::setup(), samples::pressed(5.2), {}};
    pictures["apex_dark"].setup.colours = samples::dark();
    pictures["tube_large_contrast"] = {
        samples::tubeSetup(), samples::tubeState({0.026, -0.016, 0.052}, true), {}};
    pictures["tube_large_contrast"].setup.colours = samples::highContrast();
    pictures["tube_large_contrast"].setup.scale = 1.5;
    return pictures;
}

/// What is painted on faces in the scene: bars, legends of maps, flags of findings, the notice, notes.
std::map<QString, std::function<void(QPainter&)>> faces() {
    std::map<QString, std::function<void(QPainter&)>> all;
    const auto add = [&all](const char* name, auto paint) {
        for (const bool dark : {false, true})
            all[QStringLiteral("face_%1%2")
                    .arg(QLatin1String(name), dark ? QStringLiteral(" dark") : QString())] =
                [paint, dark](QPainter& painter) {
                    SceneSetup setup = samples::palpationSetup(samples::Tissue::pad);
                    if (dark) {
                        setup.colours = samples::dark();
                        setup.scale = 1.5;
                    }
                    paint(painter, setup);
                };
    };
    add("force_bar", [](QPainter& painter, const SceneSetup&) {
        GaugePainter(samples::setup(), forceDial(samples::setup())).paint(painter);
    });
    add("bar_with_band", [](QPainter& painter, const SceneSetup& setup) {
        GaugePainter(setup, {QStringLiteral("Tension (N)"), 3.0, 2.5, 1.05, 1.35}).paint(painter);
    });
    for (const auto kind : {simulation::SurfaceMapKind::coverage, simulation::SurfaceMapKind::force})
        add(kind == simulation::SurfaceMapKind::force ? "legend_force" : "legend_coverage",
            [kind](QPainter& painter, const SceneSetup& setup) {
                MapLegend(setup, kind, 37).paint(painter);
            });
    for (const auto& [name, outcome] : {std::pair{"flag_open", simulation::FindingOutcome::open},
                                        {"flag_hit", simulation::FindingOutcome::hit},
                                        {"flag_false_alarm", simulation::FindingOutcome::falseAlarm}})
        add(name, [of = outcome](QPainter& painter, const SceneSetup& setup) {
            paintFindingFlag(painter, QRectF(10, 10, 40, 60), {1, of, false}, setup);
            paintFindingFlag(painter, QRectF(60, 10, 40, 60), {2, of, true}, setup);
        });
    for (const auto& [name, room] : {std::pair{"notice", QSizeF(400, 300)},
                                     {"notice_narrow", QSizeF(90, 120)},
                                     {"notice_without_room", QSizeF(30, 20)}})
        add(name, [room = room](QPainter& painter, const SceneSetup& setup) {
            NoticePainter(setup).paint(painter, QRectF(QPointF(), room), 1.0);
        });
    const SceneNote paused{SceneNote::Kind::paused, QStringLiteral("Paused"),
                           QStringLiteral("Press Space, and the work goes on where it was left.")};
    const SceneNote stopped{SceneNote::Kind::stopped, QStringLiteral("Force is stopped"),
                            QStringLiteral("Press R.")};
    const SceneNote said{SceneNote::Kind::said, QStringLiteral("5.0 mm from the top"), {}};
    for (const auto& [name, note, room] : {std::tuple{"note_paused", paused, QSizeF(560, 420)},
                                           {"note_without_room", paused, QSizeF(300, 120)},
                                           {"note_stopped", stopped, QSizeF(560, 420)},
                                           {"note_said", said, QSizeF(560, 420)},
                                           {"note_said_in_a_low_scene", said, QSizeF(300, 60)}})
        add(name, [of = note, room = room](QPainter& painter, const SceneSetup& setup) {
            SceneNotePainter(setup).paint(painter, QRectF(QPointF(), room), 1.0, of);
        });
    return all;
}

} // namespace

class TestKeptScenes : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() {
        qputenv("CHIRON_PLUGINS", CHIRON_BINARY_DIR "/app/desktop");
        const QString why = findWhyFlat();
        m_flat = why.contains(QStringLiteral("OpenGL"));
        QVERIFY2(m_flat || why.isEmpty(), qPrintable(why)); // a missing or foreign plugin is a failure
    }
    void isAsItWasLookedAt_data() {
        QTest::addColumn<QString>("name");
        // Drawing in three dimensions takes a software rasteriser long.
        for (const QString& name : kOfEachPart)
            QVERIFY2(m_all.count(name) == 1, qPrintable(name));
        for (const auto& [name, picture] : m_all)
            if (m_flat || kOfEachPart.contains(name))
                QTest::addRow("%s %s", m_flat ? "flat" : "scene", qPrintable(name)) << name;
    }
    void isAsItWasLookedAt() {
        QFETCH(QString, name);
        Kept& picture = m_all.at(name);
        picture.state.overlay.own<PalpationOverlay>().map = picture.map.get();
        picture.state.overlay.own<PalpationOverlay>().mapStep = picture.map ? picture.map->step() : 0;
        QWidget window;
        window.resize(m_flat ? QSize(720, 540) : QSize(480, 360));
        window.move(0, 0);
        auto* layout = new QVBoxLayout(&window);
        layout->setContentsMargins(0, 0, 0, 0);
        LoadedScene scene =
            m_flat
                ? LoadedScene{makeFlatSceneView(picture.setup, QStringLiteral("Shown in 2D."), &window), {}}
                : makeSceneView(picture.setup, &window);
        layout->addWidget(scene.view->widget());
        window.show();
        QImage image;
        if (m_flat) {
            scene.view->show(picture.state);
            QCoreApplication::processEvents();
            image = window.grab().toImage();
            const QString outline = m_outlines.differs(name, tests::OutlineDevice::of(window));
            QVERIFY2(outline.isEmpty(), qPrintable(outline));
        } else {
            int same = 0;
            for (int i = 0; i < 40 && same < 3;
                 ++i) { // a newly shown part arrives over some frames, on a busy machine over more
                const auto before = scene.view->framesDrawn();
                scene.view->show(picture.state);
                QVERIFY(QTest::qWaitFor([&] { return scene.view->framesDrawn() > before; }, kPatience_ms));
                const QImage next = window.screen()->grabWindow(window.winId()).toImage();
                same = i > 4 && next == image ? same + 1 : 0;
                image = next;
            }
        }
        const QString differs =
            m_kept.differs((m_flat ? QStringLiteral("flat_") : QStringLiteral("scene_")) + name, image,
                           m_flat ? tests::KeptPictures::kSame : kSame3d);
        QVERIFY2(differs.isEmpty(), qPrintable(differs));
    }

    /// Drawn flat, both views share what room there is: wide, high, small, large and without a reason below
    /// them.
    void roomIsSharedAsItWas_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QSize>("size");
        for (const char* name :
             {"apex_playback", "tube_large_contrast", "breast_two_hands", "urethra_i_seen"})
            for (const QSize& size : {QSize(1000, 320), QSize(340, 760), QSize(210, 160), QSize(1500, 1100)})
                QTest::addRow("%s in %d x %d", name, size.width(), size.height())
                    << QString::fromLatin1(name) << size;
    }
    void roomIsSharedAsItWas() {
        if (!m_flat)
            QSKIP("the flat scene is drawn where there is no OpenGL");
        QFETCH(QString, name);
        QFETCH(QSize, size);
        Kept& picture = m_all.at(name);
        picture.state.overlay.own<PalpationOverlay>().map = picture.map.get();
        const std::unique_ptr<ISceneView> view(makeFlatSceneView(
            picture.setup,
            size.width() > 1200 ? QString() : QStringLiteral("Shown in 2D, for a reason that is long."),
            nullptr));
        QVERIFY(view->widget()->minimumSizeHint().isValid());
        view->widget()->resize(size);
        view->show(picture.state);
        const QString outline = m_outlines.differs(QLatin1String(QTest::currentDataTag()),
                                                   tests::OutlineDevice::of(*view->widget()));
        QVERIFY2(outline.isEmpty(), qPrintable(outline));
    }

    /// At a larger scale and in dark colours.
    void isLargeAsItWas_data() {
        QTest::addColumn<QString>("name");
        for (const QString& name : kOfEachPart + QStringList{"pad_pinch", "tube_fold"})
            QTest::addRow("%s large", qPrintable(name)) << name;
    }
    void isLargeAsItWas() {
        if (!m_flat)
            QSKIP("the flat scene is drawn where there is no OpenGL");
        QFETCH(QString, name);
        Kept picture = m_all.at(name);
        picture.setup.scale = 1.4;
        picture.setup.colours = samples::dark();
        picture.state.overlay.own<PalpationOverlay>().map = picture.map.get();
        picture.state.overlay.own<PalpationOverlay>().mapStep = picture.map ? picture.map->step() : 0;
        const std::unique_ptr<ISceneView> view(makeFlatSceneView(picture.setup, QString(), nullptr));
        view->widget()->resize(900, 600);
        view->show(picture.state);
        const QString outline = m_outlines.differs(QLatin1String(QTest::currentDataTag()),
                                                   tests::OutlineDevice::of(*view->widget()));
        QVERIFY2(outline.isEmpty(), qPrintable(outline));
    }

    void faceIsPaintedAsItWas_data() {
        QTest::addColumn<QString>("name");
        for (const auto& [name, paint] : faces())
            QTest::newRow(qPrintable(name)) << name;
    }
    void faceIsPaintedAsItWas() {
        if (!m_flat)
            QSKIP("the same faces as without OpenGL");
        QFETCH(QString, name);
        tests::OutlineDevice device(QSize(600, 500));
        QPainter painter(&device);
        faces().at(name)(painter);
        painter.end();
        const QString outline = m_outlines.differs(name, device.take());
        QVERIFY2(outline.isEmpty(), qPrintable(outline));
    }
    void nothingElseIsKept() {
        if (m_flat)
            QCOMPARE(m_outlines.unseen(), QStringList());
    }

private:
    bool m_flat = true;
    std::map<QString, Kept> m_all = all();
    tests::KeptPictures m_kept{QStringLiteral(CHIRON_SOURCE_DIR "/tests/gui/scene3d/kept_scenes.json")};
    tests::KeptText m_outlines{QStringLiteral(CHIRON_SOURCE_DIR "/tests/gui/scene3d/kept_flat_scenes.txt"),
                               &tests::KeptText::nearly};
};

QTEST_MAIN(TestKeptScenes)
#include "test_kept_scenes.moc"
