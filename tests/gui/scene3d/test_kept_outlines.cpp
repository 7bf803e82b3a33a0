// SPDX-License-Identifier: GPL-3.0-or-later
// What every scene of three dimensions is made of (support/scene_outline.h), against what was kept: in the
// states of a session, from one to the next, in every theme. It needs no display: the plugin's own nodes are
// read, nothing is drawn. A change that is meant is kept anew, and the difference is read in review (and the
// scene looked at: scene_pictures and its siblings): CHIRON_STORE_OUTLINES=1 QT_QPA_PLATFORM=offscreen
// build/release/tests/gui/scene3d/test_kept_outlines
#include "app/exercises/palpation/scene/palpation_overlay.h"
#include "cues/laparoscopy_cues.h"
#include "desktop/scene3d/scene_loader.h"
#include "desktop/scene3d/scene_plugin.h"
#include "gui/scene3d/picture_states.h"
#include "modules/exercises/object_handling/simulation/object_handling_parameters.h"
#include "modules/exercises/palpation/cues/palpation_cues.h"
#include "modules/exercises/sphere_apex/simulation/sphere_apex_parameters.h"
#include "modules/exercises/urethra_insertion/cues/endoscope_cues.h"
#include "support/kept_text.h"
#include "support/scene_outline.h"

#include <QApplication>
#include <QLocale>
#include <QResizeEvent>
#include <QTest>
#include <QWidget>
#include <QWindow>

#include <algorithm>

using namespace chiron;
using namespace chiron::scene3d;

