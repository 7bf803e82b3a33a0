// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/scene3d/scene_view.h"

#include <QString>
#include <memory>

namespace chiron::scene3d {

/// A scene, and why it is flat. There is always a view: without OpenGL an exercise runs with the view from
/// above and from the side.
struct LoadedScene {
    std::unique_ptr<ISceneView> view;
    QString whyFlat; ///< empty in 3D; else one translated sentence, which the flat view shows too
};

/// The plugin's factory, or why there is none (one translated sentence).
struct ScenePlugin {
    ISceneView* (*make)(const SceneSetup* setup, QWidget* parent) = nullptr;
    QString why;
};

/// Loads the plugin from this folder and checks that it belongs to this build. Thread: any.
ScenePlugin loadScenePlugin(const QString& folder);

/// Loads what the 3D scene needs (Qt3D and the graphics driver: up to some 0.1 s the first time) and says why
/// it cannot be drawn; empty if it can. Reasons: CHIRON_NO_3D is set, the platform has no windows of its own
/// (offscreen), the plugin is missing, does not load or belongs to another build, OpenGL 3.2 is not
/// available. The plugin is sought in CHIRON_PLUGINS if that is set, else in the program's own folder.
/// Thread: any, so that it can be called on a worker while the window is used; a later call is then quick.
QString findWhyFlat();

/// Makes the scene: in 3D where findWhyFlat() has nothing to say, else flat. The view's widget is a child of
/// `parent`. GUI thread, after the window has been painted.
LoadedScene makeSceneView(const SceneSetup& setup, QWidget* parent);

/// The flat scene, because of `why` (shown at the bottom; empty: no such line).
std::unique_ptr<ISceneView> makeFlatSceneView(const SceneSetup& setup, const QString& why, QWidget* parent);

} // namespace chiron::scene3d
