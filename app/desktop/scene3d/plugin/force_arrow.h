// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/scene3d/plugin/qt3d_parts.h"
#include "desktop/scene3d/plugin/shared_light.h"
#include "desktop/scene3d/scene_setup.h"
#include "desktop/scene3d/scene_state.h"

namespace chiron::scene3d {

/// Shows the force on the tool as an arrow from its tip, 10 mm long per quarter of the limit, with a ring at
/// the length of the limit and a thin line to it. Above the limit it not only changes colour, but also grows
/// thicker and has rings. It is drawn over the instrument.
class ForceArrow final : public Qt3DCore::QEntity {
public:
    ForceArrow(SharedLight& light, Qt3DCore::QNode* parent);

    void change(const SceneSetup& setup);
    void show(const ToolView& tool);

    static constexpr double kLimit_mm = 40.0; ///< length at the limit
    /// Multiple of the limit's length; beyond that only the bar shows the force.
    static constexpr double kLongest = 1.75;
    static constexpr double kLeast_N = 0.02; ///< no arrow below this force

private:
    SceneSetup m_setup;
    Qt3DCore::QTransform* m_pose;
    Qt3DRender::QParameter* m_tint;
    Qt3DRender::QParameter* m_lineTint;
    Part* m_stem;
    Part* m_head;
    Part* m_way; ///< thin line from the tip to the limit's ring
    Part* m_limit;
    Part* m_rings[3];
};

} // namespace chiron::scene3d
