// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/scene3d/plugin/instrument.h"

#include "desktop/scene3d/parts/instrument_mesh.h"

#include <QMatrix4x4>

namespace chiron::scene3d {

Instrument::Instrument(SharedLight& light, bool ghost, Qt3DCore::QNode* parent)
    : QEntity(parent), m_ghost(ghost), m_pose(new Qt3DCore::QTransform(this)),
      m_tint(new Qt3DRender::QParameter(QStringLiteral("tint"), QVector4D(1, 1, 1, 1), this)) {
    auto* material =
        light.effects.material("solid.vert", "instrument.frag", {light.lamp, light.outlined, m_tint},
                               ghost ? Blend::translucent : Blend::opaque, this);
    addComponent(m_pose);
    new Part(instrumentBody(), material, this);
    for (Part*& jaw : m_jaw)
        jaw = new Part(instrumentJaw(), material, this);
    if (!ghost)
        addRings(light);
    setEnabled(false);
}

void Instrument::addRings(SharedLight& light) {
    for (int i = 0; i < core::kMaxTools; ++i) {
        auto* tint = new Qt3DRender::QParameter(QStringLiteral("tint"), toTint(ringColour(i)), this);
        auto* material = light.effects.material("solid.vert", "signal.frag", {tint}, Blend::opaque, this);
        m_rings[i] = new Part(instrumentRings(i + 1), material, this);
        m_rings[i]->setEnabled(false);
    }
    auto* tint = new Qt3DRender::QParameter(QStringLiteral("tint"), QVector4D(1, 1, 1, 1), this);
    m_collar =
        new Part(instrumentCollar(),
                 light.effects.material("solid.vert", "signal.frag", {tint}, Blend::opaque, this), this);
    m_collar->setEnabled(false);
}

void Instrument::wear(int rings, bool collar) {
    for (int i = 0; i < core::kMaxTools && m_rings[i]; ++i)
        m_rings[i]->setEnabled(i + 1 == rings);
    if (m_collar)
        m_collar->setEnabled(collar);
}

void Instrument::setGhostColour(const QColor& colour) {
    if (m_ghost)
        m_tint->setValue(toTint(colour, 0.38F));
}

void Instrument::show(const ToolView& tool, bool leftHanded) {
    setEnabled(tool.present);
    if (!tool.present)
        return;
    m_pose->setTranslation(toMillimetres(drawnTip(tool)));
    m_pose->setRotation(toQuaternion(m_orientation.of(tool, leftHanded)));
    const float half_deg = qRadiansToDegrees(0.5F * float(tool.jaw_rad));
    for (int side = 0; side < 2; ++side) {
        QMatrix4x4 matrix;
        matrix.rotate(180.0F * float(side), 0.0F, 0.0F, 1.0F);
        matrix.translate(0.0F, 0.0F, float(kHinge_mm));
        matrix.rotate(half_deg, 1.0F, 0.0F,
                      0.0F); // the tip lies on −z of the hinge, so this turns it towards +y
        matrix.translate(0.0F, 0.0F, -float(kHinge_mm));
        m_jaw[side]->at().setMatrix(matrix);
    }
}

} // namespace chiron::scene3d
