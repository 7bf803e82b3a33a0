// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/exercises/urethra_insertion/scene/urethra_drawing.h"
#include "desktop/scene3d/plugin/qt3d_parts.h"
#include "desktop/scene3d/scene_setup.h"
#include "desktop/scene3d/scene_state.h"

namespace chiron::scene3d {

/// A ring round each landmark on the bladder's wall, with a tick mark once it was seen; only if the level
/// gives guidance. The rings lie on the wall, so whatever hides the wall hides them too, and they stay sharp.
class LandmarkMarks {
public:
    /// `anatomy`: the entity placed at the origin of frame A.
    LandmarkMarks(const UrethraDrawing& drawing, EffectShelf& effects, Qt3DCore::QEntity* anatomy);

    void change(const SceneSetup& setup);
    void show(const SceneState& state);

private:
    void add(const UrethraDrawing& drawing, const simulation::BladderLandmark& landmark,
             EffectShelf& effects);

    Qt3DCore::QEntity* m_entity;
    Qt3DRender::QParameter* m_bright;
    Qt3DRender::QParameter* m_dark;
    std::vector<Qt3DCore::QEntity*> m_ticks;
    bool m_guided = false;
};

} // namespace chiron::scene3d