namespace {

constexpr QSize kWide(960, 600), kHigh(420, 640);

/// One state after another of one scene; where there is a setup, it is changed before.
struct Step {
    QString name;
    SceneState state;
    std::optional<SceneSetup> setup = {};
    QSize size = kWide;
    std::shared_ptr<const simulation::SurfaceMap> map = {};
};

struct Scene {
    SceneSetup setup;
    std::vector<Step> steps;
};

SceneSetup coloured(SceneSetup setup, const SceneColours& colours, double scale = 1.0) {
    setup.colours = colours;
    setup.scale = scale;
    return setup;
}

/// With the level's cues away, for a person who works with the left hand.
SceneSetup unaided(SceneSetup setup) {
    setup.cues = {.tool = true, .arrow = false, .object = true, .overview = false, .guidance = false};
    setup.leftHanded = true;
    return setup;
}

SceneSetup withoutTools(SceneSetup setup) {
    setup.cues = {.tool = false, .arrow = true, .object = true, .overview = true, .guidance = true};
    setup.forceLimit_N = 2.0;
    return setup;
}

/// Every theme, other cues and another window, between two states.
void addLooks(Scene& scene) {
    const Step busy = scene.steps.back();
    const Step other = scene.steps.size() > 1 ? scene.steps[scene.steps.size() - 2] : busy;
    const auto add = [&](const char* name, const Step& of, const SceneSetup& setup, const QSize& size) {
        scene.steps.push_back({QLatin1String(name), of.state, setup, size, of.map});
    };
    add("dark", other, coloured(scene.setup, samples::dark()), kWide);
    add("contrast, larger", busy, coloured(scene.setup, samples::highContrast(), 1.5), kWide);
    add("a high window", other, coloured(scene.setup, samples::highContrast(), 1.5), kHigh);
    add("unaided", busy, unaided(scene.setup), kHigh);
    add("tools not drawn", busy, withoutTools(scene.setup), kWide);
}

Scene apex(simulation::ApexSurface surface) {
    Scene scene{samples::setup(), {}};
    auto& p = scene.setup.parameters.as<simulation::SphereApexParameters>();
    p.surface = surface;
    p.bumpHeight_m = surface == simulation::ApexSurface::exact ? 0.0 : 0.0006;
    const auto states = samples::apexStates();
    QStringList names{QStringLiteral("contact"), QStringLiteral("over"), QStringLiteral("hidden"),
                      QStringLiteral("pseudo")};
    if (surface == simulation::ApexSurface::exact)
        names << QStringLiteral("air") << QStringLiteral("dimple") << QStringLiteral("plane")
              << QStringLiteral("rim") << QStringLiteral("playback") << QStringLiteral("z_turned");
    for (const QString& name : names)
        scene.steps.push_back({name, states.at(name)});
    if (surface != simulation::ApexSurface::exact) {
        SceneState turned = samples::pressed(1.0);
        turned.exercise.own<core::LaparoscopyCues>().body[0].q_W = {std::cos(0.4), 0.0, 0.0, std::sin(0.4)};
        scene.steps.push_back({QStringLiteral("turned"), turned});
    }
    addLooks(scene);
    for (const auto& [name, kind] : {std::pair{"tissue gave way, paused", SceneNote::Kind::paused},
                                     {"stopped", SceneNote::Kind::stopped},
                                     {"something is said", SceneNote::Kind::said}}) {
        SceneState told = samples::pressed(1.0);
        told.p_WYielded = {{0.010, -0.020, 0.030}};
        told.note = {kind, QStringLiteral("Here it was"), QStringLiteral("Press Space.")};
        scene.steps.push_back({QLatin1String(name), told, scene.setup});
    }
    scene.steps.push_back({QStringLiteral("nothing more is said"), samples::pressed(1.0)});
    return scene;
}

void addPictures(std::map<QString, Scene>& scenes, const QString& name,
                 const std::list<samples::Picture>& pictures, const QStringList& states) {
    Scene scene;
    for (const QString& state : states)
        for (const samples::Picture& each : pictures)
            if (state == QLatin1String(each.name)) {
                if (scene.steps.empty())
                    scene.setup = each.setup;
                scene.steps.push_back(
                    {state,
                     each.state,
                     {},
                     kWide,
                     each.mapShown ? std::make_shared<simulation::SurfaceMap>(each.map) : nullptr});
            }
    if (scene.steps.size() != std::size_t(states.size()))
        qFatal("a state of %s is missing", qPrintable(name));
    addLooks(scene);
    scenes[name] = scene;
}

void addTubes(std::map<QString, Scene>& scenes) {
    const auto pictures = samples::laparoscopyPictures();
    addPictures(scenes, QStringLiteral("tube_hold"), pictures,
                {QStringLiteral("tube_lying"), QStringLiteral("tube_slack"), QStringLiteral("tube_taut")});
    addPictures(scenes, QStringLiteral("tube_mark"), pictures,
                {QStringLiteral("tube_mark"), QStringLiteral("tube_torn"), QStringLiteral("tube_mark")});
    addPictures(scenes, QStringLiteral("tube_two_handed"), pictures,
                {QStringLiteral("tube_two_handed"), QStringLiteral("tube_two_slack"),
                 QStringLiteral("tube_fold"), QStringLiteral("tube_fold_back")});
    addPictures(scenes, QStringLiteral("tube_transfer"), pictures, {QStringLiteral("tube_transfer")});
    Scene& fold = scenes[QStringLiteral("tube_two_handed")];
    SceneState pulled = samples::behindAFold(true); // beyond what the fold bears
    pulled.exercise.own<core::LaparoscopyCues>().retraction_N = 1.6;
    pulled.tool[2].p_WT = {0.004, 0.038, 0.030};
    pulled.exercise.own<core::LaparoscopyCues>().p_WFoldEdge = {0.004, 0.038, 0.030};
    fold.steps.push_back({QStringLiteral("fold pulled too hard"), pulled, fold.setup});
    Scene& transfer = scenes[QStringLiteral("tube_transfer")];
    SceneState there = samples::handOver(); // the left one alone has it, in the target
    there.exercise.own<core::LaparoscopyCues>().gripHeldBy = {0, 0, 2};
    there.exercise.own<core::LaparoscopyCues>().p_WGrip[1] = {-0.020, 0.002, 0.033};
    there.exercise.own<core::LaparoscopyCues>().p_WGrip[2] = {-0.034, 0.001, 0.044};
    there.exercise.own<core::LaparoscopyCues>().dwell = 0.7;
    there.tool[1] = samples::grasper({-0.034, 0.001, 0.044}, true, 0.1);
    there.tool[0] = samples::grasper({0.040, 0.0, 0.050}, false, 0.6);
    transfer.steps.push_back({QStringLiteral("in the target"), there, transfer.setup});
}

void addObjects(std::map<QString, Scene>& scenes) {
    const auto pictures = samples::laparoscopyPictures();
    addPictures(
        scenes, QStringLiteral("ovary"), pictures,
        {QStringLiteral("ovary_lying"), QStringLiteral("ovary_carried"), QStringLiteral("ovary_squeezed")});
    addPictures(scenes, QStringLiteral("ovary_organ"), pictures, {QStringLiteral("ovary_organ")});
    Scene& bed = scenes[QStringLiteral("ovary_organ")];
    const auto narrow = [](SceneSetup& setup) {
        setup.parameters.as<simulation::ObjectHandlingParameters>().bedMesh.halfAxisY_m = 0.070;
    }; // x and y are told apart
    narrow(bed.setup);
    for (Step& step : bed.steps)
        if (step.setup)
            narrow(*step.setup);
    SceneState pressed = bed.steps.front().state; // the second tool presses, and one body is taken
    pressed.tool[1] = samples::grasper({-0.012, -0.010, 0.001}, true, 0.2);
    pressed.exercise.own<core::LaparoscopyCues>().body[0].heldBy = 2;
    pressed.exercise.own<core::LaparoscopyCues>().body[0].p_W = {-0.012, -0.010, 0.012};
    pressed.exercise.own<core::LaparoscopyCues>().body[0].squeeze_m = 0.004;
    pressed.exercise.own<core::LaparoscopyCues>().bodies = 2;
    pressed.exercise.own<core::LaparoscopyCues>().targetRadius_m = 0.018;
    pressed.exercise.own<core::LaparoscopyCues>().dwell = 0.6;
    pressed.exercise.own<core::LaparoscopyCues>().squeeze_N = {0.4, 1.7, 0.0, 0.0};
    bed.steps.push_back({QStringLiteral("pressed"), pressed, bed.setup});
    bed.steps.push_back({QStringLiteral("let go"), bed.steps.front().state});
    SceneState none = pressed;
    none.exercise.own<core::LaparoscopyCues>().objectShown = false;
    bed.steps.push_back({QStringLiteral("nothing shown"), none});
    Scene& table = scenes[QStringLiteral("ovary")];
    SceneState second = samples::handlingState(true); // by the left one, another dish
    second.exercise.own<core::LaparoscopyCues>().body[1].heldBy = 2;
    second.tool[1] = second.tool[0];
    second.tool[1].q_WT = DrawnOrientation::throughEntry(second.tool[1].p_WT, true);
    second.tool[0] = samples::grasper({0.05, -0.03, 0.04}, false, 0.9);
    second.exercise.own<core::LaparoscopyCues>().targetRadius_m = 0.020;
    second.exercise.own<core::LaparoscopyCues>().p_WTarget = {-0.012, -0.030, 0.0};
    second.activeTool = 1;
    table.steps.push_back({QStringLiteral("by the left one"), second, table.setup});
}

void addPalpation(std::map<QString, Scene>& scenes) {
    const auto pictures = samples::palpationPictures();
    const auto names = [](std::initializer_list<const char*> all) {
        QStringList list;
        for (const char* name : all)
            list << QLatin1String(name);
        return list;
    };
    addPictures(scenes, QStringLiteral("pad"), pictures, names({"pad_hidden", "pad_visible", "pad_pseudo"}));
    addPictures(scenes, QStringLiteral("pad_pinch"), pictures, names({"pad_pinch"}));
    addPictures(scenes, QStringLiteral("prostate"), pictures, names({"prostate"}));
    addPictures(scenes, QStringLiteral("breast_two_hands"), pictures,
                names({"breast_two_hands", "playback_coverage", "playback_force"}));
    addPictures(scenes, QStringLiteral("breast_pattern"), pictures, names({"breast_pattern"}));
    Scene& pad = scenes[QStringLiteral("pad")];
    SceneState many; // six lumps, all fingers away, flags of each outcome
    for (int i = 0; i < 6; ++i)
        samples::addLump(many, pad.setup, {0.010 * (i - 2.5), 0.004 * i}, 0.010, 0.004 + 0.0005 * i,
                         i % 2 == 1);
    const simulation::FindingOutcome outcomes[] = {simulation::FindingOutcome::open,
                                                   simulation::FindingOutcome::hit,
                                                   simulation::FindingOutcome::falseAlarm};
    for (std::size_t i = 0; i < 8; ++i)
        samples::addFinding(many, pad.setup, i, {0.009 * (double(i) - 3.5), -0.012}, outcomes[i % 3]);
    many.exercise.own<simulation::PalpationCues>().selected = 2;
    pad.steps.push_back({QStringLiteral("all found"), many, pad.setup});
    SceneState leaning; // more than the device can lean
    samples::pressFinger(leaning, pad.setup, 0, {-0.010, -0.008}, 0.003, {-1.4, 0.6});
    pad.steps.push_back({QStringLiteral("leaning"), leaning});
}

Scene urethra(const QStringList& states, bool stricture = false) {
    Scene scene{stricture ? samples::shippedCanal() : samples::urethraPictures().at(states.front()).setup,
                {}};
    if (stricture) {
        auto& parameters = scene.setup.parameters.as<simulation::UrethraInsertionParameters>();
        parameters.anatomy.changes[0].centre_m = 0.085;
        parameters.anatomy.changeCount = 1;
        parameters.landmarks.push_back({"lesion", 1.0, 0.4});
        parameters.landmarks.push_back({"diverticulum", 0.7, 2.2});
    }
    const auto pictures = samples::urethraPictures();
    for (const QString& name : states) {
        const samples::UrethraPicture& picture = pictures.at(name);
        const bool same = stricture || (picture.setup.depthOfField == scene.setup.depthOfField &&
                                        picture.setup.cues.object == scene.setup.cues.object &&
                                        picture.setup.cues.arrow == scene.setup.cues.arrow);
        scene.steps.push_back({name, picture.state, same ? std::nullopt : std::optional(picture.setup)});
    }
    if (!stricture)
        addLooks(scene);
    return scene;
}

std::map<QString, Scene> all() {
    std::map<QString, Scene> scenes;
    scenes[QStringLiteral("apex")] = apex(simulation::ApexSurface::exact);
    scenes[QStringLiteral("apex_mesh")] = apex(simulation::ApexSurface::mesh);
    scenes[QStringLiteral("apex_organ")] = apex(simulation::ApexSurface::organ);
    addTubes(scenes);
    addObjects(scenes);
    addPalpation(scenes);
    QStringList states;
    for (const auto& [name, picture] : samples::urethraPictures())
        if (name != QLatin1String("m_dark"))
            states << name;
    Scene& canal = scenes[QStringLiteral("urethra")] = urethra(states);
    SceneState compared = canal.steps[5].state; // played back beside a second session
    compared.ghost =
        samples::urethraState(canal.setup, {.s_m = 0.040, .ex_m = 0.001, .roll_rad = 0.7}).tool[0];
    compared.exercise.own<simulation::EndoscopeCues>().landmarksSeen = 0b10110;
    canal.steps.push_back({QStringLiteral("compared"), compared, canal.setup});
    scenes[QStringLiteral("urethra_stricture")] =
        urethra({QStringLiteral("d_middle"), QStringLiteral("e_offset")}, true);
    return scenes;
}

} // namespace

