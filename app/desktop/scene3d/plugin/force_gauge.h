// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/scene3d/gauge_painter.h"
#include "desktop/scene3d/plugin/qt3d_parts.h"
#include "desktop/scene3d/plugin/shared_light.h"
#include "desktop/scene3d/scene_setup.h"
#include "desktop/scene3d/scene_state.h"

#include <QSize>

namespace chiron::scene3d {

class GaugeFace;

/// A force bar at an edge of the picture, with a scale in newtons and a limit line or a target band; it is
/// striped above the limit. It is part of the picture, because no widget may lie over a native window. It
/// takes one draw call.
class ForceGauge final : public Qt3DCore::QEntity {
public:
    enum class Side { left, right };
    ForceGauge(SharedLight& light, Side side, Qt3DCore::QNode* parent);

    void change(const SceneSetup& setup, const GaugeDial& dial, bool shown);
    /// Sets the size of the picture in device pixels and the number of device pixels per logical pixel.
    void setPicture(const QSize& size_px, double ratio);
    void show(double force_N);
    /// The share of the picture's width that the bar takes.
    double widthShare() const { return m_widthShare; }

private:
    void place();

    Side m_side;
    SceneSetup m_setup;
    GaugeDial m_dial;
    bool m_shown = false;
    QSize m_picture_px{1024, 768};
    double m_ratio = 1.0;
    double m_widthShare = 0.0;
    Qt3DRender::QParameter* m_spot;
    Qt3DRender::QParameter* m_column;
    Qt3DRender::QParameter* m_fill;
    Qt3DRender::QParameter* m_hollow;
    Qt3DRender::QParameter* m_over;
    Qt3DRender::QParameter* m_size;
    GaugeFace* m_face;
};

} // namespace chiron::scene3d
