// SPDX-License-Identifier: GPL-3.0-or-later
// palpation_pictures FOLDER [light] [NAME ...]: tissues, fingers, findings and maps, one PNG a state and theme, in 3D and flat.
// palpation_pictures FOLDER figures: the README's sheets. Under Xvfb or on a screen.
#include "desktop/scene3d/scene_loader.h"
#include "gui/scene3d/palpation_samples.h"

#include <QApplication>
#include <QDir>
#include <QElapsedTimer>
#include <QImage>
#include <QPainter>
#include <QScreen>
#include <QVBoxLayout>
#include <QWidget>
#include <list>

using namespace chiron;
using namespace chiron::scene3d;
using core::FindingOutcome;
using samples::Tissue;

namespace {

struct Picture {
    const char* name;
    SceneSetup setup;
    SceneState state;
    simulation::SurfaceMap map;
    bool mapShown = false;
};

void pass(int milliseconds) {
    QElapsedTimer timer;
    timer.start();
    while (timer.elapsed() < milliseconds)
        QCoreApplication::processEvents(QEventLoop::AllEvents, 10);
}

Picture visibleLump() {
    Picture picture{"pad_visible", samples::palpationSetup(Tissue::pad), {}, {}, true};
    samples::addLump(picture.state, picture.setup, {0.012, 0.010}, 0.012, 0.0075, false);
    samples::pressFinger(picture.state, picture.setup, 0, {0.004, 0.004}, 0.004, {-0.5, -0.2});
    picture.map = samples::searched(picture.setup, 0.45);
    return picture;
}

Picture pinched() {
    Picture picture{"pad_pinch", samples::palpationSetup(Tissue::pad), {}, {}, false};
    std::get<simulation::PalpationParameters>(picture.setup.parameters).pinch = simulation::PinchParameters{};
    samples::pressFinger(picture.state, picture.setup, 0, {0.004, 0.004}, 0.004);
    picture.state.tool[0].jaw_rad = 0.8;
    return picture;
}

Picture hidden() {
    Picture picture{"pad_hidden", samples::palpationSetup(Tissue::pad), {}, {}, false};
    samples::pressFinger(picture.state, picture.setup, 0, {-0.016, 0.012}, -0.012);
    samples::addFinding(picture.state, picture.setup, 0, {0.018, 0.014}, FindingOutcome::open);
    return picture;
}

Picture prostate() {
    Picture picture{"prostate", samples::palpationSetup(Tissue::prostate), {}, {}, false};
    samples::pressFinger(picture.state, picture.setup, 0, {0.011, -0.002}, 0.0035, {0.7, 1.3});
    samples::addFinding(picture.state, picture.setup, 0, {-0.013, 0.006}, FindingOutcome::open);
    return picture;
}

Picture twoHands() {
    Picture picture{"breast_two_hands", samples::palpationSetup(Tissue::breast, 2), {}, {}, false};
    samples::pressFinger(picture.state, picture.setup, 0, {0.022, -0.004}, 0.005, {0.3, 0.3});
    samples::pressFinger(picture.state, picture.setup, 1, {-0.020, 0.006}, 0.004, {-0.3, 0.1});
    picture.state.activeTool = 0;
    samples::addFinding(picture.state, picture.setup, 0, {-0.008, 0.026}, FindingOutcome::open);
    return picture;
}

Picture pattern() {
    Picture picture{"breast_pattern", samples::palpationSetup(Tissue::breast, 1, 2), {}, {}, true};
    samples::pressFinger(picture.state, picture.setup, 0, {0.004, -0.006}, 0.005, {0.2, 0.2});
    samples::pressFinger(picture.state, picture.setup, 1, {-0.014, -0.006}, 0.005, {0.1, 0.2});
    picture.map = samples::searched(picture.setup, 0.6);
    return picture;
}

Picture playback(core::SurfaceMapKind kind) {
    Picture picture{kind == core::SurfaceMapKind::force ? "playback_force" : "playback_coverage", samples::palpationSetup(Tissue::breast, 2), {}, {}, true};
    picture.state.mapKind = kind;
    samples::addLump(picture.state, picture.setup, {-0.020, 0.016}, 0.012, 0.0075, false);
    samples::addLump(picture.state, picture.setup, {0.022, -0.014}, 0.010, 0.005, true);
    samples::addFinding(picture.state, picture.setup, 0, {-0.017, 0.019}, FindingOutcome::hit);
    samples::addFinding(picture.state, picture.setup, 1, {0.014, 0.024}, FindingOutcome::falseAlarm);
    picture.map = samples::searched(picture.setup, 0.8);
    return picture;
}

Picture shown() {
    Picture picture{"pad_pseudo", samples::palpationSetup(Tissue::pad), {}, {}, false};
    samples::pressFinger(picture.state, picture.setup, 0, {0.0, 0.0}, 0.009);
    picture.state.tool[0].drawnAtSurface = true;
    picture.state.ghost = picture.state.tool[0];
    picture.state.ghost.p_WProxy = picture.state.ghost.p_WT = {0.022, 0.012, 0.004};
    return picture;
}

std::list<Picture> pictures() {
    return {visibleLump(), pinched(), hidden(), prostate(), twoHands(), pattern(), playback(core::SurfaceMapKind::coverage), playback(core::SurfaceMapKind::force), shown()};
}

QPixmap taken(Picture& picture, bool flat) {
    QWidget window;
    window.resize(1024, 768);
    window.move(0, 0);
    auto* layout = new QVBoxLayout(&window);
    layout->setContentsMargins(0, 0, 0, 0);
    LoadedScene scene = flat ? LoadedScene{makeFlatSceneView(picture.setup, QStringLiteral("Drawn in two dimensions."), &window), {}}
                             : makeSceneView(picture.setup, &window);
    layout->addWidget(scene.view->widget());
    window.show();
    picture.state.surfaceMap = picture.mapShown ? &picture.map : nullptr;
    picture.state.surfaceMapStep = picture.map.step();
    for (int i = 0; i < 2; ++i) {
        scene.view->show(picture.state);
        pass(flat ? 60 : 600);
    }
    return flat ? window.grab() : window.screen()->grabWindow(window.winId());
}

void takeAll(bool flat, const QString& theme, const SceneColours& colours, const QDir& folder, const QStringList& wanted) {
    for (Picture& picture : pictures()) {
        if (!wanted.isEmpty() && !wanted.contains(QLatin1String(picture.name)))
            continue;
        picture.setup.colours = colours;
        picture.setup.scale = qEnvironmentVariableIsSet("SCENE_SCALE") ? qEnvironmentVariable("SCENE_SCALE").toDouble() : 1.0;
        taken(picture, flat).save(
            folder.filePath(QStringLiteral("%1_%2_%3.png").arg(QLatin1String(picture.name), QLatin1String(flat ? "flat" : "scene"), theme)));
    }
}

/// States beside and below each other, three a row; "flat" before a name: its flat picture.
void takeFigure(const QDir& folder, const QString& file, const QStringList& names) {
    constexpr QSize kEach(480, 360);
    constexpr int kColumns = 3;
    QImage sheet(kColumns * kEach.width(), int((names.size() + kColumns - 1) / kColumns) * kEach.height(), QImage::Format_RGB32);
    QPainter painter(&sheet);
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    for (Picture& picture : pictures())
        for (const bool flat : {false, true}) {
            const qsizetype at = names.indexOf(QLatin1String(flat ? "flat " : "") + QLatin1String(picture.name));
            if (at >= 0)
                painter.drawPixmap(QPoint(int(at) % kColumns * kEach.width(), int(at) / kColumns * kEach.height()),
                                   taken(picture, flat).scaled(kEach, Qt::IgnoreAspectRatio, Qt::SmoothTransformation));
        }
    painter.end();
    sheet.save(folder.filePath(file));
}

} // namespace