class TestKeptOutlines : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() {
        QLocale::setDefault(QLocale::c());
        m_plugin = loadScenePlugin(QStringLiteral(CHIRON_BINARY_DIR "/app/desktop"));
        QVERIFY2(m_plugin.make, qPrintable(m_plugin.why));
    }
    void isMadeAsItWas_data() {
        QTest::addColumn<QString>("name");
        for (const auto& [name, scene] : m_all)
            QTest::newRow(qPrintable(name)) << name;
    }
    void isMadeAsItWas() {
        QFETCH(QString, name);
        const Scene& scene = m_all.at(name);
        const std::unique_ptr<ISceneView> view(m_plugin.make(&scene.setup, nullptr));
        QVERIFY(view);
        auto* window = qobject_cast<QWindow*>(view->inputSource());
        QVERIFY(window);
        const auto* root =
            qobject_cast<const Qt3DCore::QEntity*>(window->property(kSceneRootProperty).value<QObject*>());
        QVERIFY2(root, "the window does not say what it draws");
        tests::SceneOutline outline;
        QStringList now{QStringLiteral("-- as it is made")};
        resize(*window, kWide);
        now << outline.of(*root);
        for (const Step& step : scene.steps) {
            resize(*window, step.size);
            if (step.setup)
                view->change(*step.setup);
            SceneState state = step.state;
            state.overlay.own<PalpationOverlay>().map = step.map.get();
            state.overlay.own<PalpationOverlay>().mapStep = step.map ? step.map->step() : 0;
            view->show(state);
            now << QStringLiteral("-- ") + step.name << outline.of(*root);
        }
        const QString differs = m_kept.differs(name, now);
        QVERIFY2(differs.isEmpty(), qPrintable(differs));
    }
    /// In every scene, where tissue gave way in playback; what is no longer shown is gone.
    void tissueThatGaveWayIsMarked_data() { isMadeAsItWas_data(); }
    void tissueThatGaveWayIsMarked() {
        QFETCH(QString, name);
        const Scene& scene = m_all.at(name);
        const std::unique_ptr<ISceneView> view(m_plugin.make(&scene.setup, nullptr));
        auto* window = qobject_cast<QWindow*>(view->inputSource());
        const auto* root =
            qobject_cast<const Qt3DCore::QEntity*>(window->property(kSceneRootProperty).value<QObject*>());
        SceneState state = scene.steps.front().state;
        const auto stars = [root] {
            QList<const Qt3DCore::QEntity*> all;
            if (const auto* yields = root->findChild<Qt3DCore::QEntity*>(QStringLiteral("scene.yields")))
                for (const auto* star :
                     yields->findChildren<Qt3DCore::QEntity*>(QString(), Qt::FindDirectChildrenOnly))
                    if (star->isEnabled())
                        all << star;
            return all;
        };
        const auto placeOf = [](const Qt3DCore::QEntity* star) {
            return star->componentsOfType<Qt3DCore::QTransform>().first()->translation();
        };
        view->show(state);
        QVERIFY(stars().isEmpty());
        state.p_WYielded = {{0.010, -0.020, 0.030}, {0.001, 0.002, 0.003}};
        view->show(state);
        QCOMPARE(stars().size(), 2);
        QCOMPARE(placeOf(stars()[0]), QVector3D(10.0F, -20.0F, 30.0F));
        QCOMPARE(placeOf(stars()[1]), QVector3D(1.0F, 2.0F, 3.0F));
        state.p_WYielded.resize(1);
        view->show(state);
        QCOMPARE(stars().size(), 1);
        state.p_WYielded.clear();
        view->show(state);
        QVERIFY(stars().isEmpty());
    }
    /// Of one map, what was searched and how hard, by turns: the kind that is asked for is painted, not the
    /// one that was painted before.
    void aMapIsOfTheKindThatIsAskedFor() {
        const Scene& scene = m_all.at(QStringLiteral("breast_two_hands"));
        const auto step = std::find_if(scene.steps.begin(), scene.steps.end(), [](const Step& each) {
            return each.name == QLatin1String("playback_coverage");
        });
        QVERIFY(step != scene.steps.end() && step->map);
        const std::unique_ptr<ISceneView> view(m_plugin.make(&scene.setup, nullptr));
        auto* window = qobject_cast<QWindow*>(view->inputSource());
        const auto* root =
            qobject_cast<const Qt3DCore::QEntity*>(window->property(kSceneRootProperty).value<QObject*>());
        resize(*window, kWide);
        const auto drawn = [&](simulation::SurfaceMapKind kind) {
            SceneState state = step->state;
            auto& overlay = state.overlay.own<PalpationOverlay>();
            overlay.map = step->map.get();
            overlay.mapStep = step->map->step();
            overlay.mapKind = kind;
            view->show(state);
            return tests::SceneOutline().of(*root);
        };
        const QStringList coverage = drawn(simulation::SurfaceMapKind::coverage),
                          force = drawn(simulation::SurfaceMapKind::force);
        QVERIFY(force != coverage);
        QCOMPARE(drawn(simulation::SurfaceMapKind::coverage), coverage);
        QCOMPARE(drawn(simulation::SurfaceMapKind::force), force);
    }
    /// What nobody asks for again is no longer kept.
    void keepsNothingOfNoScene() {
        for (const QString& name : m_kept.unseen())
            QVERIFY2(m_all.count(name) == 1, qPrintable(name));
    }

private:
    static void resize(QWindow& window, const QSize& size) {
        const QSize before = window.size();
        window.resize(size);
        QResizeEvent event(size, before); // no display sends it
        QCoreApplication::sendEvent(&window, &event);
    }

    ScenePlugin m_plugin;
    std::map<QString, Scene> m_all = all();
    tests::KeptText m_kept{QStringLiteral(CHIRON_SOURCE_DIR "/tests/gui/scene3d/kept_outlines.txt")};
};

QTEST_MAIN(TestKeptOutlines)
#include "test_kept_outlines.moc"
