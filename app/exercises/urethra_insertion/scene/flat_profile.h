// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/exercises/urethra_insertion/scene/urethra_drawing.h"
#include "desktop/scene2d/flat_panel.h"
#include "desktop/scene3d/scene_state.h"

#include <QPolygonF>

namespace chiron::scene3d {

/// The canal from the side, cut in the plane of symmetry: its outline with the opened part, the bladder, the
/// shaft and the force on its tip.
class FlatProfile {
public:
    FlatProfile(const UrethraDrawing& drawing, const SceneSetup& setup)
        : m_drawing(drawing), m_setup(setup) {}

    void paint(QPainter& painter, const QRectF& room, const SceneState& state) const;

    /// The canal's two drawn edges from A to C (metres, W). Behind the tip the canal encloses the shaft.
    struct Edges {
        std::vector<core::Vec3> low;
        std::vector<core::Vec3> high;
    };
    Edges edges(const ToolView& tool) const;

private:
    QRectF range_mm() const;
    void paintTissue(QPainter& painter, const FlatPanel& panel, const ToolView& tool) const;
    void paintShaft(QPainter& painter, const FlatPanel& panel, const ToolView& tool, bool ghost) const;

    const UrethraDrawing& m_drawing;
    const SceneSetup& m_setup;
};

} // namespace chiron::scene3d
