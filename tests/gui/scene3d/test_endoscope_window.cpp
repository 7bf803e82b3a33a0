// SPDX-License-Identifier: GPL-3.0-or-later
// The endoscope's view on a real window: needs a display with OpenGL (Xvfb with Mesa will do), else it says
// so and skips.
#include "desktop/scene3d/scene_loader.h"
#include "gui/scene3d/scene_at_rest.h"
#include "gui/scene3d/scene_samples.h"
#include "gui/scene3d/urethra_samples.h"
#include "modules/exercises/sphere_apex/simulation/sphere_apex_parameters.h"
#include "modules/exercises/urethra_insertion/cues/endoscope_cues.h"
#include "support/patience.h"

#include <QApplication>
#include <QScreen>
#include <QTest>
#include <QVBoxLayout>
#include <QWidget>
#include <cmath>
#include <cstdlib>

using chiron::tests::kPatience_ms;

using namespace chiron;
using namespace chiron::scene3d;

namespace {

constexpr int kSide = 420;

/// Only the round picture, filling a square window.
SceneSetup plain() {
    SceneSetup setup = samples::urethraSetup();
    setup.cues = {.tool = true, .arrow = false, .object = true, .overview = false, .guidance = false};
    return setup;
}

struct Shown {
    QWidget window;
    LoadedScene scene;

    explicit Shown(const SceneSetup& setup) {
        window.resize(kSide, kSide);
        window.move(0, 0);
        auto* layout = new QVBoxLayout(&window);
        layout->setContentsMargins(0, 0, 0, 0);
        scene = makeSceneView(setup, &window);
        layout->addWidget(scene.view->widget());
        window.show();
    }

    QImage picture(const SceneState& state) {
        for (int i = 0; i < 5; ++i) { // a newly shown part arrives over some frames
            const auto before = scene.view->framesDrawn();
            scene.view->show(state);
            if (!QTest::qWaitFor([&] { return scene.view->framesDrawn() > before; }, kPatience_ms))
                return {};
        }
        return window.screen()->grabWindow(window.winId()).toImage().convertToFormat(QImage::Format_RGB32);
    }
    QImage picture(const SceneSetup& setup, const SceneState& state) {
        scene.view->change(setup);
        return picture(state);
    }
};

/// Distance from the picture's middle, 0..1 at its rim.
double radiusOf(int x, int y) {
    return std::hypot(x + 0.5 - kSide / 2.0, y + 0.5 - kSide / 2.0) / (kSide / 2.0);
}

/// Mean difference of two pictures in a ring, grey levels.
double difference(const QImage& a, const QImage& b, double from, double to) {
    double sum = 0.0;
    int count = 0;
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x) {
            const double r = radiusOf(x, y);
            if (r < from || r > to)
                continue;
            const QColor p = a.pixelColor(x, y);
            const QColor q = b.pixelColor(x, y);
            sum += (std::abs(p.red() - q.red()) + std::abs(p.green() - q.green()) +
                    std::abs(p.blue() - q.blue())) /
                   3.0;
            ++count;
        }
    return sum / std::max(1, count);
}

double brightness(const QImage& image, double from, double to) {
    QImage black(image.size(), QImage::Format_RGB32);
    black.fill(Qt::black);
    return difference(image, black, from, to);
}

int whitePixels(const QImage& image) {
    int count = 0;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            count += image.pixelColor(x, y).lightness() > 250;
    return count;
}

} // namespace

