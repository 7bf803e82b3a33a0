// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/scene2d/flat_panel.h"
#include "desktop/scene3d/drawn_tool.h"
#include "desktop/scene3d/scene_state.h"

class QPainter;

namespace chiron::scene3d {

/// Draws the instrument, ghost, force arrow, drop line, pin and crosses in one of the flat views.
class FlatTools {
public:
    FlatTools(QPainter& painter, const FlatPanel& panel, const SceneSetup& setup)
        : m_painter(painter), m_panel(panel), m_setup(setup) {}

    void paintTool(const ToolView& tool, const core::Quat& q_W, bool ghost);
    /// Draws the rings that distinguish several instruments, and a square round the tip of the one that the
    /// mouse moves.
    void paintRings(const ToolView& tool, const core::Quat& q_W, int index, bool active);
    /// Draws the same arrow as in 3D, projected into this view: 40 mm long at the limit, with a bar across it
    /// there. Above the limit the arrow is thicker and has rungs.
    void paintArrow(const ToolView& tool);
    void paintDropLine(const core::Vec3& from_W, double ground_m);
    void paintPin(const core::Vec3& p_W);
    void paintAnswer(const core::Vec3& p_W); ///< double ring where the mark should have been
    /// Crosses where tissue gave way, over everything, because these places lie inside the tissue.
    void paintYields(const SceneState& state);

private:
    void paintBlades(const ToolView& tool, const core::Quat& q_W, double shaft, const QColor& steel,
                     const QColor& edge);
    void paintAcross(const QPointF& middle, const QPointF& along, double half_mm, double wide,
                     const QColor& colour);
    void paintArrowShape(const QPointF& from, const QPointF& along, bool over, double halo,
                         const QColor& colour);

    QPainter& m_painter;
    const FlatPanel& m_panel;
    const SceneSetup& m_setup;
};

} // namespace chiron::scene3d
