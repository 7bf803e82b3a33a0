// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/scene3d/scene_setup.h"

#include <QRectF>

class QPainter;

namespace chiron::scene3d {

/// Why the endoscope's picture is black: one sentence, as large as its room allows, light on black in every theme. In 3D a
/// texture shows it, since no widget may lie over a native window.
class NoticePainter {
public:
    explicit NoticePainter(const SceneSetup& setup) : m_setup(setup) {}

    /// Fills the room with black and writes into it. `unit`: pixels a logical one.
    void paint(QPainter& painter, const QRectF& room, double unit) const;
    static QString sentence();

private:
    SceneSetup m_setup;
};

} // namespace chiron::scene3d
