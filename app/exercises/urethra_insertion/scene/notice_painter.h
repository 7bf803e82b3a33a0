// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/scene3d/scene_setup.h"

#include <QRectF>

class QPainter;

namespace chiron::scene3d {

/// Explains why the endoscope's picture is black, in one sentence that is as large as the room allows, light
/// on black in every theme. In 3D a texture shows it, because no widget can lie over a native window.
class NoticePainter {
public:
    explicit NoticePainter(const SceneSetup& setup) : m_setup(setup) {}

    /// Fills the room with black and writes the sentence into it. `unit`: device pixels per logical pixel.
    void paint(QPainter& painter, const QRectF& room, double unit) const;
    static QString sentence();

private:
    SceneSetup m_setup;
};

} // namespace chiron::scene3d
