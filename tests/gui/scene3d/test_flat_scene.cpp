// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/scene2d/flat_panel.h"
#include "desktop/scene3d/scene_loader.h"
#include "desktop/scene3d/scene_plugin.h"
#include "gui/scene3d/picture_states.h"
#include "gui/scene3d/scene_samples.h"
#include "support/paint_outline.h"
#include "support/painted_shapes.h"
#include "support/patience.h"

#include <QApplication>
#include <QDir>
#include <QFile>
#include <QFontMetricsF>
#include <QImage>
#include <QPointer>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>
#include <QWidget>

using chiron::tests::kPatience_ms;

using namespace chiron;
using namespace chiron::scene3d;

namespace {

QImage picture(const SceneSetup& setup, const SceneState& state, const QString& why = {}) {
    const auto view = makeFlatSceneView(setup, why, nullptr);
    view->widget()->resize(900, 600);
    view->show(state);
    return view->widget()->grab().toImage();
}

SceneState hidden(double x_m, double y_m) {
    SceneState state = samples::pressed(2.0);
    state.objectShown = false;
    state.p_WObject = {x_m, y_m, 0.0};
    state.dimpleCentre_m = {y_m, x_m};
    state.dimpleShown = x_m > 0.0;
    return state;
}

} // namespace

/// The scene where there is no OpenGL, and the words that say so.
class TestFlatScene : public QObject {
    Q_OBJECT

private slots:
    /// The module that the program links must not bring Qt3D along: it would delay every start.
    void initTestCase() {
        QFile maps(QStringLiteral("/proc/self/maps"));
        if (!maps.open(QIODevice::ReadOnly))
            QSKIP("no /proc here");
        const QByteArray loaded = maps.readAll();
        QVERIFY(loaded.contains("libQt6Widgets")); // the list can be read
        QVERIFY(!loaded.contains("libQt63D"));
    }

    void cleanup() { qunsetenv("CHIRON_NO_3D"); }

    void offscreenGetsTheFlatSceneWithTheReason() {
        const LoadedScene scene = makeSceneView(samples::setup(), nullptr);
        QVERIFY(scene.view);
        QVERIFY(scene.view->widget());
        QCOMPARE(scene.whyFlat, QStringLiteral("Shown in 2D: OpenGL is not available here."));
        QCOMPARE(findWhyFlat(), scene.whyFlat);
        QCOMPARE(scene.view->widget()->accessibleDescription(), scene.whyFlat);
    }

    /// A title is read whole in a card that is too narrow for it, and is as large as ever where there is
    /// room.
    void titleOfANarrowCardIsReadWhole() {
        SceneSetup setup = samples::setup();
        setup.scale = 2.0;
        const QString title = QStringLiteral("From the side, with the ring");
        QImage paper(100, 100, QImage::Format_RGB32);
        for (const double pixelsPerMm : {0.2, 0.5, 1.0, 20.0}) {
            FlatPanel panel(FlatPanel::Side::profile, QRectF(0.0, 0.0, 60.0, 40.0), setup);
            panel.place({0.0, 0.0}, pixelsPerMm);
            const double room = panel.cardSize(pixelsPerMm).width() - 24.0 * setup.scale;
            const QFont font = panel.titleFont(title, &paper);
            QVERIFY2(QFontMetricsF(font, &paper).horizontalAdvance(title) <= room,
                     qPrintable(QString::number(pixelsPerMm)));
            QCOMPARE(font.pixelSize() == panel.font(14, true).pixelSize(), pixelsPerMm == 20.0);
        }
    }

    /// However low the scene is, and however large its texts.
    void theTitlesAreWithinALowScene() {
        SceneSetup setup = samples::setup();
        setup.scale = 2.0;
        const auto view = makeFlatSceneView(setup, QStringLiteral("Shown in 2D."), nullptr);
        view->show(samples::inAir());
        for (const QSize size : {QSize(1216, 90), QSize(1216, 150), QSize(1216, 300), QSize(640, 480)}) {
            view->widget()->resize(size);
            int titles = 0;
            for (const QString& line : tests::OutlineDevice::of(*view->widget())) {
                const auto words =
                    QRegularExpression(QStringLiteral("words \"From [a-z ]+\" (-?[0-9.]+),(-?[0-9.]+)"))
                        .match(line);
                if (!words.hasMatch())
                    continue;
                ++titles;
                const double x = words.captured(1).toDouble(), y = words.captured(2).toDouble();
                QVERIFY2(x >= 0.0 && x < size.width() && y >= 8.0 && y <= size.height(), qPrintable(line));
            }
            QCOMPARE(titles, 2);
        }
    }