class TestEndoscopeWindow : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        const QString why = findWhyFlat();
        if (why.contains(QStringLiteral("OpenGL")))
            QSKIP("no OpenGL 3.2 on this display: the endoscope's view is not tested here");
        QCOMPARE(why, QString());
    }

    void thePictureIsRound() {
        Shown shown(plain());
        for (bool lens : {false, true}) {
            SceneSetup setup = plain();
            setup.depthOfField = lens;
            const QImage image = shown.picture(setup, samples::urethraState(setup, {.s_m = 0.060}));
            QVERIFY2(brightness(image, 1.005, 2.0) < 0.5,
                     qPrintable(QString::number(brightness(image, 1.005, 2.0))));
            QVERIFY(brightness(image, 0.60, 0.90) > 80.0);
            QVERIFY(brightness(image, 0.0, 0.08) < 0.4 * brightness(image, 0.60, 0.90)); // the lumen is dark
            const QColor wall = image.pixelColor(kSide / 2 + int(0.35 * kSide), kSide / 2);
            QVERIFY(wall.red() > wall.green() + 15 && wall.red() > wall.blue() + 15);
        }
    }

    /// In the middle of the canal the wall at the focus distance is seen at r/(d·tan(φ/2)) = 0.3 of the
    /// picture's radius, that at the rim from 5 mm: far out of focus.
    void depthOfFieldBlursWhatIsOutOfFocusOnly() {
        Shown shown(plain());
        SceneSetup lens = plain();
        lens.depthOfField = true;
        const SceneState state = samples::urethraState(plain(), {.s_m = 0.110});
        const QImage off = shown.picture(plain(), state);
        const QImage on = shown.picture(lens, state);
        const double atFocus = difference(off, on, 0.285, 0.310);
        const double atRim = difference(off, on, 0.75, 0.95);
        QVERIFY2(atRim > 1.5 && atRim > 3.0 * atFocus,
                 qPrintable(QString("rim %1, focus %2").arg(atRim).arg(atFocus)));
        QCOMPARE(shown.picture(plain(), state), off); // and it can be switched off again
    }

    /// A pause darkens the picture, and the bar and the overview beside it; going on leaves nothing of it.
    void aPauseVeilsThePicture() {
        Shown shown(samples::urethraSetup());
        SceneState state = samples::urethraState(samples::urethraSetup(), {.s_m = 0.060});
        const QImage alive = shown.picture(state);
        state.note = {SceneNote::Kind::paused, QStringLiteral("Paused"), QStringLiteral("Press Space.")};
        const QImage veiled = shown.picture(state);
        QVERIFY(brightness(alive, 0.6, 0.9) > 20.0);
        QVERIFY2(brightness(veiled, 0.6, 2.0) < 0.6 * brightness(alive, 0.6, 2.0),
                 qPrintable(QStringLiteral("%1 of %2")
                                .arg(brightness(veiled, 0.6, 2.0))
                                .arg(brightness(alive, 0.6, 2.0))));
        QVERIFY(whitePixels(veiled) > whitePixels(alive) + 500); // the sign and the words
        state.note = {};
        QCOMPARE(shown.picture(state), alive);
    }

    void theWallOpensAheadOfTheTip() {
        Shown shown(plain());
        const QImage inside = shown.picture(plain(), samples::urethraState(plain(), {.s_m = 0.060}));
        const QImage farther = shown.picture(plain(), samples::urethraState(plain(), {.s_m = 0.070}));
        QVERIFY(difference(inside, farther, 0.0, 0.95) > 2.0);
        const QImage turned =
            shown.picture(plain(), samples::urethraState(plain(), {.s_m = 0.060, .pitch_rad = 0.25}));
        QVERIFY(difference(inside, turned, 0.0, 0.95) > 2.0);
    }

    void hiddenCuesAreHidden() {
        Shown shown(plain());
        SceneState one = samples::urethraState(plain(), {.s_m = 0.160, .pitch_rad = -0.7});
        SceneState other = one;
        other.exercise.own<simulation::EndoscopeCues>().landmarksSeen = 31;
        other.exercise.own<simulation::EndoscopeCues>().dwell = 0.7;
        other.exercise.own<simulation::EndoscopeCues>().toLumen_T = {0.2, 0.2, -0.95};
        other.tool[0].force_N = {1.0, 2.0, -1.0};
        const QImage nothing = shown.picture(plain(), one);
        QCOMPARE(shown.picture(plain(), other), nothing);
        SceneSetup guided = plain();
        guided.cues.guidance = true;
        one.exercise.own<simulation::EndoscopeCues>().guided =
            other.exercise.own<simulation::EndoscopeCues>().guided = true;
        const QImage marked = shown.picture(guided, one);
        QVERIFY(marked != nothing);
        QVERIFY(shown.picture(guided, other) != marked);
        SceneSetup arrow = plain();
        arrow.cues.arrow = true;
        QVERIFY(shown.picture(arrow, other) != shown.picture(arrow, one));
    }

    void aPictureThatIsOffTellsNothing() {
        Shown shown(plain());
        SceneSetup off = plain();
        off.cues.object = false;
        const QImage one = shown.picture(off, samples::urethraState(plain(), {.s_m = 0.060}));
        const QImage other =
            shown.picture(off, samples::urethraState(plain(), {.s_m = 0.150, .yaw_rad = 0.3}));
        QCOMPARE(one, other);
        QVERIFY(brightness(one, 0.3, 1.0) < 8.0);
        QVERIFY(brightness(one, 0.0, 0.7) > 0.2); // the sentence
    }

    void theOverviewShowsTheShaft() {
        SceneSetup setup = plain();
        setup.cues.overview = true;
        Shown shown(setup);
        shown.window.resize(700, 420);
        const QImage outside = shown.picture(samples::urethraState(setup, {.s_m = 0.010}));
        const QRect place(420, 0, 280, 420);
        const QImage in = shown.picture(samples::urethraState(setup, {.s_m = 0.120}));
        QCOMPARE(in.size(), QSize(700, 420));
        QVERIFY(outside.copy(place) != in.copy(place));
        SceneSetup dark = setup;
        dark.colours = samples::dark();
        QVERIFY(shown.picture(dark, samples::urethraState(setup, {.s_m = 0.120})).copy(place) !=
                in.copy(place));
        setup.cues.overview = false;
        const QImage alone = shown.picture(setup, samples::urethraState(setup, {.s_m = 0.120}));
        QVERIFY(brightness(alone.copy(690, 0, 10, 10).scaled(kSide, kSide), 0.0, 1.0) < 1.0);
    }

    void nothingIsDrawnBetweenCalls() {
        Shown shown(plain());
        QVERIFY(!shown.picture(samples::urethraState(plain(), {.s_m = 0.050})).isNull());
        QVERIFY(tests::comesToRest(*shown.scene.view));
        const auto before = shown.scene.view->framesDrawn();
        QTest::qWait(300);
        QCOMPARE(shown.scene.view->framesDrawn(), before);
    }

    void foreignParametersAreDrawnFlat() {
        SceneSetup setup = plain();
        setup.parameters = simulation::SphereApexParameters{};
        QWidget parent;
        const LoadedScene scene = makeSceneView(setup, &parent);
        QVERIFY(scene.view && !scene.whyFlat.isEmpty());
    }
};

int main(int argc, char** argv) {
    qputenv("CHIRON_PLUGINS", CHIRON_BINARY_DIR "/app/desktop");
    QApplication app(argc, argv);
    TestEndoscopeWindow test;
    return QTest::qExec(&test, argc, argv);
}
#include "test_endoscope_window.moc"
