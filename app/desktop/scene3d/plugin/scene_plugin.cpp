// SPDX-License-Identifier: GPL-3.0-or-later
// The functions that the program looks up in the plugin: see scene_plugin.h.
#include "desktop/scene3d/scene_plugin.h"

#include "desktop/scene3d/plugin/qt3d_scene_view.h"

extern "C" {

Q_DECL_EXPORT const char* chironSceneAbi() {
    static const QByteArray text = chiron::scene3d::sceneAbi();
    return text.constData();
}

Q_DECL_EXPORT chiron::scene3d::ISceneView* chironMakeScene(const chiron::scene3d::SceneSetup* setup,
                                                           QWidget* parent) {
    if (!chiron::scene3d::hasStage(*setup))
        return nullptr;
    // This back end is faster than the other one on a software rasteriser. Qt3D reads the variable when the
    // first render aspect is created.
    if (!qEnvironmentVariableIsSet("QT3D_RENDERER"))
        qputenv("QT3D_RENDERER", "opengl");
    return new chiron::scene3d::Qt3DSceneView(*setup, parent);
}

} // extern "C"
