// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/scene3d/scene_view.h"

#include <QString>
#include <memory>

namespace chiron::scene3d {

/// A scene view, and the reason if it is flat. There is always a view: without OpenGL an exercise uses the
/// flat views from above and from the side.
struct LoadedScene {
    std::unique_ptr<ISceneView> view;
    QString whyFlat; ///< empty in 3D, else one translated sentence, which the flat view also shows
};

/// The plugin's factory, or the reason why there is none (one translated sentence).
struct ScenePlugin {
    ISceneView* (*make)(const SceneSetup* setup, QWidget* parent) = nullptr;
    QString why;
};

/// Loads the plugin from this folder and checks that it belongs to this build.
/// Thread: any.
ScenePlugin loadScenePlugin(const QString& folder);

/// Loads what the 3D scene needs (Qt3D and the graphics driver: up to some 0.1 s the first time) and returns
/// the reason why it cannot be drawn, or an empty text if it can. Reasons: CHIRON_NO_3D is set, the platform
/// has no native windows (offscreen), the plugin is missing, does not load or belongs to another build, or
/// OpenGL 3.2 is not available. The plugin is sought in CHIRON_PLUGINS if that is set, else in the program's
/// own folder. Later calls are quick.
/// Thread: any, so that a worker can call it while the window is in use.
QString findWhyFlat();

/// Creates the scene: in 3D if findWhyFlat() returns nothing, else flat. The view's widget is a child of
/// `parent`.
/// Thread: GUI, after the window has been painted.
LoadedScene makeSceneView(const SceneSetup& setup, QWidget* parent);

/// Creates the flat scene. `why` is shown at the bottom; if it is empty, there is no such line.
std::unique_ptr<ISceneView> makeFlatSceneView(const SceneSetup& setup, const QString& why, QWidget* parent);

} // namespace chiron::scene3d
