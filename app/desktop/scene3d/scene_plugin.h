// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/scene3d/scene_view.h"

#include <QtGlobal>

namespace chiron::scene3d {

/// The interface between the program and the plugin that links Qt3D. Program and plugin must come from the
/// same build. This text identifies the build by the interface number, the Qt version and the sizes of the
/// structs that are passed; a different text means a different build.
inline QByteArray sceneAbi() {
    return QByteArrayLiteral("chiron-scene 4 Qt " QT_VERSION_STR " ") +
           QByteArray::number(qulonglong(sizeof(SceneSetup))) + ' ' +
           QByteArray::number(qulonglong(sizeof(SceneState)));
}

inline constexpr const char* kScenePluginFile = "chiron_scene3d.so"; ///< in the folder of the program
inline constexpr const char* kSceneAbiSymbol = "chironSceneAbi";
inline constexpr const char* kSceneMakeSymbol = "chironMakeScene";
/// Property of the window that is the view's input source: the Qt3D entity that it draws, for a test that
/// inspects the content of a scene.
inline constexpr const char* kSceneRootProperty = "scene.root";

using SceneAbiFunction = const char* (*)();
/// The caller owns the returned view; nullptr if the exercise has no drawn scene.
using SceneMakeFunction = ISceneView* (*)(const SceneSetup* setup, QWidget* parent);

} // namespace chiron::scene3d
