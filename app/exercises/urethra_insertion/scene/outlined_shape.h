// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/scene3d/plugin/qt3d_parts.h"

namespace chiron::scene3d {

/// A flat mark that is visible on light and on dark backgrounds: a bright shape over a slightly larger black
/// one, in the picture's own coordinates.
class OutlinedShape {
public:
    /// `inner`: the bright shape; `outer`: its black background.
    OutlinedShape(EffectShelf& effects, const TriangleMesh& inner, const TriangleMesh& outer,
                  Qt3DCore::QEntity* parent);

    void show(bool shown) { m_entity->setEnabled(shown); }
    void setColour(const QColor& colour) { m_tint->setValue(toTint(colour)); }
    /// Fraction of a round shape that is drawn, from the top.
    void setShare(double turn) { m_share->setValue(float(turn)); }
    /// Sets position, rotation (radians, counter-clockwise) and stretch along its own x axis.
    void place(double x, double y, double turn_rad = 0.0, double along = 1.0, double size = 1.0);

private:
    Qt3DCore::QEntity* m_entity;
    Qt3DCore::QTransform* m_transform;
    Qt3DRender::QParameter* m_tint;
    Qt3DRender::QParameter* m_share;
};

} // namespace chiron::scene3d
