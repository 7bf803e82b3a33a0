// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/exercises/urethra_insertion/scene/outlined_shape.h"
#include "app/exercises/urethra_insertion/scene/scope_marks.h"

#include <Qt3DRender/QLayer>
#include <array>
#include <memory>

namespace chiron::scene3d {

/// ScopeMarks over the round picture: the ring at the middle of the lumen with the line from it to its target
/// position, the arc that fills while a landmark is held in view, and the force across the shaft as an arrow
/// with the bar of its limit.
class PictureMarks {
public:
    PictureMarks(EffectShelf& effects, Qt3DRender::QLayer* layer, Qt3DCore::QEntity* root);

    void change(const SceneSetup& setup);
    void show(const ScopeMarks& marks);

private:
    using Shape = std::unique_ptr<OutlinedShape>;
    Shape make(const TriangleMesh& inner, const TriangleMesh& outer) const;
    void showGuidance(const ScopeMarks& marks);
    void showForce(const ScopeMarks& marks);

    EffectShelf& m_effects;
    Qt3DCore::QEntity* m_entity;
    QColor m_guide;
    QColor m_force;
    QColor m_overForce;
    Shape m_target, m_ring, m_inner, m_way, m_point, m_dwell;
    Shape m_stem, m_head, m_limit;
    std::array<Shape, 3> m_rungs;
};

} // namespace chiron::scene3d
