// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/scene3d/gauge_painter.h"

#include <Qt3DRender/QPaintedTextureImage>

namespace chiron::scene3d {

/// The face of the force bar as a texture, painted once for each size or colour scheme.
class GaugeFace final : public Qt3DRender::QPaintedTextureImage {
public:
    explicit GaugeFace(Qt3DCore::QNode* parent) : QPaintedTextureImage(parent) {}

    void change(const SceneSetup& setup, const GaugeDial& dial, double unit_px);

protected:
    void paint(QPainter* painter) override;

private:
    SceneSetup m_setup;
    GaugeDial m_dial;
    double m_unit_px = 1.0;
};

} // namespace chiron::scene3d
