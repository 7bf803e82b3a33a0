// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/scene3d/plugin/qt3d_parts.h"
#include "desktop/scene3d/plugin/shared_light.h"
#include "desktop/scene3d/scene_setup.h"

#include <Qt3DRender/QLayer>

namespace chiron::scene3d {

/// Where something is to be brought: a ring with four ticks, and a line to the floor where it hangs above it. It fills with
/// the time that the thing has been held there.
class TargetRing final : public Qt3DCore::QEntity {
public:
    TargetRing(SharedLight& light, Qt3DCore::QNode* parent);

    void change(const SceneSetup& setup);
    /// `along`: the ring's axis. `foot`: with the line to the floor.
    void show(const core::Vec3& p_W, const core::Vec3& along, double radius_m, bool foot, double dwell);
    void hide() { setEnabled(false); }
    /// The filling is translucent.
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
