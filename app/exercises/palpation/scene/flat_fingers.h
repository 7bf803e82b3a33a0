// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/scene2d/flat_panel.h"
#include "desktop/scene3d/scene_state.h"
#include "simulation/palpation/tissue_surface.h"

#include <QPainterPath>

class QPainter;

namespace chiron::scene3d {

/// Fingers in the flat pictures; a hand in the air is almost transparent. The view from above shows pad,
/// outline, bands, and a dial whose needle shows direction and amount of the platform's lean (its rim: 30°).
/// The view from the side shows the outline, the leaning platform, and a bar with the depth in millimetres.
class FlatFingers {
public:
    FlatFingers(QPainter& painter, const FlatPanel& panel, const SceneSetup& setup,
                const simulation::TissueSurface& surface)
        : m_painter(painter), m_panel(panel), m_setup(setup), m_surface(surface) {}

    void paint(const SceneState& state) const;
    void paintGhost(const ToolView& ghost) const;

private:
    /// `glove`: the colour of the glove including its opacity.
    void paintOutline(const ToolView& tool, std::size_t index, const QColor& glove, bool ghost) const;
    QPainterPath backOfHand(const ToolView& tool, std::size_t index) const;
    void paintBands(const ToolView& tool, std::size_t index, bool active) const;
    void paintDial(const SceneState& state, std::size_t index) const;
    void paintPlatform(const SceneState& state, std::size_t index) const;
    void paintDepth(const SceneState& state, std::size_t index) const;
    void paintBlades(const ToolView& tool, std::size_t index) const;
    QPointF along(const ToolView& tool, std::size_t index, double y_mm, double z_mm) const;

    QPainter& m_painter;
    const FlatPanel& m_panel;
    const SceneSetup& m_setup;
    const simulation::TissueSurface& m_surface;
};

} // namespace chiron::scene3d
