// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/scene3d/abdomen/target_marks.h"

#include "desktop/scene3d/parts/loft.h"

#include <Qt3DRender/QLayer>
#include <algorithm>
#include <cmath>

namespace chiron::scene3d {

namespace {

constexpr double kUnit_mm = 10.0; // the radius for which the meshes are made

TriangleMesh stick(double radius_mm) {
    TriangleMesh mesh;
    addTurned(mesh, {{0.0, radius_mm}, {1.0, radius_mm}}, 0.0, 8);
    return mesh;
}

TriangleMesh disc() {
    TriangleMesh mesh;
    addTurned(mesh, {{-0.05, kUnit_mm}, {0.05, kUnit_mm}}, 0.0, 36);
    return mesh;
}

} // namespace

TargetRing::TargetRing(SharedLight& light, Qt3DCore::QNode* parent) : QEntity(parent) {
    const auto tint = [this] {
        return new Qt3DRender::QParameter(QStringLiteral("tint"), QVector4D(0, 0, 0, 1), this);
    };
    m_tint = tint();
    m_edgeTint = tint();
    m_fillTint = tint();
    auto* material = light.effects.material("solid.vert", "signal.frag", {m_tint}, Blend::opaque, this);
    auto* edge = light.effects.material("solid.vert", "signal.frag", {m_edgeTint}, Blend::opaque, this);
    auto* fill = light.effects.material("solid.vert", "signal.frag", {m_fillTint}, Blend::translucent, this);
    m_ring = new Part(ringMesh(kUnit_mm, 0.55), material, this);
    m_edge = new Part(ringMesh(kUnit_mm + 0.7, 0.32), edge, this);
    m_fill = new Part(disc(), fill, this);
    m_line = new Part(stick(0.3), material, this);
    for (Part*& tick : m_ticks)
        tick = new Part(stick(0.55), material, this);
    setEnabled(false);
}

void TargetRing::putTranslucent(Qt3DRender::QLayer* layer) {
    m_fill->addComponent(layer);
}

void TargetRing::change(const SceneSetup& setup) {
    m_tint->setValue(toTint(setup.colours.highContrast ? setup.colours.arrow : QColor(120, 236, 255)));
    m_edgeTint->setValue(QVector4D(0.04F, 0.05F, 0.06F, 1.0F));
    m_fillTint->setValue(
        toTint(setup.colours.highContrast ? setup.colours.arrow : QColor(120, 236, 255), 0.42F));
}

void TargetRing::show(const core::Vec3& p_W, const core::Vec3& along, double radius_m, bool foot,
                      double dwell) {
    setEnabled(true);
    const QVector3D at = toMillimetres(p_W);
    const QQuaternion turned = QQuaternion::rotationTo(QVector3D(0, 0, 1), toVector(along.normalized()));
    const float size = float(radius_m * 1e3 / kUnit_mm);
    for (Part* part : {m_ring, m_edge}) {
        part->at().setTranslation(at);
        part->at().setRotation(turned);
        part->at().setScale3D({size, size, 1.0F});
    }
    const float filled = float(std::sqrt(std::clamp(dwell, 0.0, 1.0)));
    m_fill->setEnabled(filled > 0.02F);
    m_fill->at().setTranslation(at);
    m_fill->at().setRotation(turned);
    m_fill->at().setScale3D({size * filled, size * filled, 1.0F});
    for (int i = 0; i < 4; ++i) { // short ticks inwards
        const QQuaternion outwards = turned * QQuaternion::fromAxisAndAngle(0, 0, 1, 90.0F * float(i)) *
                                     QQuaternion::rotationTo(QVector3D(0, 0, 1), QVector3D(-1, 0, 0));
        m_ticks[i]->at().setTranslation(at + turned *
                                                 QQuaternion::fromAxisAndAngle(0, 0, 1, 90.0F * float(i)) *
                                                 QVector3D(float(radius_m * 1e3), 0, 0));
        m_ticks[i]->at().setRotation(outwards);
        m_ticks[i]->at().setScale3D({1.0F, 1.0F, 2.4F});
    }
    const double high_mm = p_W.z() * 1e3 - radius_m * 1e3 * std::abs(1.0 - std::abs(along.normalized().z()));
    m_line->setEnabled(foot && high_mm > 2.0);
    m_line->at().setTranslation({at.x(), at.y(), 0.0F});
    m_line->at().setScale3D({1.0F, 1.0F, float(std::max(0.1, high_mm))});
}

} // namespace chiron::scene3d
