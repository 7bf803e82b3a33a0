// SPDX-License-Identifier: GPL-3.0-or-later
// laparoscopy_pictures FOLDER [light] [NAME ...]: tube and ovaries, one PNG a state and theme, in 3D and
// flat. laparoscopy_pictures FOLDER figures: the README's rows of three. Under Xvfb or on a screen.
#include "desktop/scene3d/scene_loader.h"
#include "gui/scene3d/picture_states.h"
#include "modules/exercises/elastic_tube/simulation/elastic_tube_parameters.h"

#include <QApplication>
#include <QDir>
#include <QElapsedTimer>
#include <QImage>
#include <QPainter>
#include <QScreen>
#include <QVBoxLayout>
#include <QWidget>
#include <cstdio>
#include <vector>

using namespace chiron::scene3d;
using chiron::simulation::TubeTask;

namespace {

using samples::laparoscopyPictures;
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
    scene.view->show(picture.state);
    pass(flat ? 100 : 900);
    scene.view->show(picture.state);
    pass(flat ? 50 : 300);
    return flat ? window.grab() : window.screen()->grabWindow(window.winId());
}

void takeAll(bool flat, const QString& theme, const SceneColours& colours, const QDir& folder,
             const QStringList& wanted) {
    for (Picture& picture : laparoscopyPictures()) {
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

/// Three states beside each other, without the bars' edges: what the README shows.
void takeFigure(const QDir& folder, const QString& file, const QStringList& names) {
    constexpr QSize kEach(480, 360);
    QImage row(int(names.size()) * kEach.width(), kEach.height(), QImage::Format_RGB32);
    QPainter painter(&row);
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    for (Picture& picture : laparoscopyPictures())
        if (const qsizetype at = names.indexOf(QLatin1String(picture.name)); at >= 0)
            painter.drawPixmap(
                QPoint(int(at) * kEach.width(), 0),
                taken(picture, false).scaled(kEach, Qt::IgnoreAspectRatio, Qt::SmoothTransformation));
    painter.end();
    row.save(folder.filePath(file));
}

} // namespace

int main(int argc, char** argv) {
    QApplication app(argc, argv);
    const QStringList arguments = QApplication::arguments();
    const QDir folder(arguments.size() > 1 ? arguments.at(1) : QStringLiteral("."));
    QStringList wanted = arguments.mid(2);
    if (wanted.contains(QStringLiteral("figures"))) {
        takeFigure(folder, QStringLiteral("laparoscopy_tube.png"),
                   {"tube_two_slack", "tube_two_handed", "tube_torn"});
        takeFigure(folder, QStringLiteral("laparoscopy_tasks.png"),
                   {"tube_taut", "tube_transfer", "ovary_carried"});
        return 0;
    }
    const bool lightOnly = wanted.removeAll(QStringLiteral("light")) > 0;
    for (const bool flat : {false, true}) {
        takeAll(flat, "light", {}, folder, wanted);
        if (lightOnly)
            continue;
        takeAll(flat, "dark", samples::dark(), folder, wanted);
        takeAll(flat, "contrast", samples::highContrast(), folder, wanted);
    }
    return 0;
}