    void switchedOffSaysSo() {
        qputenv("CHIRON_NO_3D", "1");
        const LoadedScene scene = makeSceneView(samples::setup(), nullptr);
        QVERIFY(scene.view);
        QVERIFY2(scene.whyFlat.contains("switched off"), qPrintable(scene.whyFlat));
    }

    void anUnknownExerciseHasAWidgetAllTheSame() {
        SceneSetup setup = samples::setup();
        setup.exercise = "no_such_exercise";
        QVERIFY(!picture(setup, samples::inAir()).isNull());
    }

    void theReasonIsDrawn() {
        const QImage silent = picture(samples::setup(), samples::inAir());
        const QImage spoken =
            picture(samples::setup(), samples::inAir(), QStringLiteral("Because of this and that."));
        const QRect bottom(0, silent.height() - 40, silent.width(), 40);
        QVERIFY(silent.copy(bottom) != spoken.copy(bottom));
    }

    void missingPluginIsRefusedWithWords() {
        const QTemporaryDir folder;
        const ScenePlugin plugin = loadScenePlugin(folder.path());
        QVERIFY(!plugin.make);
        QVERIFY2(plugin.why.contains("not installed"), qPrintable(plugin.why));
    }

    void damagedPluginIsRefusedWithWords() {
        const QTemporaryDir folder;
        QFile file(QDir(folder.path()).filePath(QLatin1String(kScenePluginFile)));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("not a library");
        file.close();
        const ScenePlugin plugin = loadScenePlugin(folder.path());
        QVERIFY(!plugin.make);
        QVERIFY2(plugin.why.contains("could not be loaded"), qPrintable(plugin.why));
    }

    void pluginOfAnotherBuildIsRefusedWithWords() {
        const ScenePlugin plugin = loadScenePlugin(QStringLiteral(CHIRON_OTHER_PLUGINS));
        QVERIFY(!plugin.make);
        QVERIFY2(plugin.why.contains("another version"), qPrintable(plugin.why));
    }

    void ownPluginIsAccepted() {
        const ScenePlugin plugin = loadScenePlugin(QStringLiteral(CHIRON_BINARY_DIR "/app/desktop"));
        QVERIFY2(plugin.make, qPrintable(plugin.why));
        QCOMPARE(plugin.why, QString());
    }

    void everyCueIsVisibleAndOnlyWhenAllowed() {
        SceneSetup all = samples::setup();
        const SceneState state = samples::pressed(2.0);
        const QImage whole = picture(all, state);
        for (int cue = 0; cue < 2; ++cue) {
            SceneSetup less = all;
            (cue == 0 ? less.cues.tool : less.cues.arrow) = false;
            QVERIFY(picture(less, state) != whole);
        }
        SceneSetup none = all;
        none.cues = {false, false};
        SceneState noObject = state;
        noObject.objectShown = false;
        QVERIFY(picture(none, state) != picture(none, noObject));
        // With nothing allowed the hand leaves no trace, wherever it is and however hard it presses.
        SceneState elsewhere = samples::pressed(5.5);
        elsewhere.tool[0].p_WT.x() += 0.02;
        QCOMPARE(picture(none, state), picture(none, elsewhere));
    }

    void hiddenObjectLeavesNoTrace() {
        const QImage one = picture(samples::setup(), hidden(0.0, 0.0));
        QCOMPARE(picture(samples::setup(), hidden(0.03, -0.02)), one);
        QCOMPARE(picture(samples::setup(), hidden(-0.04, 0.0)), one);
        SceneState shown = hidden(0.03, -0.02);
        shown.objectShown = true;
        QVERIFY(picture(samples::setup(), shown) != one); // the comparison can fail
    }

    void overTheLimitDiffersInShape() {
        // The same picture in one colour for both: what remains is shape.
        SceneSetup setup = samples::setup();
        setup.colours.over = setup.colours.arrow;
        setup.forceLimit_N = 2.0;
        SceneState under = samples::pressed(1.999);
        SceneState over = under;
        over.tool[0].force_N *= 1.001;
        // Not where the shapes lie, which the larger force changes, but of what form they are.
        const auto forms = [&](const SceneState& state) {
            const auto view = makeFlatSceneView(setup, {}, nullptr);
            view->widget()->resize(900, 600);
            view->show(state);
            QStringList found;
            for (const tests::PaintedShape& shape : tests::PaintedShapes::of(*view->widget()))
                if (shape.bounds.right() < 800.0) // without the bar, which is striped over the limit
                    found << QStringLiteral("%1 of %2 corners, pen %3 %4, brush %5")
                                 .arg(static_cast<int>(shape.kind))
                                 .arg(shape.corners.size())
                                 .arg(static_cast<int>(shape.pen.style()))
                                 .arg(shape.pen.widthF())
                                 .arg(static_cast<int>(shape.brush.style()));
            return found;
        };
        const QStringList below = forms(under);
        QVERIFY(below.size() > 10);
        QVERIFY(forms(over) != below);
        QCOMPARE(forms(under), below); // or the comparison would say nothing
    }

