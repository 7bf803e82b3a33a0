// SPDX-License-Identifier: GPL-3.0-or-later
// laparoscopy_pictures FOLDER [light] [NAME ...]: tube and ovaries, one PNG a state and theme, in 3D and flat.
// laparoscopy_pictures FOLDER figures: the README's rows of three. Under Xvfb or on a screen.
#include "desktop/scene3d/scene_loader.h"
#include "gui/scene3d/laparoscopy_samples.h"

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

struct Picture {
    const char* name;
    SceneSetup setup;
    SceneState state;
};

void pass(int milliseconds) {
    QElapsedTimer timer;
    timer.start();
    while (timer.elapsed() < milliseconds)
        QCoreApplication::processEvents(QEventLoop::AllEvents, 10);
}

std::vector<Picture> pictures() {
    SceneState torn = samples::tubeState({0.030, -0.012, 0.078}, true);
    torn.laparoscopy.torn = true;
    torn.laparoscopy.tension_N = 0.0;
    torn.tool[0].force_N.setZero();
    SceneState mark = samples::tubeState({0.020, -0.016, 0.046}, true);
    mark.laparoscopy.targetShown = true;
    SceneState squeezed = samples::handlingState(true);
    squeezed.laparoscopy.squeeze_N[0] = 2.4;
    squeezed.laparoscopy.body[1].squeeze_m = 0.006;
    SceneSetup organ = samples::handlingSetup();
    auto& bed = std::get<chiron::simulation::ObjectHandlingParameters>(organ.parameters);
    bed.organBed = true;
    bed.bedMesh.shape = chiron::simulation::MeshSource::Shape::ellipsoid;
    bed.bedMesh.halfAxisX_m = bed.bedMesh.halfAxisY_m = 0.090;
    bed.bedMesh.halfAxisZ_m = 0.014;
    bed.bedMesh.edge_m = 0.006;
    bed.bedMesh.bumpHeight_m = 0.0004;
    bed.bedMesh.bumpWavelength_m = 0.040;
    SceneState onOrgan = samples::handlingState(false);
    for (int i = 0; i < 3; ++i)
        onOrgan.laparoscopy.body[std::size_t(i)].p_W[2] = 0.007;
    return {{"ovary_organ", organ, onOrgan},
            {"tube_lying", samples::tubeSetup(), samples::tubeState({0.030, -0.022, 0.003}, false)},
            {"tube_slack", samples::tubeSetup(), samples::tubeState({0.016, -0.014, 0.024}, true)},
            {"tube_taut", samples::tubeSetup(), samples::tubeState({0.026, -0.016, 0.052}, true)},
            {"tube_mark", samples::tubeSetup(TubeTask::stretch), mark},
            {"tube_torn", samples::tubeSetup(TubeTask::stretch), torn},
            {"tube_two_handed", samples::tubeSetup(TubeTask::twoHanded), samples::twoHanded(0.064)},
            {"tube_two_slack", samples::tubeSetup(TubeTask::twoHanded), samples::twoHanded(0.034)},
            {"tube_fold", samples::tubeSetup(TubeTask::twoHanded), samples::behindAFold(false)},
            {"tube_fold_back", samples::tubeSetup(TubeTask::twoHanded), samples::behindAFold(true)},
            {"tube_transfer", samples::tubeSetup(TubeTask::transfer), samples::handOver()},
            {"ovary_lying", samples::handlingSetup(), samples::handlingState(false)},
            {"ovary_carried", samples::handlingSetup(), samples::handlingState(true)},
            {"ovary_squeezed", samples::handlingSetup(), squeezed}};
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
    scene.view->show(picture.state);
    pass(flat ? 100 : 900);
    scene.view->show(picture.state);
    pass(flat ? 50 : 300);
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

/// Three states beside each other, without the bars' edges: what the README shows.
void takeFigure(const QDir& folder, const QString& file, const QStringList& names) {
    constexpr QSize kEach(480, 360);
    QImage row(int(names.size()) * kEach.width(), kEach.height(), QImage::Format_RGB32);
    QPainter painter(&row);
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    for (Picture& picture : pictures())
        if (const qsizetype at = names.indexOf(QLatin1String(picture.name)); at >= 0)
            painter.drawPixmap(QPoint(int(at) * kEach.width(), 0), taken(picture, false).scaled(kEach, Qt::IgnoreAspectRatio, Qt::SmoothTransformation));
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
        takeFigure(folder, QStringLiteral("laparoscopy_tube.png"), {"tube_two_slack", "tube_two_handed", "tube_torn"});
        takeFigure(folder, QStringLiteral("laparoscopy_tasks.png"), {"tube_taut", "tube_transfer", "ovary_carried"});
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
