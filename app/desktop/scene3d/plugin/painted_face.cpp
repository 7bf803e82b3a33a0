// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/scene3d/plugin/painted_face.h"

#include <QPainter>
#include <Qt3DRender/QTextureWrapMode>

namespace chiron::scene3d {

PaintedFace::PaintedFace(Qt3DCore::QNode* parent) : m_texture(new Qt3DRender::QTexture2D(parent)) {
    m_texture->setFormat(Qt3DRender::QAbstractTexture::RGBA8_UNorm);
    m_texture->setMinificationFilter(Qt3DRender::QAbstractTexture::Linear);
    m_texture->setMagnificationFilter(Qt3DRender::QAbstractTexture::Linear);
    m_texture->setWrapMode(Qt3DRender::QTextureWrapMode(Qt3DRender::QTextureWrapMode::ClampToEdge));
    setParent(m_texture);
    setSize(QSize(8, 8));
    m_texture->addTextureImage(this);
}

void PaintedFace::change(const QSize& size_px, Paint paint) {
    m_paint = std::move(paint);
    setSize(size_px);
    update();
}

void PaintedFace::paint(QPainter* painter) {
    painter->setCompositionMode(QPainter::CompositionMode_Source);
    painter->fillRect(QRect(QPoint(0, 0), size()), Qt::transparent);
    painter->setCompositionMode(QPainter::CompositionMode_SourceOver);
    if (m_paint)
        m_paint(*painter);
}

} // namespace chiron::scene3d
