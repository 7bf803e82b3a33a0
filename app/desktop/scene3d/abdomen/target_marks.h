// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/scene3d/plugin/qt3d_parts.h"
#include "desktop/scene3d/plugin/shared_light.h"
#include "desktop/scene3d/scene_setup.h"

#include <Qt3DRender/QLayer>

namespace chiron::scene3d {

/// Marks the place that an object is to be brought to: a ring with four ticks, and a line to the floor if the
/// place lies above it. The ring fills up while the object is held there.
class TargetRing final : public Qt3DCore::QEntity {
public:
    TargetRing(SharedLight& light, Qt3DCore::QNode* parent);

    void change(const SceneSetup& setup);
    /// `along` is the axis of the ring. `foot` adds the line to the floor. `dwell` is the filled share, 0..1.
    void show(const core::Vec3& p_W, const core::Vec3& along, double radius_m, bool foot, double dwell);
    void hide() { setEnabled(false); }
    /// Puts the translucent filling on this layer.
    void putTranslucent(Qt3DRender::QLayer* layer);

private:
    Qt3DRender::QParameter* m_tint;
    Qt3DRender::QParameter* m_edgeTint;
    Qt3DRender::QParameter* m_fillTint;
    Part* m_ring;
    Part* m_edge;
    Part* m_fill;
    Part* m_line;
    Part* m_ticks[4];
};

} // namespace chiron::scene3d
