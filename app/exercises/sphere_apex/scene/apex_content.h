// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/exercises/sphere_apex/scene/apex_surface.h"
#include "desktop/scene3d/plugin/qt3d_parts.h"
#include "desktop/scene3d/plugin/scene_content.h"
#include "modules/exercises/sphere_apex/simulation/sphere_apex_parameters.h"

namespace chiron::scene3d {

/// The hemisphere on its plane, or the cover over it. It is one entity whose triangles change only with the
/// trial; the vertex shader displaces it under the tips.
class ApexContent final : public ISceneContent {
public:
    ApexContent(const SceneSetup& setup, SharedLight& light, Qt3DCore::QEntity* parent);

    void change(const SceneSetup& setup) override;
    void show(const SceneState& state) override;
    void warm() override;
    double groundHeight_m(double x_m, double y_m) const override { return m_surface.height_m(x_m, y_m); }
    ContentFrame frame() const override {
        return {.fieldRadius_m = m_parameters.workspaceRadius_m,
                .planeHeight_m = m_parameters.planeHeight_m,
                .roomAbove_m = m_parameters.radius_m + 0.022};
    }

private:
    void chooseLook();
    Qt3DRender::QEffect* look(bool shown) const;
    void showTips(const SceneState& state);
    Qt3DRender::QParameter* parameter(const char* name, const QVariant& value, Qt3DCore::QNode* parent);

    simulation::SphereApexParameters m_parameters;
    SceneSetup m_setup;
    ApexSurface m_surface;
    Qt3DRender::QParameter* m_dentPlace;
    Qt3DRender::QParameter* m_dentNormal;
    Qt3DRender::QParameter* m_tips;
    Qt3DRender::QParameter* m_presses;
    Qt3DRender::QParameter* m_plain;
    SharedLight& m_light;
    int m_tools = 0; ///< number of tips drawn
    Part* m_part = nullptr;
    bool m_warm = false; ///< the look that is not shown is loaded as well
};

} // namespace chiron::scene3d
