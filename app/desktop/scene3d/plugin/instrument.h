// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/scene3d/drawn_tool.h"
#include "desktop/scene3d/plugin/qt3d_parts.h"
#include "desktop/scene3d/plugin/shared_light.h"

namespace chiron::scene3d {

/// A laparoscopic grasper, itself or as a translucent ghost. Three draw calls.
class Instrument final : public Qt3DCore::QEntity {
public:
    Instrument(SharedLight& light, bool ghost, Qt3DCore::QNode* parent);

    void setGhostColour(const QColor& colour);
    void show(const ToolView& tool, bool leftHanded);

private:
    DrawnOrientation m_orientation;
    bool m_ghost;
    Qt3DCore::QTransform* m_pose;
    Qt3DRender::QParameter* m_tint;
    Part* m_jaw[2];
};

} // namespace chiron::scene3d
