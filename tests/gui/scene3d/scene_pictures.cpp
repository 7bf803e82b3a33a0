// SPDX-License-Identifier: GPL-3.0-or-later
// scene_pictures FOLDER [WIDTH HEIGHT]: what the scene looks like, one PNG a state and theme. Under Xvfb or
// on a screen.
#include "desktop/scene3d/scene_loader.h"
#include "gui/scene3d/scene_samples.h"

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

std::map<QString, SceneState> states() {
    std::map<QString, SceneState> all;
    all["air"] = samples::inAir();
    all["contact"] = samples::pressed(2.0);
    all["over"] = samples::pressed(5.2);
    all["pseudo"] = samples::pressed(3.0);
    all["pseudo"].tool[0].drawnAtSurface = true;
    all["hidden"] = samples::inAir();
    all["hidden"].objectShown = false;
    all["playback"] = samples::pressed(1.2);
    all["playback"].marked = true;
    all["playback"].p_WMark = {0.017, 0.003, 0.019};
    all["playback"].ghost = samples::inAir().tool[0];
    all["playback"].ghost.p_WT = {-0.022, -0.025, 0.012};
    all["playback"].ghost.q_WT = chiron::core::Quat(Eigen::AngleAxisd(-0.25, chiron::core::Vec3::UnitY()));
    all["z_turned"] = samples::inAir();
    all["z_turned"].tool[0].q_WT = chiron::core::Quat(Eigen::AngleAxisd(0.3, chiron::core::Vec3::UnitX()));
    all["z_turned"].tool[0].jaw_rad = 0.6;
    all["z_turned"].tool[1] = all["z_turned"].tool[0];
    all["z_turned"].tool[1].p_WT = {0.05, -0.03, 0.02};
    all["z_turned"].tool[1].q_WT = chiron::core::Quat(Eigen::AngleAxisd(0.3, chiron::core::Vec3(0, 1, 0)));
    all["dimple"] = all["air"];
    all["dimple"].dimpleShown = true;
    all["dimple"].dimpleCentre_m = {0.006, -0.002};
    all["plane"] = samples::inAir();
    all["plane"].tool[0].p_WT = {-0.030, -0.030, -0.006};
    all["plane"].tool[0].p_WProxy = {-0.030, -0.030, 0.0};
    all["plane"].tool[0].force_N = {0.0, 0.0, 3.0};
    all["rim"] = samples::inAir();
    all["rim"].tool[0].p_WT = {0.026, -0.004, 0.003};
    all["rim"].tool[0].force_N = {1.5, -1.2, 0.3};
    return all;
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
                                       QStringLiteral(
                                           "Drawn in two dimensions: OpenGL is not available here."),
                                       &window),
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
            for (const auto& [name, state] : states()) {
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
