// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/scene3d/plugin/qt3d_parts.h"
#include "desktop/scene3d/scene_setup.h"

#include <Qt3DRender/QLayer>

namespace chiron::scene3d {

class NoticeFace;

/// The sentence shown in place of the endoscope's picture.
class Notice {
public:
    Notice(EffectShelf& effects, Qt3DRender::QLayer* layer, Qt3DCore::QEntity* root);

    void change(const SceneSetup& setup);
    /// Side of the square picture in device pixels, and device pixels per logical pixel.
    void setPicture(int side_px, double ratio);
    void show(bool shown) { m_part->setEnabled(shown); }

private:
    void repaint();

    SceneSetup m_setup;
    int m_side_px = 600;
    double m_ratio = 1.0;
    NoticeFace* m_face;
    Part* m_part;
};

} // namespace chiron::scene3d