    void ghostAndMarkAreDrawn() {
        SceneState state = samples::inAir();
        const QImage plain = picture(samples::setup(), state);
        state.ghost = state.tool[0];
        state.ghost.p_WT.x() += 0.03;
        const QImage ghost = picture(samples::setup(), state);
        QVERIFY(ghost != plain);
        state.marked = true;
        state.p_WMark = {0.01, 0.01, 0.019};
        QVERIFY(picture(samples::setup(), state) != ghost);
    }

    /// In every exercise, at each place and nowhere else.
    void tissueThatGaveWayIsCrossed() {
        std::list<samples::Picture> pictures = samples::laparoscopyPictures();
        pictures.splice(pictures.end(), samples::palpationPictures());
        std::map<std::string, samples::Picture> shown; // one of each exercise
        for (const samples::Picture& each : pictures)
            shown.emplace(each.setup.exercise, each);
        const samples::UrethraPicture canal = samples::urethraPictures().at(QStringLiteral("d_middle"));
        shown.emplace(canal.setup.exercise, samples::Picture{"canal", canal.setup, canal.state, {}, false});
        shown.emplace("sphere_apex",
                      samples::Picture{"sphere", samples::setup(), samples::pressed(2.0), {}, false});
        QCOMPARE(shown.size(), std::size_t{5});
        for (const auto& [exercise, each] : shown) {
            const QImage whole = picture(each.setup, each.state);
            QCOMPARE(picture(each.setup, each.state), whole);
            SceneState state = each.state;
            state.p_WYielded = {state.tool[0].p_WT};
            const QImage once = picture(each.setup, state);
            QVERIFY2(once != whole, exercise.c_str());
            state.p_WYielded.push_back(state.tool[0].p_WT + core::Vec3(0.0, 0.006, 0.004));
            QVERIFY2(picture(each.setup, state) != once, exercise.c_str());
        }
    }

    void theFirstFrameIsToldOnce() {
        const auto view = makeFlatSceneView(samples::setup(), {}, nullptr);
        int told = 0;
        view->onFirstFrame([&] { ++told; });
        view->widget()->show();
        QTRY_COMPARE_WITH_TIMEOUT(told, 1, kPatience_ms);
        QVERIFY(view->framesDrawn() >= 1);
        view->show(samples::inAir());
        QTRY_VERIFY_WITH_TIMEOUT(view->framesDrawn() >= 2, kPatience_ms);
        QCOMPARE(told, 1);
        QTest::qWait(20); // until it rests
        const auto frames = view->framesDrawn();
        SceneSetup dark = samples::setup();
        dark.colours = samples::dark();
        view->change(dark); // is seen without another state
        QTRY_VERIFY_WITH_TIMEOUT(view->framesDrawn() > frames, kPatience_ms);
        view->onFirstFrame([&] { ++told; }); // afterwards it comes from the event loop
        QTRY_COMPARE_WITH_TIMEOUT(told, 2, kPatience_ms);
    }

    void widgetAndViewMayGoInEitherOrder() {
        auto parent = std::make_unique<QWidget>();
        auto view = makeFlatSceneView(samples::setup(), {}, parent.get());
        parent.reset();
        QVERIFY(!view->widget());
        view->show(samples::inAir());
        view->change(samples::setup());
        QCOMPARE(view->framesDrawn(), std::uint64_t(0));
        view.reset();

        QWidget other;
        view = makeFlatSceneView(samples::setup(), {}, &other);
        QPointer<QWidget> widget = view->widget();
        view.reset();
        QVERIFY(!widget);
    }

    void allSizesAndScalesArePainted() {
        for (const QSize& size : {QSize(320, 240), QSize(500, 900), QSize(1600, 400)}) {
            for (double scale : {1.0, 2.0}) {
                SceneSetup setup = samples::setup();
                setup.scale = scale;
                const auto view = makeFlatSceneView(setup, QStringLiteral("Why."), nullptr);
                view->widget()->resize(size);
                view->show(samples::pressed(2.0));
                QVERIFY(!view->widget()->grab().isNull());
            }
        }
    }
};

QTEST_MAIN(TestFlatScene)
#include "test_flat_scene.moc"
