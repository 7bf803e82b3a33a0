// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/scene3d/scene_setup.h"

#include <QRectF>
#include <Qt3DRender/QPaintedTextureImage>

namespace chiron::scene3d {

/// Frame, scale, limit line and words of the force bar, painted once per size or colour; the bar's hollow stays empty.
class GaugeFace final : public Qt3DRender::QPaintedTextureImage {
public:
    explicit GaugeFace(Qt3DCore::QNode* parent) : QPaintedTextureImage(parent) {}

    void change(const SceneSetup& setup, double unit_px);
    /// The hollow as shares of the face, from the lower left corner.
    QRectF hollow() const;

    static constexpr double kWidth = 76.0; ///< logical pixels at scale 1
    static constexpr double kHeight = 300.0;
    static constexpr double kRange = 1.5; ///< of the limit: the scale's end

protected:
    void paint(QPainter* painter) override;

private:
    double heightOf(double force_N) const; ///< y in logical pixels
    void paintScale(QPainter& painter) const;
    void paintLimit(QPainter& painter) const;
    QFont font(double size, bool bold) const;

    SceneSetup m_setup;
    double m_unit_px = 1.0;
};

} // namespace chiron::scene3d
