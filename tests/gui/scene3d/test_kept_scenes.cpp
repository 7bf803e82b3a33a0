// SPDX-License-Identifier: GPL-3.0-or-later
// Every scene, flat and in three dimensions, as it was looked at (support/kept_pictures.h). On a display with OpenGL those of three
// dimensions, else the flat ones.
#include "desktop/scene3d/scene_loader.h"
#include "gui/scene3d/picture_states.h"
#include "support/kept_pictures.h"

#include <QApplication>
#include <QScreen>
#include <QTest>
#include <QVBoxLayout>
#include <QWidget>

using namespace chiron;
using namespace chiron::scene3d;

namespace {

constexpr double kSame3d = 0.6; // edges that a rasteriser of several threads blends in another order

struct Kept {
    SceneSetup setup;
    SceneState state;
    std::shared_ptr<simulation::SurfaceMap> map;
};

std::map<QString, Kept> all() {
    std::map<QString, Kept> pictures;
    for (const auto& [name, state] : samples::apexStates())
        pictures["apex_" + name] = {samples::setup(), state, {}};
    for (const auto& list : {samples::palpationPictures(), samples::laparoscopyPictures()})
        for (const samples::Picture& each : list)
            pictures[QLatin1String(each.name)] = {each.setup, each.state, each.mapShown ? std::make_shared<simulation::SurfaceMap>(each.map) : nullptr};
    for (const auto& [name, each] : samples::urethraPictures())
        pictures["urethra_" + name] = {each.setup, each.state, {}};
    pictures["apex_dark"] = {samples::setup(), samples::pressed(5.2), {}};
    pictures["apex_dark"].setup.colours = samples::dark();
    pictures["tube_large_contrast"] = {samples::tubeSetup(), samples::tubeState({0.026, -0.016, 0.052}, true), {}};
    pictures["tube_large_contrast"].setup.colours = samples::highContrast();
    pictures["tube_large_contrast"].setup.scale = 1.5;
    return pictures;
}

} // namespace

class TestKeptScenes : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() {
        qputenv("CHIRON_PLUGINS", CHIRON_BINARY_DIR "/app/desktop");
        const QString why = findWhyFlat();
        m_flat = why.contains(QStringLiteral("OpenGL"));
        QVERIFY2(m_flat || why.isEmpty(), qPrintable(why)); // a missing or foreign plugin is a failure
    }
    void isAsItWasLookedAt_data() {
        QTest::addColumn<QString>("name");
        // Drawing in three dimensions takes a software rasteriser long: a state of each part.
        const QStringList scenes{"apex_contact", "apex_playback", "apex_dimple", "apex_z_turned", "pad_visible", "prostate", "breast_two_hands", "playback_force",
                                 "tube_two_handed", "tube_torn", "tube_transfer", "tube_large_contrast", "ovary_organ", "ovary_squeezed",
                                 "urethra_b_up", "urethra_f_neck", "urethra_h_ureters_focus", "urethra_i_seen", "urethra_j_over"};
        for (const QString& name : scenes)
            QVERIFY2(m_all.count(name) == 1, qPrintable(name));
        for (const auto& [name, picture] : m_all)
            if (m_flat || scenes.contains(name))
                QTest::addRow("%s %s", m_flat ? "flat" : "scene", qPrintable(name)) << name;
    }
    void isAsItWasLookedAt() {
        QFETCH(QString, name);
        Kept& picture = m_all.at(name);
        picture.state.surfaceMap = picture.map.get();
        picture.state.surfaceMapStep = picture.map ? picture.map->step() : 0;
        QWidget window;
        window.resize(m_flat ? QSize(720, 540) : QSize(480, 360));
        window.move(0, 0);
        auto* layout = new QVBoxLayout(&window);
        layout->setContentsMargins(0, 0, 0, 0);
        LoadedScene scene = m_flat ? LoadedScene{makeFlatSceneView(picture.setup, QStringLiteral("Drawn in two dimensions."), &window), {}}
                                   : makeSceneView(picture.setup, &window);
        layout->addWidget(scene.view->widget());
        window.show();
        QImage image;
        if (m_flat) {
            scene.view->show(picture.state);
            QCoreApplication::processEvents();
            image = window.grab().toImage();
        } else {
            int same = 0;
            for (int i = 0; i < 40 && same < 3; ++i) { // a newly shown part arrives over some frames, on a busy machine over more
                const auto before = scene.view->framesDrawn();
                scene.view->show(picture.state);
                QVERIFY(QTest::qWaitFor([&] { return scene.view->framesDrawn() > before; }, 20000));
                const QImage next = window.screen()->grabWindow(window.winId()).toImage();
                same = i > 4 && next == image ? same + 1 : 0;
                image = next;
            }
        }
        const QString differs = m_kept.differs((m_flat ? QStringLiteral("flat_") : QStringLiteral("scene_")) + name, image, m_flat ? tests::KeptPictures::kSame : kSame3d);
        QVERIFY2(differs.isEmpty(), qPrintable(differs));
    }

private:
    bool m_flat = true;
    std::map<QString, Kept> m_all = all();
    tests::KeptPictures m_kept{QStringLiteral(CHIRON_SOURCE_DIR "/tests/gui/scene3d/kept_scenes.json")};
};

QTEST_MAIN(TestKeptScenes)
#include "test_kept_scenes.moc"
