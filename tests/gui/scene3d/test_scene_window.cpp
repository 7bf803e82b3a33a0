// SPDX-License-Identifier: GPL-3.0-or-later
// The 3D scene on a real window: needs a display with OpenGL (Xvfb with Mesa will do), else it says so and
// skips.
#include "app/exercises/sphere_apex/scene/apex_mesh.h"
#include "desktop/scene3d/scene_loader.h"
#include "gui/scene3d/scene_at_rest.h"
#include "gui/scene3d/scene_samples.h"
#include "gui/scene3d/shader_dents.h"
#include "modules/exercises/sphere_apex/simulation/sphere_apex_parameters.h"
#include "support/patience.h"

#include <QApplication>
#include <QScreen>
#include <QTest>
#include <QVBoxLayout>
#include <QWheelEvent>
#include <QWidget>
#include <QWindow>
#include <set>
#include <thread>

using chiron::tests::kPatience_ms;

using namespace chiron;
using namespace chiron::scene3d;

namespace {

/// Remembers which events came by.
class Listener final : public QObject {
public:
    std::multiset<QEvent::Type> seen;
    QObject* of = nullptr; ///< only events of this object; nullptr: all

    bool eventFilter(QObject* object, QEvent* event) override {
        if (!of || object == of)
            seen.insert(event->type());
        return false;
    }
};

struct Shown {
    QWidget window;
    LoadedScene scene;
    bool told = false;

    explicit Shown(const SceneSetup& setup = samples::setup()) {
        window.resize(480, 360);
        window.move(0, 0);
        auto* layout = new QVBoxLayout(&window);
        layout->setContentsMargins(0, 0, 0, 0);
        scene = makeSceneView(setup, &window);
        layout->addWidget(scene.view->widget());
        scene.view->onFirstFrame([this] { told = true; });
        window.show();
    }

    /// What is on the screen after this state was drawn.
    QImage picture(const SceneState& state) {
        for (int i = 0; i < 4; ++i) { // a newly shown part arrives over some frames
            const auto before = scene.view->framesDrawn();
            scene.view->show(state);
            if (!QTest::qWaitFor([&] { return scene.view->framesDrawn() > before; }, kPatience_ms))
                return {};
        }
        return window.screen()->grabWindow(window.winId()).toImage().convertToFormat(QImage::Format_RGB32);
    }
};

int reddish(const QImage& image) {
    int count = 0;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) {
            const QColor c = image.pixelColor(x, y);
            count += c.red() > 110 && c.red() > c.green() * 3 / 2 && c.red() > c.blue() * 3 / 2;
        }
    return count;
}

} // namespace

