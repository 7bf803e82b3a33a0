// SPDX-License-Identifier: GPL-3.0-or-later
// palpation_pictures FOLDER [light] [NAME ...]: tissues, fingers, findings and maps, one PNG a state and
// theme, in 3D and flat. palpation_pictures FOLDER figures: the README's sheets. Under Xvfb or on a screen.
#include "app/exercises/palpation/scene/palpation_overlay.h"
#include "desktop/scene3d/scene_loader.h"
#include "gui/scene3d/picture_states.h"
#include "modules/exercises/palpation/cues/palpation_cues.h"

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
using samples::Tissue;
using simulation::FindingOutcome;

namespace {

using samples::palpationPictures;
using samples::Picture;

void pass(int milliseconds) {
    QElapsedTimer timer;
    timer.start();
    while (timer.elapsed() < milliseconds)
        QCoreApplication::processEvents(QEventLoop::AllEvents, 10);
}

QPixmap taken(Picture& picture, bool flat) {
    QWidget window;
    window.resize(1024, 768);
    window.move(0, 0);
    auto* layout = new QVBoxLayout(&window);
    layout->setContentsMargins(0, 0, 0, 0);
    LoadedScene scene =
        flat ? LoadedScene{makeFlatSceneView(picture.setup, QStringLiteral("Shown in 2D."), &window), {}}
             : makeSceneView(picture.setup, &window);
    layout->addWidget(scene.view->widget());
    window.show();
    picture.state.overlay.own<PalpationOverlay>().map = picture.mapShown ? &picture.map : nullptr;
    picture.state.overlay.own<PalpationOverlay>().mapStep = picture.map.step();
    for (int i = 0; i < 2; ++i) {
        scene.view->show(picture.state);
        pass(flat ? 60 : 600);
    }
    return flat ? window.grab() : window.screen()->grabWindow(window.winId());
}

void takeAll(bool flat, const QString& theme, const SceneColours& colours, const QDir& folder,
             const QStringList& wanted) {
    for (Picture& picture : palpationPictures()) {
        if (!wanted.isEmpty() && !wanted.contains(QLatin1String(picture.name)))
            continue;
        picture.setup.colours = colours;
        picture.setup.scale =
            qEnvironmentVariableIsSet("SCENE_SCALE") ? qEnvironmentVariable("SCENE_SCALE").toDouble() : 1.0;
        taken(picture, flat)
            .save(folder.filePath(
                QStringLiteral("%1_%2_%3.png")
                    .arg(QLatin1String(picture.name), QLatin1String(flat ? "flat" : "scene"), theme)));
    }
}

/// States beside and below each other, three a row; "flat" before a name: its flat picture.
void takeFigure(const QDir& folder, const QString& file, const QStringList& names) {
    constexpr QSize kEach(480, 360);
    constexpr int kColumns = 3;
    QImage sheet(kColumns * kEach.width(), int((names.size() + kColumns - 1) / kColumns) * kEach.height(),
                 QImage::Format_RGB32);
    QPainter painter(&sheet);
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    for (Picture& picture : palpationPictures())
        for (const bool flat : {false, true}) {
            const qsizetype at =
                names.indexOf(QLatin1String(flat ? "flat " : "") + QLatin1String(picture.name));
            if (at >= 0)
                painter.drawPixmap(
                    QPoint(int(at) % kColumns * kEach.width(), int(at) / kColumns * kEach.height()),
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
        takeFigure(
            folder, QStringLiteral("palpation_levels.png"),
            {"pad_visible", "pad_hidden", "prostate", "breast_two_hands", "breast_pattern", "pad_pseudo"});
        takeFigure(folder, QStringLiteral("palpation_maps.png"),
                   {"playback_coverage", "playback_force", "flat playback_force"});
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
