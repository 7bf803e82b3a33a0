// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/scene3d/scene_note.h"
#include "desktop/scene3d/scene_setup.h"

#include <QFont>
#include <QRectF>

class QPainter;

namespace chiron::scene3d {

/// Paints a note over a scene: two bars for a pause, an octagon for a stop, a plate at the top for `said`. In
/// 3D a texture shows it, because no widget may lie over a native window.
class SceneNotePainter {
public:
    explicit SceneNotePainter(const SceneSetup& setup) : m_setup(setup) {}

    /// `unit`: pixels per logical pixel.
    void paint(QPainter& painter, const QRectF& room, double unit, const SceneNote& note) const;

private:
    void paintVeil(QPainter& painter, const QRectF& room, double unit, const SceneNote& note) const;
    void paintPlate(QPainter& painter, const QRectF& room, double unit, const SceneNote& note) const;
    QFont font(double size_px, bool bold) const;

    SceneSetup m_setup;
};

} // namespace chiron::scene3d
