// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/scene3d/plugin/qt3d_parts.h"
#include "desktop/scene3d/plugin/shared_light.h"
#include "desktop/scene3d/scene_setup.h"
#include "desktop/scene3d/scene_state.h"

#include <Qt3DRender/QLayer>
#include <utility>
#include <vector>

namespace chiron::scene3d {

/// Marks in playback where tissue gave way, in every stage: a star of three bars at each place, drawn over
/// everything, because these places lie inside the tissue. Its entities are made when they are first needed.
class YieldMarks {
public:
    /// Name of the entity that holds the stars.
    static constexpr const char* kName = "scene.yields";

    /// `over`: the layer that is drawn over everything.
    YieldMarks(SharedLight& light, Qt3DRender::QLayer* over, Qt3DCore::QEntity* root)
        : m_light(light), m_over(over), m_root(root) {}

    void change(const SceneSetup& setup);
    void show(const SceneState& state);

private:
    void begin();
    void addStar();

    SharedLight& m_light;
    Qt3DRender::QLayer* m_over;
    Qt3DCore::QEntity* m_root;
    QColor m_colour;
    Qt3DCore::QEntity* m_stars = nullptr; ///< null until there is a place to mark
    Qt3DRender::QParameter* m_tint = nullptr;
    Qt3DRender::QMaterial* m_material = nullptr;
    std::vector<std::pair<Qt3DCore::QEntity*, Qt3DCore::QTransform*>> m_star;
};

} // namespace chiron::scene3d
