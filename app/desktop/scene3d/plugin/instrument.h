// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/scene3d/drawn_tool.h"
#include "desktop/scene3d/plugin/qt3d_parts.h"
#include "desktop/scene3d/plugin/shared_light.h"

namespace chiron::scene3d {

/// A laparoscopic grasper, itself or as a translucent ghost. Three draw calls; of several instruments each wears rings (one: the
/// right, two: the left one, ...), and the one that the mouse moves a collar: one call each.
class Instrument final : public Qt3DCore::QEntity {
public:
    Instrument(SharedLight& light, bool ghost, Qt3DCore::QNode* parent);

    void setGhostColour(const QColor& colour);
    /// `rings`: 0..4 on the shaft; `collar`: mouse and keyboard move this one.
    void wear(int rings, bool collar);
    void show(const ToolView& tool, bool leftHanded);

private:
    void addRings(SharedLight& light);

    DrawnOrientation m_orientation;
    bool m_ghost;
    Qt3DCore::QTransform* m_pose;
    Qt3DRender::QParameter* m_tint;
    Part* m_jaw[2];
    Part* m_rings[core::kMaxTools] = {};
    Part* m_collar = nullptr;
};

} // namespace chiron::scene3d
