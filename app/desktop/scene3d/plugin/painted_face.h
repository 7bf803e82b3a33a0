// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSize>
#include <Qt3DRender/QPaintedTextureImage>
#include <Qt3DRender/QTexture>
#include <functional>

class QPainter;

namespace chiron::scene3d {

/// A small texture that is repainted when it changes. It is transparent where nothing is painted.
class PaintedFace final : public Qt3DRender::QPaintedTextureImage {
public:
    using Paint = std::function<void(QPainter& painter)>;

    /// Creates the texture as a child of `parent`. The texture does not repeat.
    explicit PaintedFace(Qt3DCore::QNode* parent);

    void change(const QSize& size_px, Paint paint);
    Qt3DRender::QAbstractTexture* texture() const { return m_texture; }

protected:
    void paint(QPainter* painter) override;

private:
    Qt3DRender::QTexture2D* m_texture;
    Paint m_paint;
};

} // namespace chiron::scene3d
