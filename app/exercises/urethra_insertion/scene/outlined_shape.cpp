// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/urethra_insertion/scene/outlined_shape.h"

#include <QMatrix4x4>

namespace chiron::scene3d {

namespace {
constexpr float kGround = -0.9985F; // depth in front of the black round the picture
constexpr float kShape = -0.9990F;
} // namespace

OutlinedShape::OutlinedShape(EffectShelf& effects, const TriangleMesh& inner, const TriangleMesh& outer,
                             Qt3DCore::QEntity* parent)
    : m_entity(new Qt3DCore::QEntity(parent)), m_transform(new Qt3DCore::QTransform(m_entity)),
      m_tint(new Qt3DRender::QParameter(QStringLiteral("tint"), QVector4D(1, 1, 1, 1), m_entity)),
      m_share(new Qt3DRender::QParameter(QStringLiteral("share"), 2.0F, m_entity)) {
    auto* black = new Qt3DRender::QParameter(QStringLiteral("tint"), QVector4D(0, 0, 0, 1), m_entity);
    m_entity->addComponent(m_transform);
    auto* ground = effects.materialWith("#define BOTH_SIDES\n", "screen.vert", "turn.frag", {black, m_share},
                                        Blend::opaque, m_entity);
    auto* shape = effects.materialWith("#define BOTH_SIDES\n", "screen.vert", "turn.frag", {m_tint, m_share},
                                       Blend::opaque, m_entity);
    (new Part(outer, ground, m_entity))->at().setTranslation({0.0F, 0.0F, kGround});
    (new Part(inner, shape, m_entity))->at().setTranslation({0.0F, 0.0F, kShape});
    m_entity->setEnabled(false);
}

void OutlinedShape::place(double x, double y, double turn_rad, double along, double size) {
    QMatrix4x4 matrix;
    matrix.translate(float(x), float(y), 0.0F);
    matrix.rotate(qRadiansToDegrees(float(turn_rad)), 0.0F, 0.0F, 1.0F);
    matrix.scale(float(along * size), float(size), 1.0F);
    m_transform->setMatrix(matrix);
}

} // namespace chiron::scene3d
