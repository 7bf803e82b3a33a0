// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/scene3d/scene_view.h"

#include <QtGlobal>

namespace chiron::scene3d {

/// The face between the program and the plugin that links Qt3D. Program and plugin are built together; this
/// text says so: face number, Qt version, and the sizes of what is handed over. Another text means another
/// build.
inline QByteArray sceneAbi() {
    return QByteArrayLiteral("chiron-scene 4 Qt " QT_VERSION_STR " ") +
           QByteArray::number(qulonglong(sizeof(SceneSetup))) + ' ' +
           QByteArray::number(qulonglong(sizeof(SceneState)));
}

inline constexpr const char* kScenePluginFile = "chiron_scene3d.so"; ///< in the folder of the program
inline constexpr const char* kSceneAbiSymbol = "chironSceneAbi";
inline constexpr const char* kSceneMakeSymbol = "chironMakeScene";
/// Of the window that is the view's input source: the Qt3D entity that it draws, for a test that reads what a scene is made of.
inline constexpr const char* kSceneRootProperty = "scene.root";

using SceneAbiFunction = const char* (*)();
/// The caller owns what comes back; nullptr where the exercise has no drawn scene.
using SceneMakeFunction = ISceneView* (*)(const SceneSetup* setup, QWidget* parent);

} // namespace chiron::scene3d
