// SPDX-License-Identifier: GPL-3.0-or-later
// urethra_pictures FOLDER [WIDTH HEIGHT [NAME]]: what the endoscope's view looks like, one PNG a state. Under Xvfb or on a
// screen. With NAME only that one.
#include "desktop/scene3d/scene_loader.h"
#include "gui/scene3d/scene_samples.h"
#include "gui/scene3d/urethra_samples.h"

#include <QApplication>
#include <QDir>
#include <QElapsedTimer>
#include <QScreen>
#include <QVBoxLayout>
#include <QWidget>
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

struct Picture {
    SceneSetup setup = samples::urethraSetup();
    SceneState state;
};

Picture picture(const samples::ScopePose& pose, bool depthOfField = false) {
    Picture made;
    made.setup.depthOfField = depthOfField;
    made.state = samples::urethraState(made.setup, pose);
    return made;
}

std::map<QString, Picture> pictures() {
    constexpr double kDegree = chiron::core::kPi / 180.0;
    std::map<QString, Picture> all;
    all["a_entrance"] = picture({.s_m = 0.0005});
    all["a_before"] = picture({.s_m = -0.012});
    all["b_up"] = picture({.s_m = 0.030, .pitch_rad = 14 * kDegree});
    all["c_left"] = picture({.s_m = 0.030, .yaw_rad = 14 * kDegree});
    all["d_middle"] = picture({.s_m = 0.060});
    all["d_middle_focus"] = picture({.s_m = 0.060}, true);
    all["e_offset"] = picture({.s_m = 0.080, .ex_m = 0.002, .en_m = -0.002, .pitch_rad = -0.15});
    all["e_offset"].state.tool[0].force_N = {0.8, -0.6, 1.4};
    all["f_neck"] = picture({.s_m = 0.132});
    all["g_bladder"] = picture({.s_m = 0.152});
    all["g_bladder_focus"] = picture({.s_m = 0.152}, true);
    all["h_ureters"] = picture({.s_m = 0.160, .pitch_rad = -45 * kDegree});
    all["h_ureters_focus"] = picture({.s_m = 0.160, .pitch_rad = -45 * kDegree}, true);
    all["i_seen"] = all["h_ureters"];
    all["i_seen"].state.endoscope.landmarksSeen = 1U << 3;
    all["i_seen"].state.endoscope.dwell = 0.6;
    all["i_seen"].state.endoscope.toLumen_T = {};
    all["j_over"] = all["e_offset"];
    all["j_over"].state.tool[0].force_N = {3.4, -2.6, 2.4};
    all["k_off"] = all["d_middle"];
    all["k_off"].setup.cues.object = false;
    all["l_unguided"] = all["d_middle"];
    all["l_unguided"].setup.cues = {.tool = true, .arrow = false, .object = true};
    all["m_dark"] = all["e_offset"];
    all["m_dark"].setup.colours = samples::dark();
    return all;
}

} // namespace

int main(int argc, char** argv) {
    QApplication app(argc, argv);
    const QDir folder(argc > 1 ? argv[1] : ".");
    QWidget window;
    window.resize(argc > 3 ? atoi(argv[2]) : 1024, argc > 3 ? atoi(argv[3]) : 768);
    window.move(0, 0);
    auto* layout = new QVBoxLayout(&window);
    layout->setContentsMargins(0, 0, 0, 0);
    const bool flat = qEnvironmentVariableIsSet("CHIRON_NO_3D");
    const LoadedScene scene = makeSceneView(samples::urethraSetup(), &window);
    std::printf("%s\n", scene.whyFlat.isEmpty() ? "drawn" : qPrintable(scene.whyFlat));
    layout->addWidget(scene.view->widget());
    window.show();
    pass(900);
    for (const auto& [name, what] : pictures()) {
        if (argc > 4 && !name.contains(QLatin1String(argv[4])))
            continue;
        scene.view->change(what.setup);
        for (int i = 0; i < 3; ++i) {
            scene.view->show(what.state);
            pass(120);
        }
        (flat ? window.grab() : window.screen()->grabWindow(window.winId())).save(folder.filePath((flat ? "flat_urethra_" : "urethra_") + name + ".png"));
    }
    std::printf("%llu frames\n", static_cast<unsigned long long>(scene.view->framesDrawn()));
    return 0;
}