int main(int argc, char** argv) {
    QApplication app(argc, argv);
    const QStringList arguments = QApplication::arguments();
    const QDir folder(arguments.size() > 1 ? arguments.at(1) : QStringLiteral("."));
    QStringList wanted = arguments.mid(2);
    if (wanted.contains(QStringLiteral("figures"))) {
        takeFigure(folder, QStringLiteral("palpation_levels.png"),
                   {"pad_visible", "pad_hidden", "prostate", "breast_two_hands", "breast_pattern", "pad_pseudo"});
        takeFigure(folder, QStringLiteral("palpation_maps.png"), {"playback_coverage", "playback_force", "flat playback_force"});
        return 0;
    }
    const bool lightOnly = wanted.removeAll(QStringLiteral("light")) > 0;
    const bool sceneOnly = wanted.removeAll(QStringLiteral("scene")) > 0;
    const bool flatOnly = wanted.removeAll(QStringLiteral("flat")) > 0;
    for (const bool flat : {false, true}) {
        if ((flat && sceneOnly) || (!flat && flatOnly))
            continue;
        takeAll(flat, "light", {}, folder, wanted);
        if (lightOnly)
            continue;
        takeAll(flat, "dark", samples::dark(), folder, wanted);
        takeAll(flat, "contrast", samples::highContrast(), folder, wanted);
    }
    return 0;
}
