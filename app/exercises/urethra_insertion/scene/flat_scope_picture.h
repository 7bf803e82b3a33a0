// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/exercises/urethra_insertion/scene/scope_marks.h"
#include "desktop/scene3d/scene_setup.h"

#include <QPainterPath>
#include <QRectF>

class QPainter;

namespace chiron::scene3d {

/// The view of the camera at the tip, as outlines: sections of the canal one behind the other, darker with
/// distance, each visible through the nearer ones; in the bladder its wall with the landmarks. The marks are
/// drawn over it.
class FlatScopePicture {
public:
    FlatScopePicture(const UrethraDrawing& drawing, const SceneSetup& setup)
        : m_drawing(drawing), m_setup(setup) {}

    void paint(QPainter& painter, const QRectF& square, const SceneState& state) const;

    /// Outline of the canal's section at s as seen from this tool, in the picture's own coordinates (radius
    /// 1, y up); empty if part of it lies beside or behind the camera.
    QPainterPath section(const ToolView& tool, double s_m) const;

private:
    void paintCanal(QPainter& painter, const ToolView& tool) const;
    void paintBladder(QPainter& painter, const SceneState& state) const;
    void paintMarks(QPainter& painter, const ScopeMarks& marks) const;
    void paintForce(QPainter& painter, const ScopeMarks& marks) const;
    void stroke(QPainter& painter, const QPainterPath& path, const QColor& colour, double wide) const;

    const UrethraDrawing& m_drawing;
    const SceneSetup& m_setup;
};

} // namespace chiron::scene3d
