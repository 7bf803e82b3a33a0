// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/scene3d/plugin/force_arrow.h"

#include "desktop/scene3d/drawn_tool.h"
#include "desktop/scene3d/parts/loft.h"

#include <algorithm>

namespace chiron::scene3d {

namespace {

constexpr double kHead_mm = 8.0;

TriangleMesh stemMesh() {
    TriangleMesh mesh;
    addTurned(mesh, {{0.0, 1.0}, {1.0, 1.0}}, 0.0, 16);
    return mesh;
}

TriangleMesh headMesh() {
    TriangleMesh mesh;
    addTurned(mesh, {{0.0, 3.1}, {kHead_mm, 0.02}}, 0.0, 20);
    return mesh;
}

} // namespace

ForceArrow::ForceArrow(SharedLight& light, Qt3DCore::QNode* parent)
    : QEntity(parent), m_pose(new Qt3DCore::QTransform(this)),
      m_tint(new Qt3DRender::QParameter(QStringLiteral("tint"), QVector4D(0, 0, 0, 1), this)),
      m_lineTint(new Qt3DRender::QParameter(QStringLiteral("tint"), QVector4D(0, 0, 0, 1), this)) {
    addComponent(m_pose);
    auto* material = light.effects.material("solid.vert", "signal.frag", {m_tint}, Blend::opaque, this);
    auto* line = light.effects.material("solid.vert", "signal.frag", {m_lineTint}, Blend::opaque, this);
    m_stem = new Part(stemMesh(), material, this);
    m_head = new Part(headMesh(), material, this);
    m_way = new Part(stemMesh(), line, this);
    m_way->at().setScale3D({0.28F, 0.28F, float(kLimit_mm)});
    m_limit = new Part(ringMesh(5.2, 0.55), line, this);
    for (Part*& ring : m_rings)
        ring = new Part(ringMesh(3.2, 0.8), material, this);
    setEnabled(false);
}

void ForceArrow::change(const SceneSetup& setup) {
    m_setup = setup;
    m_lineTint->setValue(toTint(setup.colours.ink));
}

void ForceArrow::show(const ToolView& tool) {
    const double force_N = tool.force_N.norm();
    const bool drawn = m_setup.cues.arrow && tool.present && force_N > kLeast_N;
    setEnabled(drawn);
    if (!drawn)
        return;
    const double share = force_N / std::max(0.1, m_setup.forceLimit_N);
    const bool over = share > 1.0;
    const double length_mm = std::min(share, kLongest) * kLimit_mm;
    const double head = std::min(1.0, length_mm / (1.4 * kHead_mm)) * (over ? 1.35 : 1.0);
    const double stem_mm = length_mm - kHead_mm * head;
    const float thick = over ? 1.9F : 1.15F;
    m_tint->setValue(toTint(over ? m_setup.colours.over : m_setup.colours.arrow));
    m_pose->setTranslation(toMillimetres(drawnTip(tool)));
    m_pose->setRotation(QQuaternion::rotationTo(QVector3D(0, 0, 1), toVector(tool.force_N / force_N)));
    m_stem->at().setScale3D({thick, thick, float(std::max(0.05, stem_mm))});
    m_head->at().setTranslation({0.0F, 0.0F, float(stem_mm)});
    m_head->at().setScale(float(head));
    m_limit->at().setTranslation({0.0F, 0.0F, float(kLimit_mm)});
    for (int i = 0; i < 3; ++i) {
        m_rings[i]->setEnabled(over);
        m_rings[i]->at().setTranslation({0.0F, 0.0F, float(stem_mm * (0.35 + 0.2 * i))});
    }
}

} // namespace chiron::scene3d
