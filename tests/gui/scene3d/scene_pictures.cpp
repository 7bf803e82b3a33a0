// SPDX-License-Identifier: GPL-3.0-or-later
// scene_pictures FOLDER [WIDTH HEIGHT]: what the scene looks like, one PNG a state and theme. Under Xvfb or
// on a screen.
#include "desktop/scene3d/scene_loader.h"
#include "gui/scene3d/picture_states.h"

#include <QApplication>
#include <QDir>
#include <QElapsedTimer>
#include <QScreen>
#include <QVBoxLayout>
#include <QWidget>
#include <QWindow>
#include <cstdio>
#include <map>

using namespace chiron::scene3d;

namespace {

void pass(int milliseconds) {
    QElapsedTimer timer;
    timer.start();
    while (timer.elapsed() < milliseconds)
        QCoreApplication::processEvents(QEventLoop::AllEvents, 10);
}

} // namespace

int main(int argc, char** argv) {
    QApplication app(argc, argv);
    const QDir folder(argc > 1 ? argv[1] : ".");
    const QSize size(argc > 3 ? atoi(argv[2]) : 1024, argc > 3 ? atoi(argv[3]) : 768);
    const std::map<QString, SceneColours> themes{
        {"light", {}}, {"dark", samples::dark()}, {"contrast", samples::highContrast()}};
    for (bool flat : {false, true})
        for (const auto& [theme, colours] : themes) {
            QWidget window;
            window.resize(size);
            window.move(0, 0);
            auto* layout = new QVBoxLayout(&window);
            layout->setContentsMargins(0, 0, 0, 0);
            LoadedScene scene =
                flat ? LoadedScene{makeFlatSceneView(
                                       samples::setup(),
                                       QStringLiteral("Shown in 2D: OpenGL is not available here."), &window),
                                   {}}
                     : makeSceneView(samples::setup(), &window);
            std::printf("%s\n", scene.whyFlat.isEmpty() ? "drawn" : qPrintable(scene.whyFlat));
            layout->addWidget(scene.view->widget());
            window.show();
            pass(1200);
            SceneSetup setup = samples::setup();
            setup.colours = colours;
            setup.leftHanded = qEnvironmentVariableIsSet("SCENE_LEFT");
            setup.scale = qEnvironmentVariableIsSet("SCENE_SCALE")
                              ? qEnvironmentVariable("SCENE_SCALE").toDouble()
                              : 1.0;
            scene.view->change(setup);
            for (const auto& [name, state] : samples::apexStates()) {
                scene.view->show(state);
                pass(200);
                scene.view->show(state);
                pass(200);
                const QPixmap picture = flat ? window.grab() : window.screen()->grabWindow(window.winId());
                picture.save(folder.filePath((flat ? "flat_" : "scene_") + theme + "_" + name + ".png"));
            }
            std::printf("%llu frames\n", static_cast<unsigned long long>(scene.view->framesDrawn()));
        }
    return 0;
}