class TestSceneWindow : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        QString why;
        std::thread worker(
            [&] { why = findWhyFlat(); }); // as the screens do, and before anything else loaded the driver
        worker.join();
        if (why.contains(QStringLiteral("OpenGL")))
            QSKIP("no OpenGL 3.2 on this display: the 3D scene is not tested here");
        QCOMPARE(why, QString()); // a missing or foreign plugin is a failure
    }

    void theFirstFrameIsWhole() {
        Shown shown;
        QCOMPARE(shown.scene.whyFlat, QString());
        shown.scene.view->show(samples::inAir());
        QTRY_VERIFY_WITH_TIMEOUT(shown.told, kPatience_ms);
        const QImage image = shown.window.screen()->grabWindow(shown.window.winId()).toImage();
        QVERIFY2(reddish(image) > 480 * 360 / 6,
                 qPrintable(QString::number(reddish(image)))); // tissue, textured
    }

    /// A still picture is whole after one call, whatever it shows for the first time.
    void oneCallIsEnough() {
        Shown shown;
        SceneState state = samples::pressed(2.0);
        state.objectShown = false;
        shown.scene.view->show(state);
        QTRY_VERIFY_WITH_TIMEOUT(shown.told, kPatience_ms);
        SceneState later = samples::pressed(2.0);
        later.tool[1] = later.tool[0];
        later.tool[1].p_WT.x() += 0.01;
        later.ghost = later.tool[0];
        later.marked = true;
        shown.scene.view->show(later);
        QVERIFY(tests::comesToRest(*shown.scene.view));
        const QImage once = shown.window.screen()->grabWindow(shown.window.winId()).toImage();
        QCOMPARE(shown.picture(later), once.convertToFormat(QImage::Format_RGB32));
        QVERIFY(reddish(once) > 480 * 360 / 6);
    }

    /// So is a note, in a playback that stands still at the moment it is about; and when it goes, nothing of
    /// it is left.
    void aNoteIsThereAtOnceAndGoesWhole() {
        Shown shown;
        SceneState state = samples::pressed(2.0);
        shown.scene.view->show(state);
        QTRY_VERIFY_WITH_TIMEOUT(shown.told, kPatience_ms);
        QVERIFY(tests::comesToRest(*shown.scene.view));
        const QImage bare = shown.picture(state);
        for (const SceneNote::Kind kind :
             {SceneNote::Kind::said, SceneNote::Kind::paused, SceneNote::Kind::stopped}) {
            state.note = {kind, QStringLiteral("Here it was"), QStringLiteral("Press Space.")};
            shown.scene.view->show(state);
            QVERIFY(tests::comesToRest(*shown.scene.view));
            const QImage once = shown.window.screen()
                                    ->grabWindow(shown.window.winId())
                                    .toImage()
                                    .convertToFormat(QImage::Format_RGB32);
            QVERIFY2(once != bare, qPrintable(QString::number(int(kind))));
            QCOMPARE(shown.picture(state), once);
            QCOMPARE(reddish(once) > 480 * 360 / 6,
                     kind == SceneNote::Kind::said); // a veil darkens the tissue, a line does not
            state.note = {};
            QCOMPARE(shown.picture(state), bare);
        }
    }

    /// The object comes and goes with the trials: no frame may lack the field.
    void noFrameLacksTheField() {
        Shown shown;
        SceneState state = samples::inAir();
        state.objectShown = false;
        state.tool[0].present = false;
        shown.scene.view->show(state);
        QTRY_VERIFY_WITH_TIMEOUT(shown.told, kPatience_ms);
        QVERIFY(tests::comesToRest(*shown.scene.view));
        state.objectShown = true;
        const auto before = shown.scene.view->framesDrawn();
        shown.scene.view->show(state);
        for (int i = 0; i < 1000 && shown.scene.view->framesDrawn() == before; ++i)
            QCoreApplication::processEvents(); // without waiting: the very next frame is looked at
        QCOMPARE(shown.scene.view->framesDrawn(), before + 1);
        const QImage image = shown.window.screen()->grabWindow(shown.window.winId()).toImage();
        QVERIFY2(reddish(image) > 480 * 360 / 6, qPrintable(QString::number(reddish(image))));
    }

    void nothingIsDrawnBetweenCalls() {
        Shown shown;
        QTRY_VERIFY_WITH_TIMEOUT(shown.told, kPatience_ms);
        QVERIFY(tests::comesToRest(*shown.scene.view));
        const auto before = shown.scene.view->framesDrawn();
        QTest::qWait(300);
        QCOMPARE(shown.scene.view->framesDrawn(), before);
    }

    void cuesChangeThePicture() {
        Shown shown;
        const QImage all = shown.picture(samples::pressed(2.0));
        SceneSetup setup = samples::setup();
        setup.cues.arrow = false;
        shown.scene.view->change(setup);
        const QImage noArrow = shown.picture(samples::pressed(2.0));
        QVERIFY(noArrow != all);
        setup.cues = {false, false};
        shown.scene.view->change(setup);
        const QImage nothing = shown.picture(samples::pressed(2.0));
        QVERIFY(nothing != noArrow);
        SceneState elsewhere = samples::pressed(5.0);
        elsewhere.tool[0].p_WT.x() += 0.02;
        QCOMPARE(shown.picture(elsewhere), nothing); // the hand leaves no trace
    }

    void hiddenObjectLeavesNoTrace() {
        Shown shown;
        SceneState state = samples::pressed(2.0);
        state.objectShown = false;
        const QImage one = shown.picture(state);
        QVERIFY(!one.isNull());
        state.p_WObject = {-0.03, 0.01, 0.0};
        state.dimpleShown = true;
        QCOMPARE(shown.picture(state), one);
        QVERIFY(reddish(one) < 200); // and no tissue at all
        state.objectShown = true;
        QVERIFY(shown.picture(state) != one);
    }

    void theShaderMovesWhatTheTipTouches() {
        SceneState state = samples::inAir();
        const ApexSurface surface = ApexSurface::of(simulation::SphereApexParameters{}, state);
        const TriangleMesh mesh = apexMesh(surface);
        const std::vector<Dent> dents{surface.dentUnder({0.010, 0.004, 0.016}),
                                      surface.dentUnder({-0.03, 0.0, -0.002})};
        QVERIFY(dents[0].depth_m > 0.003 && dents[1].depth_m > 0.001);
        QString error;
        const auto moved = displacedByShader(mesh, dents, error);
        QVERIFY2(moved.size() == mesh.vertices.size(), qPrintable(error));
        int touched = 0;
        for (std::size_t i = 0; i < moved.size(); ++i) {
            const float* p = mesh.vertices[i].position_mm;
            const core::Vec3 rest = core::Vec3(p[0], p[1], p[2]) * 1e-3;
            const core::Vec3 expected =
                rest + (dents[0].displaced(rest) - rest) + (dents[1].displaced(rest) - rest);
            QVERIFY2((moved[i] - expected).norm() < 1e-6,
                     qPrintable(QString::number((moved[i] - expected).norm())));
            touched += (expected - rest).norm() > 1e-4;
        }
        QVERIFY2(touched > 50, qPrintable(QString::number(touched)));
    }

    void mouseAndKeysReachTheCaller() {
        Shown shown;
        QTRY_VERIFY_WITH_TIMEOUT(shown.told, kPatience_ms);
        auto* window = qobject_cast<QWindow*>(shown.scene.view->inputSource());
        QVERIFY(window);
        Listener onSource;
        window->installEventFilter(&onSource);
        Listener onProgram;
        onProgram.of = window;
        qApp->installEventFilter(&onProgram);
        QTest::mouseMove(window, QPoint(100, 100));
        QTest::mouseMove(window, QPoint(140, 120));
        QTest::mouseClick(window, Qt::LeftButton, {}, QPoint(140, 120));
        QWheelEvent wheel({140, 120}, {140, 120}, {}, {0, 120}, Qt::NoButton, Qt::NoModifier,
                          Qt::NoScrollPhase, false);
        QCoreApplication::sendEvent(window, &wheel);
        QTest::keyClick(window, Qt::Key_Escape);
        QTest::keyClick(window, Qt::Key_Tab);
        for (QEvent::Type type : {QEvent::MouseMove, QEvent::MouseButtonPress, QEvent::MouseButtonRelease,
                                  QEvent::Wheel, QEvent::KeyPress, QEvent::KeyRelease}) {
            QVERIFY2(onSource.seen.count(type) > 0, qPrintable(QString::number(type)));
            QVERIFY2(onProgram.seen.count(type) > 0, qPrintable(QString::number(type)));
        }
    }

    void themesScalesAndSizesCanChange() {
        Shown shown;
        SceneSetup setup = samples::setup();
        const QImage light = shown.picture(samples::inAir());
        setup.colours = samples::highContrast();
        shown.scene.view->change(setup);
        QVERIFY(shown.picture(samples::inAir()) != light);
        setup.colours = samples::dark();
        setup.scale = 2.0;
        shown.scene.view->change(setup);
        shown.window.resize(700, 500);
        const QImage larger = shown.picture(samples::inAir());
        QCOMPARE(larger.size(), QSize(700, 500));
        QVERIFY(reddish(larger) > 700 * 500 / 6);
    }

    void survivesHidingAndMovingToAnotherWindow() {
        Shown shown;
        const QImage first = shown.picture(samples::inAir());
        QVERIFY(!first.isNull());
        QWidget* widget = shown.scene.view->widget();
        widget->hide(); // another screen is shown
        shown.scene.view->show(samples::pressed(2.0));
        QTest::qWait(100);
        widget->show();
        QTRY_COMPARE_WITH_TIMEOUT(shown.picture(samples::inAir()), first, kPatience_ms);
        QWidget other;
        other.resize(480, 360);
        other.move(0, 0);
        auto* layout = new QVBoxLayout(&other);
        layout->setContentsMargins(0, 0, 0, 0);
        layout->addWidget(widget);
        shown.window.hide();
        other.show();
        const auto before = shown.scene.view->framesDrawn();
        shown.scene.view->show(samples::pressed(2.0));
        QTRY_VERIFY_WITH_TIMEOUT(shown.scene.view->framesDrawn() > before, kPatience_ms);
        const QImage moved = other.screen()->grabWindow(other.winId()).toImage();
        QVERIFY2(reddish(moved) > 480 * 360 / 6, qPrintable(QString::number(reddish(moved))));
        shown.scene.view.reset();
    }

    void widgetAndViewMayGoInEitherOrder() {
        for (bool viewFirst : {true, false}) {
            auto shown = std::make_unique<Shown>();
            QTRY_VERIFY_WITH_TIMEOUT(shown->told, kPatience_ms);
            if (viewFirst) {
                shown->scene.view.reset();
                QVERIFY(shown->window.findChild<QWidget*>(QStringLiteral("scene.container")) == nullptr);
            } else {
                delete shown->scene.view->widget();
                QVERIFY(!shown->scene.view->widget());
                shown->scene.view->show(samples::inAir());
                shown->scene.view->change(samples::setup());
                QCOMPARE(shown->scene.view->framesDrawn(), std::uint64_t(0));
            }
        }
        QVERIFY(!Shown().scene.view->widget()->isHidden()); // and one that never drew a frame
    }
};

int main(int argc, char** argv) {
    qputenv("CHIRON_PLUGINS", CHIRON_BINARY_DIR "/app/desktop");
    QApplication app(argc, argv);
    TestSceneWindow test;
    return QTest::qExec(&test, argc, argv);
}
#include "test_scene_window.moc"
