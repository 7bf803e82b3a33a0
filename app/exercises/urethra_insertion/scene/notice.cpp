// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/urethra_insertion/scene/notice.h"

#include "app/exercises/urethra_insertion/scene/notice_painter.h"
#include "desktop/scene3d/parts/flat_shapes.h"

#include <QPainter>
#include <QVariant>
#include <Qt3DRender/QPaintedTextureImage>
#include <Qt3DRender/QTexture>
#include <algorithm>

namespace chiron::scene3d {

namespace {
constexpr double kWide = 0.76; // width, as a fraction of the round picture's
constexpr double kHigh = 0.40;
} // namespace

/// The sentence as a texture, painted once per size or language.
class NoticeFace final : public Qt3DRender::QPaintedTextureImage {
public:
    explicit NoticeFace(Qt3DCore::QNode* parent) : QPaintedTextureImage(parent) {}

    void change(const SceneSetup& setup, const QSize& size_px, double unit) {
        m_setup = setup;
        m_unit = unit;
        setSize(size_px);
        update();
    }

protected:
    void paint(QPainter* painter) override {
        painter->setRenderHint(QPainter::TextAntialiasing);
        NoticePainter(m_setup).paint(*painter, QRectF(QPointF(0, 0), size()), m_unit);
    }

private:
    SceneSetup m_setup;
    double m_unit = 1.0;
};

Notice::Notice(EffectShelf& effects, Qt3DRender::QLayer* layer, Qt3DCore::QEntity* root) {
    auto* texture = new Qt3DRender::QTexture2D(root);
    texture->setFormat(Qt3DRender::QAbstractTexture::RGBA8_UNorm);
    texture->setMinificationFilter(Qt3DRender::QAbstractTexture::Linear);
    texture->setMagnificationFilter(Qt3DRender::QAbstractTexture::Linear);
    m_face = new NoticeFace(texture);
    m_face->setSize(QSize(8, 8));
    texture->addTextureImage(m_face);
    auto* face = new Qt3DRender::QParameter(
        QStringLiteral("face"), QVariant::fromValue<Qt3DRender::QAbstractTexture*>(texture), root);
    m_part = new Part(flatSquare(-0.9992),
                      effects.material("screen.vert", "notice.frag", {face}, Blend::opaque, root), root);
    m_part->addComponent(layer);
    m_part->at().setScale3D({float(kWide), float(kHigh), 1.0F});
}

void Notice::change(const SceneSetup& setup) {
    m_setup = setup;
    repaint();
}

void Notice::setPicture(int side_px, double ratio) {
    m_side_px = side_px;
    m_ratio = ratio;
    repaint();
}

void Notice::repaint() {
    m_face->change(m_setup, QSize(std::max(8, int(kWide * m_side_px)), std::max(8, int(kHigh * m_side_px))),
                   m_ratio);
}

} // namespace chiron::scene3d
