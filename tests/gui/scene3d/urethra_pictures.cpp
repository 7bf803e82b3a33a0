// SPDX-License-Identifier: GPL-3.0-or-later
// urethra_pictures FOLDER [WIDTH HEIGHT [NAME]]: what the endoscope's view looks like, one PNG a state. Under
// Xvfb or on a screen. With NAME only those whose names contain it. urethra_pictures FOLDER figures: those of
// the exercise's README, like P1's figures 4 and 5.
#include "desktop/scene3d/scene_loader.h"
#include "gui/scene3d/picture_states.h"

#include <QApplication>
#include <QDir>
#include <QElapsedTimer>
#include <QPainter>
#include <QScreen>
#include <QVBoxLayout>
#include <QWidget>
#include <cstdio>
#include <map>
#include <vector>

using namespace chiron::scene3d;

namespace {

using samples::shippedCanal;
using samples::urethraPictures;
using Picture = samples::UrethraPicture;

void pass(int milliseconds) {
    QElapsedTimer timer;
    timer.start();
    while (timer.elapsed() < milliseconds)
        QCoreApplication::processEvents(QEventLoop::AllEvents, 10);
}

/// The scene in a window of this size, and what it shows of a picture.
class Camera {
public:
    Camera(const SceneSetup& setup, const QSize& size) {
        m_window.resize(size);
        m_window.move(0, 0);
        auto* layout = new QVBoxLayout(&m_window);
        layout->setContentsMargins(0, 0, 0, 0);
        m_scene = makeSceneView(setup, &m_window);
        layout->addWidget(m_scene.view->widget());
        m_window.show();
        pass(900);
    }
    QImage take(const Picture& what) {
        m_scene.view->change(what.setup);
        for (int i = 0; i < 3; ++i) {
            m_scene.view->show(what.state);
            pass(120);
        }
        const bool flat = !m_scene.whyFlat.isEmpty();
        return (flat ? m_window.grab() : m_window.screen()->grabWindow(m_window.winId())).toImage();
    }
    bool flat() const { return !m_scene.whyFlat.isEmpty(); }
    std::uint64_t frames() const { return m_scene.view->framesDrawn(); }

private:
    QWidget m_window;
    LoadedScene m_scene;
};

/// Small enough for a page: 256 colours.
void save(const QImage& image, const QString& file) {
    image.convertToFormat(QImage::Format_Indexed8, Qt::DiffuseDither).save(file);
}

SceneSetup alone(SceneSetup setup) {
    setup.cues = {.tool = true, .arrow = false, .object = true};
    return setup;
}

/// Pictures beside each other.
QImage row(const std::vector<QImage>& images) {
    QImage all(int(images.size()) * images[0].width(), images[0].height(), QImage::Format_RGB32);
    QPainter painter(&all);
    for (std::size_t i = 0; i < images.size(); ++i)
        painter.drawImage(QPoint(int(i) * images[0].width(), 0), images[i]);
    return all;
}

/// The overview alone, with P1's coarse mesh of figure 4, at several places of the tip.
QImage deformation() {
    Picture what = samples::urethraPicture({});
    auto& p = what.setup.parameters.as<chiron::simulation::UrethraInsertionParameters>();
    p.mesh.n = 9;
    p.mesh.w = 13;
    what.setup.cues = {.tool = true, .arrow = false, .object = true, .overview = true};
    Camera camera(what.setup, QSize(1200, 600));
    std::vector<QImage> images;
    for (double s : {-0.012, 0.030, 0.070, 0.115}) {
        what.state = samples::urethraState(what.setup, {.s_m = s});
        const QImage window = camera.take(what);
        images.push_back(
            window.copy(window.width() - 576, 0, 576, 600).scaledToHeight(330, Qt::SmoothTransformation));
    }
    return row(images);
}

void figures(const QDir& folder) {
    const std::map<QString, Picture> all = urethraPictures();
    {
        Camera camera(alone(shippedCanal()), QSize(340, 340));
        const auto taken = [&](const char* name) {
            Picture what = all.at(name);
            what.setup.cues = alone(what.setup).cues;
            return camera.take(what);
        };
        save(row({taken("a_entrance"), taken("b_up"), taken("c_left")}),
             folder.filePath("urethra_states.png"));
        save(row({taken("d_middle"), taken("d_middle_focus")}), folder.filePath("urethra_focus.png"));
    }
    save(deformation(), folder.filePath("urethra_deformation.png"));
    Camera camera(shippedCanal(), QSize(860, 480));
    save(row({camera.take(all.at("j_over"))}), folder.filePath("urethra_force.png"));
    save(row({camera.take(all.at("i_seen"))}), folder.filePath("urethra_bladder.png"));
}

} // namespace

int main(int argc, char** argv) {
    QApplication app(argc, argv);
    const QDir folder(argc > 1 ? argv[1] : ".");
    if (argc == 3 && QLatin1String(argv[2]) == QLatin1String("figures")) {
        figures(folder);
        return 0;
    }
    Camera camera(shippedCanal(), QSize(argc > 3 ? atoi(argv[2]) : 1024, argc > 3 ? atoi(argv[3]) : 768));
    for (const auto& [name, what] : urethraPictures()) {
        if (argc > 4 && !name.contains(QLatin1String(argv[4])))
            continue;
        camera.take(what).save(
            folder.filePath((camera.flat() ? "flat_urethra_" : "urethra_") + name + ".png"));
    }
    std::printf("%llu frames\n", static_cast<unsigned long long>(camera.frames()));
    return 0;
}
