// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/scene3d/scene_loader.h"

#include "desktop/scene2d/flat_scene_view.h"
#include "desktop/scene3d/scene_plugin.h"

#include <QCoreApplication>
#include <QDir>
#include <QGuiApplication>
#include <QLibrary>
#include <QOpenGLContext>
#include <QSurfaceFormat>
#include <atomic>

namespace chiron::scene3d {

namespace {

QString words(const char* text) {
    return QCoreApplication::translate("chiron::scene3d::SceneLoader", text);
}

/// A positive result is cached, because an available driver remains available; after a negative one the check
/// is repeated.
bool hasOpenGl() {
    static std::atomic<bool> found = false;
    if (found)
        return true;
    QSurfaceFormat format;
    format.setVersion(3, 2);
    format.setProfile(QSurfaceFormat::CoreProfile);
    QOpenGLContext context;
    context.setFormat(format);
    found = context.create() && !context.isOpenGLES() && context.format().version() >= qMakePair(3, 2);
    return found;
}

ScenePlugin findPlugin() {
    if (qEnvironmentVariableIsSet("CHIRON_NO_3D"))
        return {nullptr, words(QT_TRANSLATE_NOOP("chiron::scene3d::SceneLoader",
                                                 "Shown in 2D: 3D is switched off on this station."))};
    const QString platform = QGuiApplication::platformName();
    if (platform == QLatin1String("offscreen") || platform == QLatin1String("minimal") || !hasOpenGl())
        return {nullptr, words(QT_TRANSLATE_NOOP("chiron::scene3d::SceneLoader",
                                                 "Shown in 2D: OpenGL is not available here."))};
    const QString named = qEnvironmentVariable("CHIRON_PLUGINS");
    return loadScenePlugin(named.isEmpty() ? QCoreApplication::applicationDirPath() : named);
}

} // namespace

ScenePlugin loadScenePlugin(const QString& folder) {
    const QString file = QDir(folder).filePath(QLatin1String(kScenePluginFile));
    if (!QFile::exists(file))
        return {nullptr, words(QT_TRANSLATE_NOOP("chiron::scene3d::SceneLoader",
                                                 "Shown in 2D: the 3D part of Chiron is not installed."))};
    QLibrary library(file);
    library.setLoadHints(QLibrary::PreventUnloadHint); // Qt3D cannot be unloaded safely
    if (!library.load())
        return {nullptr,
                words(QT_TRANSLATE_NOOP("chiron::scene3d::SceneLoader",
                                        "Shown in 2D: the 3D part of Chiron could not be loaded (%1)."))
                    .arg(library.errorString())};
    const auto abi = reinterpret_cast<SceneAbiFunction>(library.resolve(kSceneAbiSymbol));
    const auto make = reinterpret_cast<SceneMakeFunction>(library.resolve(kSceneMakeSymbol));
    if (!abi || !make || sceneAbi() != abi())
        return {nullptr, words(QT_TRANSLATE_NOOP("chiron::scene3d::SceneLoader",
                                                 "Shown in 2D: the 3D part belongs to another version of "
                                                 "Chiron. Reinstall Chiron to fix this."))};
    return {make, {}};
}

QString findWhyFlat() {
    return findPlugin().why;
}

LoadedScene makeSceneView(const SceneSetup& setup, QWidget* parent) {
    ScenePlugin plugin = findPlugin();
    if (plugin.make) {
        if (std::unique_ptr<ISceneView> view{plugin.make(&setup, parent)})
            return {std::move(view), {}};
        plugin.why = words(
            QT_TRANSLATE_NOOP("chiron::scene3d::SceneLoader", "Shown in 2D: this exercise has no 3D scene."));
    }
    return {makeFlatSceneView(setup, plugin.why, parent), plugin.why};
}

std::unique_ptr<ISceneView> makeFlatSceneView(const SceneSetup& setup, const QString& why, QWidget* parent) {
    return std::make_unique<FlatSceneView>(setup, why, parent);
}

} // namespace chiron::scene3d
