// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/scene3d/plugin/qt3d_parts.h"
#include "desktop/scene3d/plugin/shared_light.h"
#include "desktop/scene3d/scene_setup.h"
#include "desktop/scene3d/scene_state.h"

#include <Qt3DRender/QTexture>

namespace chiron::scene3d {

/// The look of a soft organ. `pale.w` sets how visible its vessels are, `deep.w` how wet it is.
struct OrganLook {
    QVector4D pale;
    QVector4D deep;
};

/// The peritoneal cavity round the workspace: floor, bowel, omentum, uterus. It takes four draw calls. The
/// floor is flat where the instruments work; it receives their shadows and dents where a tip lies below it.
class Abdomen final : public Qt3DCore::QEntity {
public:
    Abdomen(SharedLight& light, double workspace_m, Qt3DCore::QNode* parent);

    /// Lowers the floor and the organs by this distance if the instruments work on something else.
    void lower(double by_m);
    void change(const SceneSetup& setup);
    void show(const SceneState& state);
    /// Creates a material for soft tissue, lit like the abdomen.
    Qt3DRender::QMaterial* organ(const OrganLook& look, Qt3DCore::QNode* parent);
    /// Creates the translucent material for soft shadows on the floor.
    Qt3DRender::QMaterial* shade(Qt3DCore::QNode* parent);

private:
    void chooseLook();
    Qt3DRender::QParameter* parameter(const char* name, const QVariant& value);

    SharedLight& m_light;
    SceneSetup m_setup;
    int m_tools = 0;
    Qt3DRender::QParameter* m_skin;
    Qt3DRender::QParameter* m_dentPlace;
    Qt3DRender::QParameter* m_dentNormal;
    Qt3DRender::QParameter* m_tips;
    Part* m_floor = nullptr;
    Qt3DCore::QEntity* m_ground;
    Qt3DCore::QTransform* m_height;
};

} // namespace chiron::scene3d
