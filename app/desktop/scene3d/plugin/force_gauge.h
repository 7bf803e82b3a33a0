// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/scene3d/plugin/qt3d_parts.h"
#include "desktop/scene3d/plugin/shared_light.h"
#include "desktop/scene3d/scene_setup.h"
#include "desktop/scene3d/scene_state.h"

#include <QSize>

namespace chiron::scene3d {

class GaugeFace;

/// The force bar at the right edge of the picture: a scale in newtons with the limit line; striped over the
/// limit. It lies in the picture because no widget may lie over a native window. One draw call.
class ForceGauge final : public Qt3DCore::QEntity {
public:
    ForceGauge(SharedLight& light, Qt3DCore::QNode* parent);

    void change(const SceneSetup& setup);
    /// The picture's size in device pixels, and device pixels a logical one.
    void setPicture(const QSize& size_px, double ratio);
    void show(const SceneState& state);
    /// Share of the picture's width that it takes.
    double widthShare() const { return m_widthShare; }

private:
    void place();

    SceneSetup m_setup;
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
