// SPDX-License-Identifier: GPL-3.0-or-later
// What the program finds in this file: see scene_plugin.h.
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
    // Faster on a software rasteriser than the other back end; read when the first render aspect is made.
    if (!qEnvironmentVariableIsSet("QT3D_RENDERER"))
        qputenv("QT3D_RENDERER", "opengl");
    return new chiron::scene3d::Qt3DSceneView(*setup, parent);
}

} // extern "C"
