// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/exercises/palpation/scene/map_legend.h"
#include "desktop/scene3d/plugin/painted_face.h"
#include "desktop/scene3d/plugin/qt3d_parts.h"
#include "desktop/scene3d/plugin/shared_light.h"

#include <Qt3DRender/QLayer>
#include <optional>

namespace chiron::scene3d {

/// The map's legend in the lower left corner of the picture. One draw call.
class MapCard final : public Qt3DCore::QEntity {
public:
    MapCard(SharedLight& light, Qt3DCore::QNode* parent);

    void change(const SceneSetup& setup);
    /// The size of the picture in device pixels, and the device pixels per logical pixel.
    void setPicture(const QSize& size_px, double ratio);
    void show(const SceneState& state, bool shown);

private:
    void repaint();

    SceneSetup m_setup;
    std::optional<MapLegend> m_legend;
    QSize m_picture_px{1024, 768};
    double m_ratio = 1.0;
    PaintedFace* m_face;
    Qt3DRender::QParameter* m_spot;
};

} // namespace chiron::scene3d
