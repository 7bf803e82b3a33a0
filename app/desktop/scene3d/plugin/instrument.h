// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/scene3d/drawn_tool.h"
#include "desktop/scene3d/plugin/qt3d_parts.h"
#include "desktop/scene3d/plugin/shared_light.h"

namespace chiron::scene3d {

/// A laparoscopic grasper, solid or as a translucent ghost. It takes three draw calls. If there are several
/// instruments, each has rings (one: the right, two: the left, ...), and the one that the mouse moves has a
/// collar; rings and collar take one call each.
class Instrument final : public Qt3DCore::QEntity {
public:
    Instrument(SharedLight& light, bool ghost, Qt3DCore::QNode* parent);

    void setGhostColour(const QColor& colour);
    /// `rings`: number of rings on the shaft, 0..4. `collar`: mouse and keyboard move this instrument.
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
